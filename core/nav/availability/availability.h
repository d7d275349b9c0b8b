#pragma once

#include <array>
#include <optional>

#include "core/messages/navigation.h"
#include "core/nav/availability/intervals.h"
#include "core/types/text.h"
#include "core/types/time.h"

namespace leadline::nav {

/// Which sources a vehicle's navigation can lean on: Kim 2010 table 1 as corrected (GNSS wins over USBL at
/// the surface; E is split into E1, dead reckoning, and E0, nothing). It only watches: a change of mode
/// leaves an engine's position and covariance alone.
///
/// GNSS: the last fix is younger than max(3 s, 3 median intervals), at the surface. USBL: gained when the
/// last fix that passed the gate is younger than 3 median periods, dropped after 5; 10 s both before a
/// period is known. Bottom lock: 3 good ones among the last 5 pings (locked, and no higher than the limit
/// when the altitude is known), the last not older than max(1 s, 3 median intervals).
/// All times on one clock; an event not later than the last of its kind is ignored. No allocation.
class Availability {
 public:
  struct Change {
    Mode from, to;
    Text<100> reason;  ///< in the operator's words: "GNSS lost: no fix for 31 s"
  };

  static constexpr double kHighestAboveBottom_m = 110.0;
  explicit Availability(double highest_above_bottom_m = kHighestAboveBottom_m);

  void gnss_fix(Time valid);                    ///< a valid fix
  void usbl_fix(Time valid, bool gate_passed);  ///< any fix; only those that passed the gate keep USBL alive
  void dvl_ping(Time valid, bool lock, std::optional<double> above_bottom_m);
  void surfaced(bool at_surface) { surfaced_ = at_surface; }  ///< true until told otherwise

  /// Lets time pass; a time before the last one counts as the last one.
  void tick(Time now);
  /// tick(), then the change of mode since the last evaluation, if any. Call after events and on Ticks.
  std::optional<Change> evaluate(Time now);

  /// As of the last evaluation; E0 before the first.
  [[nodiscard]] Mode mode() const { return mode_; }
  // As of the last tick or evaluation.
  [[nodiscard]] bool gnss_ok() const { return now_ok_.gnss; }
  [[nodiscard]] bool usbl_ok() const { return now_ok_.usbl; }
  [[nodiscard]] bool dvl_ok() const { return now_ok_.dvl; }

 private:
  struct Inputs {
    bool gnss = false, usbl = false, dvl = false;
  };
  struct Ping {
    bool lock = false;
    std::optional<double> above_bottom_m;
  };
  static constexpr std::size_t kPings = 5, kGoodPings = 3;

  [[nodiscard]] static Mode mode_of(const Inputs& ok);
  [[nodiscard]] double age_s(std::optional<Time> last) const;
  [[nodiscard]] bool gnss_alive() const;
  [[nodiscard]] bool usbl_alive() const;
  [[nodiscard]] bool pings_alive() const;
  [[nodiscard]] bool too_high(const Ping& ping) const;
  [[nodiscard]] std::size_t locked_pings() const;
  [[nodiscard]] std::size_t good_pings() const;
  [[nodiscard]] Text<100> reason() const;
  [[nodiscard]] Text<100> gnss_reason() const;
  [[nodiscard]] Text<100> usbl_reason() const;
  [[nodiscard]] Text<100> dvl_reason() const;

  double highest_above_bottom_m_;
  bool surfaced_ = true;
  Intervals gnss_, usbl_, dvl_;
  std::optional<Time> usbl_passed_;
  std::array<Ping, kPings> pings_{};
  std::size_t pings_known_ = 0, next_ping_ = 0;
  std::optional<Time> now_;
  Inputs now_ok_, evaluated_ok_, ever_ok_;
  Mode mode_ = Mode::E0;
};

}  // namespace leadline::nav
