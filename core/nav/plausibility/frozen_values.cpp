#include "core/nav/plausibility/frozen_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

namespace leadline::nav {
namespace {

constexpr std::int64_t kShortestNs = 5'000'000'000, kSlowNs = 1'050'000'000;
constexpr std::uint32_t kFewestSamples = 5, kFewestOfSlow = 10, kLearned = 16;
constexpr double kLeastDescent_m = 0.6, kLeastDescent_mps = 0.1;
constexpr double kLivelySteps = 3.0, kWitnessSteps = 8.0;
constexpr double kEarthRadius_m = 6.371e6;

bool finite(const std::array<double, 3>& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b, bool wraps) {
  const double first = wraps ? Angle::rad(a[0] - b[0]).wrapped_pi().rad() : a[0] - b[0];
  return std::hypot(first, a[1] - b[1], a[2] - b[2]);
}

}  // namespace

/// anchor: a change that counts as motion; floor: no finer resolution is believed; coarse: taken for the
/// resolution of a value that never changed; need: what others must have seen. All in the value's own units.
struct FrozenValues::Traits {
  const char* name;
  double anchor, floor, coarse, need;
  Dimension witness;  ///< what it witnesses, and what witnesses it
  bool wraps = false, clamps = false;
};
const std::array<FrozenValues::Traits, Findings::kQuantities> FrozenValues::kTraits{{
    {"position", 10.0, 0.01, 2.0, 10.0, travel},
    {"speed and course", 0.5, 0.001, 0.5, 0.0, none},
    {"heading", 5.0 * kRadPerDeg, 0.01 * kRadPerDeg, kRadPerDeg, 15.0 * kRadPerDeg, turn, true},
    {"roll and pitch", kRadPerDeg, 0.01 * kRadPerDeg, kRadPerDeg, 0.0, none},
    {"turn rate", kRadPerDeg, 0.001 * kRadPerDeg, kRadPerDeg, 0.0, none},
    {"inertial sample", 0.3, 1e-7, 0.01, 0.0, none},
    {"velocity over the bottom", 0.2, 0.001, 0.1, 0.0, none},
    {"velocity through the water", 0.2, 0.001, 0.1, 0.0, none},
    {"altitude", 1.0, 0.001, 0.1, 0.0, none, false, true},
    {"beam ranges", 1.0, 0.001, 0.1, 0.0, none, false, true},
    {"depth", 1.0, 0.001, 0.1, 2.0, sink, false, true},
    {"USBL position", 10.0, 0.001, 1.0, 0.0, none},
}};

FrozenValues::FrozenValues(std::span<const SourceInfo> sources, Findings& findings)
    : sources_(sources), findings_(findings), slots_(sources.size()), frozen_(sources.size()) {}

std::optional<FrozenValues::Sample> FrozenValues::sample_of(const Message& message) {
  if (const auto* m = std::get_if<GnssFix>(&message))
    return Sample{position,
                  {m->position.lat.rad() * kEarthRadius_m, m->position.lon.rad() * kEarthRadius_m, 0}};
  if (const auto* m = std::get_if<Course>(&message))
    return Sample{course, {m->speed_mps, m->course ? m->course->rad() * m->speed_mps : 0.0, 0}, m->speed_mps};
  if (const auto* m = std::get_if<Heading>(&message)) return Sample{heading, {m->heading.rad(), 0, 0}};
  if (const auto* m = std::get_if<Attitude>(&message))
    return Sample{tilts, {m->roll.rad(), m->pitch.rad(), 0}};
  if (const auto* m = std::get_if<Rates>(&message)) return Sample{turn_rate, {m->rate_z_rps, 0, 0}};
  if (const auto* m = std::get_if<ImuSample>(&message))
    return Sample{inertial, {m->accel.x + m->gyro.x, m->accel.y + m->gyro.y, m->accel.z + m->gyro.z}};
  if (const auto* m = std::get_if<DvlVelocity>(&message)) {
    if (!m->valid) return std::nullopt;
    return Sample{m->reference == DvlReference::bottom ? bottom_velocity : water_velocity,
                  {m->x_mps, m->y_mps, m->z_mps},
                  std::hypot(m->x_mps, m->y_mps)};
  }
  if (const auto* m = std::get_if<AltitudeAboveBottom>(&message))
    return Sample{altitude, {m->above_bottom_m, 0, 0}};
  if (const auto* m = std::get_if<BeamRanges>(&message))
    return Sample{ranges, {m->range_m[0] + m->range_m[3], m->range_m[1], m->range_m[2]}};
  if (const auto* m = std::get_if<DepthMeasured>(&message)) return Sample{depth, {m->depth.m, 0, 0}};
  if (const auto* m = std::get_if<UsblRelative>(&message))
    return Sample{usbl, {m->x_m, m->y_m, m->down_m.value_or(0.0)}};
  if (const auto* m = std::get_if<UsblGrid>(&message)) return Sample{usbl, {m->easting_m, m->northing_m, 0}};
  if (const auto* m = std::get_if<UsblGeographic>(&message))
    return Sample{usbl, {m->position.lat.rad() * kEarthRadius_m, m->position.lon.rad() * kEarthRadius_m, 0}};
  return std::nullopt;
}

void FrozenValues::take(const Envelope& envelope, EngineOutput& out) {
  if (envelope.source >= slots_.size()) return;
  const auto sample = sample_of(envelope.message);
  if (!sample || !finite(sample->value) || !std::isfinite(sample->speed_mps)) return;
  hear(envelope.source, *sample, envelope.arrival, out);
}

void FrozenValues::hear(SourceId source, const Sample& sample, Arrival now, EngineOutput& out) {
  Slot& slot = slots_[source][sample.quantity];
  if (!slot.heard) {
    slot.heard = true;
    slot.value = slot.before = slot.anchor = sample.value;
    slot.run_began = slot.last = now;
    slot.moved_at = {std::numeric_limits<std::int64_t>::min() / 2};
    slot.run_samples = 1;
    slot.witnessed_at_run = witnessed(slot, source, sample.quantity);
    slot.sunk_at_run_m = sunk_m_[static_cast<std::size_t>(sources_[source].body)];
    return;
  }
  move(slot, source, sample, now);
  if (sample.value == slot.value || sample.value == slot.before) {
    ++slot.run_samples;
    slot.lively <<= 1U;
    if (sample.value != slot.value) std::swap(slot.value, slot.before);
    if (!slot.frozen) judge(slot, source, sample, now, out);
  } else {
    step(slot, sample, now);
    slot.witnessed_at_run = witnessed(slot, source, sample.quantity);
    slot.sunk_at_run_m = sunk_m_[static_cast<std::size_t>(sources_[source].body)];
    if (slot.frozen && ++slot.changes >= 3) {
      slot.frozen = false;
      --frozen_[source];
      char text[120];
      std::snprintf(text, sizeof text, "its %s changes again", kTraits[sample.quantity].name);
      findings_.clear(source, Findings::frozen(sample.quantity), text, now, out);
    }
  }
  slot.last = now;
  slot.samples = std::min(slot.samples + 1, 64U);
}

/// What this sample says of the body's motion, to others.
void FrozenValues::move(Slot& slot, SourceId source, const Sample& sample, Arrival now) {
  const Traits& traits = kTraits[sample.quantity];
  const auto body = static_cast<std::size_t>(sources_[source].body);
  const auto add = [&](Dimension dimension, double amount) {
    slot.odometer += amount;
    witnessed_[body][dimension] += amount;
  };
  if (const double moved = distance(sample.value, slot.anchor, traits.wraps); moved >= traits.anchor) {
    slot.anchor = sample.value;
    slot.moved_at = now;
    if (traits.witness == turn || traits.witness == sink) add(traits.witness, moved);
  }
  const double dt_s = std::clamp(seconds(now - slot.last), 0.0, 3.0);
  const bool fast = (sample.quantity == course && sample.speed_mps >= 0.5) ||
                    (sample.quantity == bottom_velocity && sample.speed_mps >= 0.1);
  if (fast) {
    slot.moved_at = now;
    add(travel, sample.speed_mps * dt_s);
  } else if (sample.quantity == turn_rate && std::abs(sample.value[0]) >= kRadPerDeg) {
    slot.moved_at = now;
    add(turn, std::abs(sample.value[0]) * dt_s);
  }
}

/// A new value: its step teaches the resolution, its second difference how lively the quantity is.
void FrozenValues::step(Slot& slot, const Sample& sample, Arrival now) {
  const Traits& traits = kTraits[sample.quantity];
  bool lively = false;
  for (std::size_t i = 0; i < 3; ++i) {
    double difference = sample.value[i] - slot.value[i], earlier = slot.value[i] - slot.before[i];
    if (traits.wraps)
      difference = Angle::rad(difference).wrapped_pi().rad(),
      earlier = Angle::rad(earlier).wrapped_pi().rad();
    if (const double size = std::max(std::abs(difference), traits.floor); difference != 0.0)
      slot.quantum[i] = slot.quantum[i] > 0.0 ? std::min(slot.quantum[i], size) : size;
    lively |= slot.quantum[i] > 0.0 && std::abs(difference - earlier) >= kLivelySteps * slot.quantum[i];
  }
  if (!slot.frozen) slot.longest_run_ns = std::max(slot.longest_run_ns, (slot.last - slot.run_began).count());
  slot.lively = (slot.lively << 1U) | (lively ? 1U : 0U);
  slot.lively_at_run = static_cast<std::uint32_t>(std::popcount(slot.lively));
  slot.known_at_run = std::min(slot.samples + 1, 64U);
  slot.before = slot.value;
  slot.value = sample.value;
  slot.run_began = now;
  slot.run_samples = 1;
}

double FrozenValues::witnessed(const Slot& slot, SourceId source, Quantity quantity) const {
  const Dimension dimension = kTraits[quantity].witness;
  const double own = dimension == turn || dimension == sink ? slot.odometer : 0.0;
  return witnessed_[static_cast<std::size_t>(sources_[source].body)][dimension] - own;
}

/// Something else of the same body that moved during the run and still changes.
const FrozenValues::Slot* FrozenValues::mover(const Slot& slot, SourceId source, std::size_t& which,
                                              SourceId& who) const {
  for (who = 0; who < slots_.size(); ++who) {
    if (sources_[who].body != sources_[source].body) continue;
    for (which = 0; which < slots_[who].size(); ++which) {
      const Slot& other = slots_[who][which];
      if (&other != &slot && other.heard && !other.frozen && other.moved_at >= slot.run_began &&
          other.run_began > slot.run_began)
        return &other;
    }
  }
  return nullptr;
}

void FrozenValues::judge(Slot& slot, SourceId source, const Sample& sample, Arrival now, EngineOutput& out) {
  const std::int64_t run_ns = (now - slot.run_began).count();
  const bool slow = run_ns > slot.run_samples * kSlowNs;
  if (run_ns < kShortestNs || slot.run_samples < (slow ? kFewestOfSlow : kFewestSamples)) return;
  const Traits& traits = kTraits[sample.quantity];
  char text[200];
  const double quantum = *std::max_element(slot.quantum.begin(), slot.quantum.end());
  if (traits.witness != none) {
    const double seen = witnessed(slot, source, sample.quantity) - slot.witnessed_at_run;
    if (seen >= std::max(traits.need, kWitnessSteps * (quantum > 0.0 ? quantum : traits.coarse))) {
      const bool angle = traits.witness == turn;
      std::snprintf(
          text, sizeof text,
          "its %s is frozen: the same for %.1f s (%u telegrams) while other instruments saw %.0f %s of %s; "
          "check or restart it",
          traits.name, 1e-9 * static_cast<double>(run_ns), slot.run_samples, angle ? seen * kDegPerRad : seen,
          angle ? "deg" : "m",
          angle                    ? "turning"
          : traits.witness == sink ? "diving"
                                   : "way");
      slot.frozen = true;
    }
  }
  if (const double sunk_m = sunk_m_[static_cast<std::size_t>(sources_[source].body)] - slot.sunk_at_run_m;
      !slot.frozen && sample.quantity == depth && sample.value[0] > 2.0 &&
      std::abs(sunk_m) >= std::max({kLeastDescent_m, 5.0 * (quantum > 0.0 ? quantum : traits.coarse),
                                    kLeastDescent_mps * 1e-9 * static_cast<double>(run_ns)})) {
    std::snprintf(text, sizeof text,
                  "its depth is frozen: the same for %.1f s (%u telegrams) while the DVL went %.1f m %s; "
                  "check or restart it",
                  1e-9 * static_cast<double>(run_ns), slot.run_samples, std::abs(sunk_m),
                  sunk_m > 0.0 ? "down" : "up");
    slot.frozen = true;
  }
  const bool clamped = traits.clamps && sample.value == Values{};
  const bool was_lively = slot.known_at_run >= kLearned && 5 * slot.lively_at_run >= 3 * slot.known_at_run;
  if (!slot.frozen && was_lively && !clamped && run_ns >= 3 * slot.longest_run_ns) {
    std::size_t which = 0;
    SourceId who = 0;
    if (mover(slot, source, which, who) == nullptr) return;
    std::snprintf(
        text, sizeof text,
        "its %s is frozen: the same for %.1f s (%u telegrams), before it never stood longer than %.1f s, and "
        "the %s of %.24s moves; check or restart it",
        traits.name, 1e-9 * static_cast<double>(run_ns), slot.run_samples,
        1e-9 * static_cast<double>(slot.longest_run_ns), kTraits[which].name, sources_[who].name.c_str());
    slot.frozen = true;
  }
  if (!slot.frozen) return;
  slot.changes = 0;
  ++frozen_[source];
  findings_.raise(source, Findings::frozen(sample.quantity), text, now, out);
}

}  // namespace leadline::nav
