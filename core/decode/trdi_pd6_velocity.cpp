#include "core/decode/trdi_pd6_velocity.h"

#include <cmath>

namespace leadline::decode {
namespace {

constexpr double kSameSize_mmps = 5.0;
constexpr double kSameUp_mmps = 2.0;  ///< two roundings

using Lines = std::array<std::optional<Pd6Velocity>, 3>;

bool filled(const std::optional<Pd6Velocity>& v) { return v && v->good && !v->blank(); }

/// Does every other line that is filled say the same speed?
bool consistent(const Lines& lines, std::size_t chosen) {
  for (std::size_t i = chosen + 1; i < lines.size(); ++i)
    if (filled(lines[i]) && std::abs(lines[i]->size_mmps() - lines[chosen]->size_mmps()) > kSameSize_mmps)
      return false;
  return true;
}

DvlVelocity velocity_of(const Lines& lines, std::size_t chosen, DvlReference reference, const Pd6Ping& ping,
                        const Pd6Axes& axes, const DecoderSettings& settings) {
  DvlVelocity velocity;
  velocity.reference = reference;
  velocity.frame = chosen == 0 ? DvlFrame::instrument : chosen == 1 ? DvlFrame::ship : DvlFrame::earth;
  if (chosen == 1)
    velocity.tilt_applied =
        !filled(lines[2]) || std::abs(lines[2]->mmps[2] - lines[1]->mmps[2]) <= kSameUp_mmps;
  if (chosen == 2) {
    velocity.tilt_applied = true;
    velocity.applied = pd6_attitude(ping, settings);
  }
  const Pd6Velocity& v = *lines[chosen];
  if (!v.good) return velocity;
  velocity.valid = true;
  const std::array<double, 3> mps{v.mmps[0] * 1e-3, v.mmps[1] * 1e-3, v.mmps[2] * 1e-3};
  if (chosen == 0 && axes.forward_first())
    velocity.x_mps = mps[0], velocity.y_mps = mps[1], velocity.z_mps = mps[2];
  else
    velocity.x_mps = mps[1], velocity.y_mps = mps[0], velocity.z_mps = 0.0 - mps[2];
  if (v.error_mmps) velocity.error_mps = *v.error_mmps * 1e-3;
  return velocity;
}

}  // namespace

void Pd6Axes::observe(const Pd6Ping& ping) {
  const auto &i = ping.bottom[0], &s = ping.bottom[1];
  if (!filled(i) || !filled(s) || turned_ || named_) return;
  const auto& x = i->mmps;
  if (x[0] == x[1] && s->mmps == x) return;  // says nothing
  if (s->mmps == std::array<double, 3>{x[1], x[0], x[2]})
    exchanged_ = true;
  else
    turned_ = true;
}

std::optional<DvlVelocity::Applied> pd6_attitude(const Pd6Ping& ping, const DecoderSettings& settings) {
  if (!ping.attitude) return std::nullopt;
  const auto& a = *ping.attitude;
  if (a.pitch_deg == 0.0 && a.roll_deg == 0.0 && a.heading_deg == 0.0) return std::nullopt;
  return DvlVelocity::Applied{
      Angle::deg(a.heading_deg == 360.0 ? 0.0 : a.heading_deg), Angle::deg(a.roll_deg),
      Angle::deg(a.pitch_deg),
      settings.heading_magnetic ? HeadingReference::magnetic_north : HeadingReference::true_north};
}

Pd6Choice pd6_bottom_velocity(const Pd6Ping& ping, const Pd6Axes& axes, const DecoderSettings& settings) {
  for (std::size_t i = 0; i < ping.bottom.size(); ++i) {
    if (!ping.bottom[i]) continue;
    if (ping.bottom[i]->good && !consistent(ping.bottom, i)) return {Pd6Verdict::inconsistent, i, {}};
    return {Pd6Verdict::told, i, velocity_of(ping.bottom, i, DvlReference::bottom, ping, axes, settings)};
  }
  return {};
}

Pd6Choice pd6_water_velocity(const Pd6Ping& ping, const Pd6Axes& axes, const DecoderSettings& settings) {
  for (std::size_t i = 0; i < ping.water.size(); ++i) {
    if (!ping.water[i]) continue;
    if (!filled(ping.water[i])) return {};
    if (!consistent(ping.water, i)) return {Pd6Verdict::inconsistent, i, {}};
    return {Pd6Verdict::told, i, velocity_of(ping.water, i, DvlReference::water, ping, axes, settings)};
  }
  return {};
}

}  // namespace leadline::decode
