#include "core/decode/waterlinked.h"

#include <algorithm>
#include <cmath>

namespace leadline::decode {
namespace {

constexpr double kFastest_mps = 20.0, kFarthest_m = 1000.0, kWorst = 1e12;
constexpr std::int64_t kClose_ns = 10'000'000'000;
constexpr std::int64_t kEarliest_ns = 1'420'070'400'000'000'000;  // 2015: before there was any such device
constexpr double kLatest_us = 9e15;
constexpr std::uint32_t kHot = 1;
constexpr Angle kBeamAngle = Angle::deg(22.5);

/// One sigma of the horizontal velocity.
std::optional<double> sigma_mps(const WaterLinkedVelocity& r) {
  if (r.covariance_m2ps2) {
    const double variance = std::max((*r.covariance_m2ps2)[0], (*r.covariance_m2ps2)[4]);
    if (variance > 0.0) return std::sqrt(variance);
  }
  return r.fom_mps && *r.fom_mps > 0.0 ? r.fom_mps : std::nullopt;
}

bool in_range(const std::optional<double>& value, double least, double most) {
  return !value || (*value >= least && *value <= most);
}

std::string_view fault(const WaterLinkedVelocity& r) {
  for (const auto& v : r.mps) {
    if (!v && r.valid) return "fields";
    if (!in_range(v, -kFastest_mps, kFastest_mps)) return "range";
  }
  if (!in_range(r.altitude_m, -1.0, kFarthest_m) || !in_range(r.fom_mps, 0.0, kWorst)) return "range";
  if (!in_range(r.validity_us, 0.0, kLatest_us) || !in_range(r.transmission_us, 0.0, kLatest_us))
    return "range";
  if (r.range_m)
    for (const double range : *r.range_m)
      if (!in_range(range, 0.0, kFarthest_m)) return "range";
  return {};
}

}  // namespace

std::optional<Time> WaterLinkedFacts::instant(std::optional<double> us, std::optional<Arrival> arrival,
                                              DecoderOutput& out) {
  if (!us) return std::nullopt;
  const Time time{static_cast<std::int64_t>(std::llround(*us)) * 1000};
  const bool close = !arrival || std::abs(time.ns - arrival->ns) <= kClose_ns;
  if (close && !clock_unset_ && time.ns >= kEarliest_ns) return time;
  if (!clock_noted_) {
    clock_noted_ = true;
    out.fact(std::nullopt, Health{Health::Level::note,
                                  "the DVL's clock is not set (no time server): its times are not used, but "
                                  "arrival less latency_s"});
  }
  return std::nullopt;
}

void WaterLinkedFacts::tell_status(std::uint32_t status, DecoderOutput& out) {
  const bool hot = (status & kHot) != 0;
  if (hot && !hot_)
    out.fact(std::nullopt, Health{Health::Level::warning, "the DVL is too hot and may shut down"});
  hot_ = hot;
}

void WaterLinkedFacts::tell_ranges(const std::array<double, 4>& range_m, std::optional<Time> time,
                                   DecoderOutput& out) {
  out.fact(time, BeamRanges{range_m, kBeamAngle});
}

std::string_view WaterLinkedFacts::tell(std::string_view telegram, const WaterLinkedVelocity& r,
                                        std::optional<Arrival> arrival, DecoderOutput& out) {
  if (const auto reason = fault(r); !reason.empty()) return reason;
  tell_status(r.status, out);
  const auto time = last_time_ = instant(r.validity_us, arrival, out);
  if (time) {
    const auto sent = instant(r.transmission_us, arrival, out);
    out.fact(time, ClockReading{telegram, (sent ? *sent : *time).ns, {}});
  }
  if (r.valid && r.altitude_m && *r.altitude_m > 0.0) out.fact(time, AltitudeAboveBottom{*r.altitude_m});
  if (r.range_m) tell_ranges(*r.range_m, time, out);
  DvlVelocity v;
  v.reference = r.water ? DvlReference::water : DvlReference::bottom;
  v.valid = r.valid;
  if (r.valid) {
    v.x_mps = *r.mps[0], v.y_mps = *r.mps[1], v.z_mps = *r.mps[2];
    v.sd_mps = sigma_mps(r);
  }
  out.fact(time, v);
  return {};
}

std::string_view WaterLinkedFacts::tell(const WaterLinkedAttitude& r, std::optional<Arrival> arrival,
                                        DecoderOutput& out) {
  if (!r.roll_deg || !r.pitch_deg) return "fields";
  if (!in_range(r.roll_deg, -180.0, 180.0) || !in_range(r.pitch_deg, -90.0, 90.0) ||
      !in_range(r.time_s, 0.0, kLatest_us * 1e-6))
    return "range";
  if (r.status != 0) return {};
  const auto us = r.time_s ? std::optional(*r.time_s * 1e6) : std::nullopt;
  out.fact(instant(us, arrival, out),
           Attitude{Angle::deg(*r.roll_deg), Angle::deg(*r.pitch_deg), {}, {}, {}});
  return {};
}

}  // namespace leadline::decode
