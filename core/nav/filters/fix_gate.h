#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace leadline::nav {

/// What a horizontal filter did with one position fix. gamma is the fix's 2-D RMS error (DRMS) throughout.
struct FixResult {
  bool accepted = false;    ///< the fix was used: it passed the gate, or it completed a re-acquisition
  bool reacquired = false;  ///< the position was set anew from rejected fixes that agree (then accepted too)
  double gate_m = 0.0;      ///< radius of the gate along the residual, as it stood before the fix
  Eigen::Vector2d step = Eigen::Vector2d::Zero();  ///< north, east metres to add to the position
  int agreeing = 0;                                ///< re-acquisition: how many fixes agreed
  double agreeing_over_s = 0.0;                    ///< re-acquisition: from the oldest of them to this one
};

/// How far dead reckoning may have strayed since the last accepted fix: 1 % of the way plus 2 mm/s.
struct DriftSinceFix {
  double since_s = 0.0;
  double distance_m = 0.0;

  void grow(double speed_mps, double dt_s) {
    since_s += dt_s;
    distance_m += speed_mps * dt_s;
  }
  [[nodiscard]] double sd_m() const { return 0.01 * distance_m + 0.002 * since_s; }
  /// 3 sqrt(gamma^2 + sd^2). Kim 2010 eq. 4 has 3 gamma alone, which locks the fixes out for ever once dead
  /// reckoning has drifted that far.
  /// declared_sd_m: what the configuration says it may have strayed, 2-D; the larger of the two counts.
  [[nodiscard]] double gate_m(double gamma_m, double declared_sd_m = 0.0) const;
};

/// The latest rejected fixes, at most 18, kept as e = fix minus dead reckoning, which stands still while
/// the vehicle moves: fixes that are right agree in e, false ones as a rule do not.
class RejectedFixes {
 public:
  struct Agreement {
    Eigen::Vector2d e;  ///< mean of those that agree
    double variance;    ///< per axis, of that mean as if they were independent, m^2
    int count;
    double span_s;
  };

  void push(double t_s, const Eigen::Vector2d& e, double gamma_m);
  void clear() { size_ = 0; }
  [[nodiscard]] int size() const { return size_; }

  /// For n in (5, 15): of the last n + 3, those within 2 gamma (each its own) of the median by component are
  /// good; at least n must be, and the newest two among them. For n = 5 the jump |mean - correction| must
  /// also be believable: at most 3 gamma + 0.05 (distance + since); a cluster of false fixes is not, and
  /// has to last for 15. `correction`: where the filter stands now, in e.
  [[nodiscard]] std::optional<Agreement> agreement(const Eigen::Vector2d& correction,
                                                   const DriftSinceFix& drift) const;

 private:
  static constexpr int kShort = 5, kLong = 15, kSpare = 3, kKept = kLong + kSpare;
  struct Entry {
    double t_s;
    Eigen::Vector2d e;
    double gamma_m;
  };
  [[nodiscard]] std::optional<Agreement> agreement_of(int n) const;

  std::array<Entry, kKept> entries_{};  // oldest first
  int size_ = 0;
};

}  // namespace leadline::nav
