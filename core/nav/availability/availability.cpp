#include "core/nav/availability/availability.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/types/expect.h"

namespace leadline::nav {
namespace {

constexpr double kGnssShortest_s = 3.0;
constexpr double kDvlShortest_s = 1.0;
constexpr double kUsblUnknownPeriod_s = 10.0;
constexpr double kMedians = 3.0;
constexpr double kUsblDropMedians = 5.0;

double medians_s(const Intervals& intervals, double count) {
  const auto median = intervals.median();
  return median ? count * seconds(*median) : 0.0;
}

}  // namespace

Availability::Availability(double highest_above_bottom_m) : highest_above_bottom_m_(highest_above_bottom_m) {
  LL_EXPECT(highest_above_bottom_m > 0.0);
}

void Availability::gnss_fix(Time valid) { gnss_.event(valid); }

void Availability::usbl_fix(Time valid, bool gate_passed) {
  if (usbl_.event(valid) && gate_passed) usbl_passed_ = valid;
}

void Availability::dvl_ping(Time valid, bool lock, std::optional<double> above_bottom_m) {
  if (!dvl_.event(valid)) return;
  pings_[next_ping_] = {lock, above_bottom_m};
  next_ping_ = (next_ping_ + 1) % kPings;
  pings_known_ = std::min(pings_known_ + 1, kPings);
}

void Availability::tick(Time now) {
  now_ = now_ ? std::max(*now_, now) : now;
  now_ok_ = {surfaced_ && gnss_alive(), usbl_alive(), pings_alive() && good_pings() >= kGoodPings};
}

std::optional<Availability::Change> Availability::evaluate(Time now) {
  tick(now);
  const Mode from = mode_;
  mode_ = mode_of(now_ok_);
  std::optional<Change> change;
  if (mode_ != from) change = Change{from, mode_, reason()};
  evaluated_ok_ = now_ok_;
  ever_ok_ = {ever_ok_.gnss || now_ok_.gnss, ever_ok_.usbl || now_ok_.usbl, ever_ok_.dvl || now_ok_.dvl};
  return change;
}

Mode Availability::mode_of(const Inputs& ok) {
  if (ok.gnss) return ok.dvl ? Mode::A : Mode::C;
  if (ok.usbl) return ok.dvl ? Mode::B : Mode::D;
  return ok.dvl ? Mode::E1 : Mode::E0;
}

double Availability::age_s(std::optional<Time> last) const {
  if (!last || !now_) return std::numeric_limits<double>::infinity();
  return seconds(*now_ - *last);
}

bool Availability::gnss_alive() const {
  return age_s(gnss_.last()) < std::max(kGnssShortest_s, medians_s(gnss_, kMedians));
}

bool Availability::usbl_alive() const {
  const double age = age_s(usbl_passed_);
  const bool period_known = usbl_.median().has_value();
  if (now_ok_.usbl) return age <= (period_known ? medians_s(usbl_, kUsblDropMedians) : kUsblUnknownPeriod_s);
  return age < (period_known ? medians_s(usbl_, kMedians) : kUsblUnknownPeriod_s);
}

bool Availability::pings_alive() const {
  return age_s(dvl_.last()) <= std::max(kDvlShortest_s, medians_s(dvl_, kMedians));
}

bool Availability::too_high(const Ping& ping) const {
  return ping.above_bottom_m && !(*ping.above_bottom_m <= highest_above_bottom_m_);
}

std::size_t Availability::locked_pings() const {
  return static_cast<std::size_t>(
      std::count_if(pings_.begin(), pings_.end(), [](const Ping& ping) { return ping.lock; }));
}

std::size_t Availability::good_pings() const {
  return static_cast<std::size_t>(std::count_if(
      pings_.begin(), pings_.end(), [this](const Ping& ping) { return ping.lock && !too_high(ping); }));
}

Text<100> Availability::reason() const {
  char line[256] = "";
  std::size_t used = 0;
  const auto add = [&](const Text<100>& part) {
    const int size = std::snprintf(line + used, sizeof line - used, "%s%.*s", used > 0 ? "; " : "",
                                   static_cast<int>(part.view().size()), part.view().data());
    used = std::min(sizeof line - 1, used + static_cast<std::size_t>(std::max(size, 0)));
  };
  if (now_ok_.gnss != evaluated_ok_.gnss) add(gnss_reason());
  if (now_ok_.usbl != evaluated_ok_.usbl) add(usbl_reason());
  if (now_ok_.dvl != evaluated_ok_.dvl) add(dvl_reason());
  return std::string_view(line, used);
}

Text<100> Availability::gnss_reason() const {
  if (now_ok_.gnss) return ever_ok_.gnss ? "GNSS back" : "GNSS acquired";
  if (!surfaced_) return "GNSS lost: below the surface";
  char line[101];
  std::snprintf(line, sizeof line, "GNSS lost: no fix for %.0f s", age_s(gnss_.last()));
  return line;
}

Text<100> Availability::usbl_reason() const {
  if (now_ok_.usbl) return ever_ok_.usbl ? "USBL back" : "USBL acquired";
  char line[101];
  const char* what = usbl_.last() == usbl_passed_ ? "no fix" : "no fix passed the gate";
  std::snprintf(line, sizeof line, "USBL lost: %s for %.0f s", what, age_s(usbl_passed_));
  return line;
}

Text<100> Availability::dvl_reason() const {
  if (now_ok_.dvl) return ever_ok_.dvl ? "bottom lock back" : "bottom lock acquired";
  char line[101];
  const std::size_t locked = locked_pings();
  if (!pings_alive()) {
    std::snprintf(line, sizeof line, "bottom lock lost: no DVL ping for %.0f s", age_s(dvl_.last()));
  } else if (locked < kGoodPings) {
    std::snprintf(line, sizeof line, "bottom lock lost: %zu of the last %zu pings", locked, pings_known_);
  } else {
    double highest_m = 0.0;
    for (const Ping& ping : pings_)
      if (too_high(ping)) highest_m = std::max(highest_m, *ping.above_bottom_m);
    std::snprintf(line, sizeof line, "bottom %.0f m below the DVL, limit %.0f m", std::ceil(highest_m),
                  highest_above_bottom_m_);
  }
  return line;
}

}  // namespace leadline::nav
