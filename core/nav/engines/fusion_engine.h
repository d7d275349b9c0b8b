#pragma once

#include <optional>
#include <vector>

#include "core/nav/engines/dead_reckoning_engine.h"
#include "core/nav/engines/reckoning_filter.h"
#include "core/nav/filters/constant_velocity.h"

namespace leadline::nav {

/// One position from dead reckoning and fixes. With bottom lock (A, B, E1) the DVL moves the position and
/// the filter of [navigation.fusion] corrects it; without (C, D) a constant-velocity Kalman filter does both;
/// with nothing (E0) the position is held, or moved by the velocity through the water with the current's
/// sigma. A change of state keeps position, covariance and what is known of the DVL's misalignment. A late
/// fix is compared with the position at its own time and corrects the present. Stated covariance: the
/// filter's own, and what dead reckoning may have grown by since the last accepted fix through what is no
/// state of the filter (the heading sensor, bridged gaps, the current).
///
/// Fixes: GNSS wins over USBL while it is alive. Of several GNSS the first of the configuration that is alive
/// is used; another one serves in its place unless it was seen to disagree with it by more than its gate:
/// that is said when it is found, and with its figures when the first one ends.
class FusionEngine final : public Engine {
 public:
  explicit FusionEngine(const EngineSetup& setup);
  void take(const Envelope& envelope, EngineOutput& out) override;

 private:
  enum class Propagation { reckoning, constant_velocity };
  /// How a source that is not used compares with the position while both are there.
  struct Rival {
    int compared = 0;
    Eigen::Vector2d residuals = Eigen::Vector2d::Zero();  // their sum: north, east
    double squares_m2 = 0.0;
    double off_bow_deg = 0.0;  // which way the mean lies
    bool disagrees = false, told = false;
  };

  void start(Time t, const Geodetic& position, const Eigen::Matrix2d& P);
  void on_ping(const Motion::Ping& ping, EngineOutput& out);
  void on_fix(const PositionFix& fix, EngineOutput& out);
  void evaluate(Time now, EngineOutput& out);
  void propagate_with(Propagation propagation, Time now);
  bool used(const PositionFix& fix);
  void compare(const PositionFix& fix, const Eigen::Vector2d& residual, double gate_m, EngineOutput& out);
  void tell_comparisons(Time now, EngineOutput& out);
  [[nodiscard]] FixResult update(const PositionFix& fix, const Eigen::Vector2d& residual);
  void align(const PositionFix& fix, const Geodetic& reference, const Eigen::Vector2d& dr_residual,
             EngineOutput& out);
  [[nodiscard]] Eigen::Matrix2d covariance() const;
  void publish_row(Time t, EngineOutput& out);

  EngineSetup setup_;
  Motion motion_;
  PositionFixes fixes_;
  Availability availability_;
  RowPace pace_;
  ReckoningFilter filter_;
  ConstantVelocity constant_velocity_;
  Propagation propagation_ = Propagation::reckoning;
  Preferred gnss_;
  std::vector<Rival> rivals_;
  PositionSource position_source_ = PositionSource::none;
  Time reckoned_until_;           // by the filter's predict()
  Geodetic origin_;               // of the alignment's pairs
  Time epoch_;                    // start of the filters' time scale
  std::optional<Course> course_;  // over ground, to start the constant-velocity filter with
  Time course_at_;
  Eigen::Vector2d corrections_ = Eigen::Vector2d::Zero();  // position minus pure dead reckoning
  bool pure_reckoning_ = true;  // nothing but the DVL has moved the position since the start
};

}  // namespace leadline::nav
