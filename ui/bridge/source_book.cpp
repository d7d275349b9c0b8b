#include "ui/bridge/source_book.h"

#include <algorithm>
#include <bitset>
#include <cmath>

namespace leadline::ui {
namespace {

constexpr double kAliveS = 3.0, kAlivePeriods = 3.0, kSilentPeriods = 5.0;

}  // namespace

const SourceBook::Spoken* SourceBook::spoken(Quantity quantity) const {
  const Spoken& spoken = spoken_[static_cast<std::size_t>(quantity)];
  return spoken.pulse.last() ? &spoken : nullptr;
}

bool SourceBook::alive(Quantity quantity, Arrival now) const {
  const Spoken* s = spoken(quantity);
  return s != nullptr && seconds(now - s->heard) <= std::max(kAliveS, kAlivePeriods * s->pulse.period_s());
}

void SourceBook::set_counts(std::uint64_t frames, std::uint64_t refused) {
  frames_ = frames;
  refused_ = refused;
}

void SourceBook::judged(bool accepted) {
  fixes_ = static_cast<std::uint8_t>(std::min(fixes_ + 1, kFixes));
  refused_fixes_ = static_cast<std::uint8_t>(refused_fixes_ << 1 | (accepted ? 0 : 1));
}

void SourceBook::fact(Quantity quantity, const Envelope& envelope, double value) {
  Spoken& spoken = spoken_[static_cast<std::size_t>(quantity)];
  spoken.pulse.beat(believable(envelope.valid, envelope.arrival));
  spoken.heard = envelope.arrival;
  spoken.value = value;
}

void SourceBook::sigma(std::optional<double> value, const char* unit) {
  if (!value || !std::isfinite(*value) || *value <= 0.0) return;
  sigma_ = value;
  sigma_unit_ = unit;
}

void SourceBook::take(const Envelope& envelope, bool frames_kept) {
  const auto on = [&](const auto& m) {
    using M = std::decay_t<decltype(m)>;
    const auto degrees = [](std::optional<Angle> angle) {
      return angle ? std::optional(angle->deg()) : std::nullopt;
    };
    if constexpr (std::is_same_v<M, RawFrame>) {
      if (!frames_kept) return;
    } else if constexpr (std::is_same_v<M, Rejected>) {
      ++refused_;
      refusal_ = m.reason;
    } else if constexpr (std::is_same_v<M, GnssFix>) {
      fact(Quantity::position, envelope);
      if (m.sd_north_m && m.sd_east_m) sigma(std::hypot(*m.sd_north_m, *m.sd_east_m), "m");
      if (m.satellites) satellites_ = *m.satellites;
    } else if constexpr (std::is_same_v<M, Course>) {
      fact(Quantity::course, envelope);
    } else if constexpr (std::is_same_v<M, Heading>) {
      fact(Quantity::heading, envelope);
      sigma(degrees(m.sd), "°");
    } else if constexpr (std::is_same_v<M, Attitude>) {
      fact(Quantity::attitude, envelope);
      sigma(degrees(m.sd_roll), "°");
    } else if constexpr (std::is_same_v<M, DvlVelocity>) {
      if (!m.valid) return;
      fact(m.reference == DvlReference::bottom ? Quantity::bottom_velocity : Quantity::water_velocity,
           envelope);
      sigma(m.sd_mps, "m/s");
    } else if constexpr (std::is_same_v<M, BeamRanges>) {
      beams_ =
          static_cast<int>(std::count_if(m.range_m.begin(), m.range_m.end(), [](double r) { return r > 0; }));
    } else if constexpr (std::is_same_v<M, AltitudeAboveBottom>) {
      fact(Quantity::altitude, envelope, m.above_bottom_m);
    } else if constexpr (std::is_same_v<M, BottomDepth>) {
      if (m.below != BottomDepth::Below::surface) fact(Quantity::bottom_depth, envelope, m.depth_m);
    } else if constexpr (std::is_same_v<M, DepthMeasured>) {
      fact(Quantity::depth, envelope);
      sigma(m.sd_m, "m");
    } else if constexpr (std::is_same_v<M, Pressure>) {
      fact(Quantity::pressure, envelope);
    } else if constexpr (std::is_same_v<M, UsblRelative> || std::is_same_v<M, UsblGeographic> ||
                         std::is_same_v<M, UsblGrid>) {
      fact(Quantity::position, envelope);
      usbl_ = true;
      sigma(m.sd_m, "m");
    } else if constexpr (std::is_same_v<M, Rates> || std::is_same_v<M, ImuSample> ||
                         std::is_same_v<M, SoundSpeed>) {
      fact(Quantity::other, envelope);
    } else {
      return;  // what engines say of this source is no word of its own
    }
    if constexpr (!std::is_same_v<M, RawFrame> && !std::is_same_v<M, Rejected>)
      latency_ = Duration(static_cast<std::int64_t>(static_cast<std::uint64_t>(envelope.arrival.ns) -
                                                    static_cast<std::uint64_t>(envelope.valid.ns)));
    // A replay of a session into itself keeps no frames of its own: each instant that gave facts was one.
    if (frames_kept ? !std::is_same_v<M, RawFrame> : last_ == envelope.arrival) return;
    ++frames_;
    recent_.add(envelope.arrival);
    frames_pulse_.beat(envelope.arrival.host());
    last_ = envelope.arrival;
  };
  std::visit(on, envelope.message);
}

double SourceBook::period_s() const {
  double shortest_s = 0.0;
  for (const Spoken& spoken : spoken_) {
    const double period_s = spoken.pulse.period_s();
    if (period_s > 0.0 && (shortest_s == 0.0 || period_s < shortest_s)) shortest_s = period_s;
  }
  return shortest_s > 0.0 ? shortest_s : frames_pulse_.period_s();
}

SourceState SourceBook::state(const ConsoleSetup::Source& source, Arrival now) const {
  SourceState s;
  s.name = source.name, s.decoder = source.decoder, s.body = source.body;
  s.period_s = period_s();
  s.rate_hz = recent_.rate_hz(now);
  if (recent_.count(now) < 5) {
    const double frame_period_s = frames_pulse_.period_s();
    if (frame_period_s > 0.0 && last_)
      s.rate_hz = seconds(now - *last_) <= kSilentPeriods * frame_period_s ? 1.0 / frame_period_s : 0.0;
  }
  if (last_) s.last = last_->host();
  if (latency_) s.latency_s = seconds(*latency_);
  s.frames = frames_, s.refused = refused_;
  s.last_refusal = std::string(refusal_.view());
  s.sigma = sigma_, s.sigma_unit = sigma_ ? sigma_unit_ : "";
  s.beams = beams_, s.satellites = satellites_;
  s.fixes_judged = fixes_;
  s.fixes_refused = static_cast<int>(std::bitset<kFixes>(refused_fixes_).count());
  return s;
}

}  // namespace leadline::ui
