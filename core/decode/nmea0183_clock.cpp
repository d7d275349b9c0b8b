#include "core/decode/nmea0183_clock.h"

#include <cmath>
#include <cstdlib>

#include "core/decode/nmea0183_sentences.h"

namespace leadline::decode::nmea0183 {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::int64_t kNsPerDay = 86'400 * kNsPerSecond;
constexpr std::int64_t kRollover = 1024 * 7 * kNsPerDay;
constexpr int kYearWithoutHost = 2030;  // 1980..2079

std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace

std::optional<Time> Dating::instant(std::int64_t time_of_day_ns, std::optional<Arrival> arrival) {
  std::optional<Time> reference;
  if (arrival) {
    const bool fresh = learnt_ && std::abs((*arrival - learnt_->arrival).count()) <= kFresh;
    reference = fresh ? learnt_->time : arrival->host();
  } else {
    reference = last_ ? last_ : host_;
  }
  if (!reference) return std::nullopt;
  const std::int64_t days = floor_div(reference->ns - time_of_day_ns + kNsPerDay / 2, kNsPerDay);
  last_ = Time{days * kNsPerDay + time_of_day_ns};
  return last_;
}

bool Dating::learn(Time full, std::optional<Arrival> arrival) {
  if (arrival) {
    const std::int64_t off = full.ns - arrival->ns;
    const std::int64_t weeks1024 = floor_div(off + kRollover / 2, kRollover);
    if (weeks1024 != 0 && std::abs(weeks1024) <= 2 && std::abs(off - weeks1024 * kRollover) <= kNsPerDay)
      return false;
    learnt_ = {full, *arrival};
  }
  last_ = full;
  return true;
}

int Dating::full_year(int two_digits, std::optional<Arrival> arrival) const {
  const int host = arrival ? to_civil(arrival->host()).year
                   : host_ ? to_civil(*host_).year
                           : kYearWithoutHost;
  const int lowest = host - 50;
  return lowest + ((two_digits - lowest) % 100 + 100) % 100;
}

std::optional<Time> Reading::dated(std::optional<std::int64_t> time_of_day_ns) {
  if (!time_of_day_ns) return std::nullopt;
  const auto instant = memory.dating.instant(*time_of_day_ns, arrival);
  memory.moment = arrival ? arrival->ns : instant ? instant->ns : *time_of_day_ns;
  return instant;
}

std::optional<Time> Reading::learn(std::string_view telegram, Time full) {
  memory.moment = arrival ? arrival->ns : full.ns;
  if (memory.dating.learn(full, arrival)) {
    tell_clock(telegram, full);
    return full;
  }
  if (!memory.rollover_told) {
    memory.rollover_told = true;
    out.fact(std::nullopt,
             Health{Health::Level::warning,
                    "GPS week rollover suspected: the device's date is a multiple of 1024 weeks from "
                    "the host's; the host's time is used instead"});
  }
  return std::nullopt;
}

void Reading::tell_clock(std::string_view telegram, std::optional<Time> instant) {
  if (instant) out.fact(instant, ClockReading{telegram, instant->ns, {}});
}

Verdict read_zda(Fields& f, Reading& r) {
  f.require(4);
  const auto utc = f.time_of_day(1);
  const auto day = f.digits(2, 31), month = f.digits(3, 12), year = f.digits(4, 9999);
  if (year && f.text(4).size() != 4) f.refuse(kReasonFields);
  if (!f.refusal().empty()) return refused(f.refusal());
  if (!utc || !day || !month || !year) return decoded();
  const auto midnight = from_civil(
      {.year = static_cast<int>(*year), .month = static_cast<int>(*month), .day = static_cast<int>(*day)});
  if (!midnight) return refused(kReasonRange);
  r.learn("ZDA", *midnight + Duration(*utc) + duration(r.profile.zda_offset_s));
  return decoded();
}

}  // namespace leadline::decode::nmea0183
