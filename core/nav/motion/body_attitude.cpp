#include "core/nav/motion/body_attitude.h"

#include <cmath>

namespace leadline::nav {
namespace {

constexpr double kSamePlaceRad = 5e-4;  // 3 km
constexpr double kSameDayS = 86400.0;

Angle between(Angle a, Angle b, double fraction) { return a + (b - a).wrapped_pi() * fraction; }

}  // namespace

void BodyAttitude::take(const Envelope& envelope, const SourceInfo& source) {
  if (source.body != body_) return;
  if (const auto* heading = std::get_if<Heading>(&envelope.message)) {
    if (!heading_source_.takes(source.id, envelope.valid)) return;
    HeadingSample sample;
    sample.heading = heading->heading - source.mount.heading;
    sample.magnetic = heading->reference == HeadingReference::magnetic_north;
    sample.variation = source.declination ? source.declination : heading->variation;
    sample.sd = heading->sd;
    headings_.add(envelope.valid, sample);
  } else if (const auto* attitude = std::get_if<Attitude>(&envelope.message)) {
    if (!tilt_source_.takes(source.id, envelope.valid)) return;
    // R_nb = R_ns R_sb; the heading drops out of roll and pitch.
    const auto R_ns = Rotation<Ned, Instrument>::zyx({attitude->roll, attitude->pitch, Angle()});
    const auto R_sb = Rotation<BodyFrame, Instrument>::zyx(source.mount).inverse();
    const EulerAngles body = (R_ns * R_sb).euler();
    tilts_.add(envelope.valid, {body.roll, body.pitch});
  }
}

std::optional<Angle> BodyAttitude::true_heading(const HeadingSample& sample, Time t, const Geodetic& place) {
  if (!sample.magnetic) return sample.heading;
  if (sample.variation) return sample.heading + *sample.variation;
  const bool near = declination_.known &&
                    std::abs((place.lat - declination_.place.lat).rad()) < kSamePlaceRad &&
                    std::abs((place.lon - declination_.place.lon).wrapped_pi().rad()) < kSamePlaceRad &&
                    std::abs(seconds(t - declination_.t)) < kSameDayS;
  if (!near) {
    if (magnetic_ == nullptr) {
      lacks_declination_ = true;
      return std::nullopt;
    }
    const auto found = magnetic_->declination(place, EllipsoidHeight{0.0}, t);
    outside_model_ = outside_model_ || found.outside_validity;
    declination_ = {true, place, t, found.east};
  }
  return sample.heading + declination_.east;
}

BodyAttitude::Estimate BodyAttitude::at(Time t, const Geodetic& place) {
  Estimate estimate;
  EulerAngles attitude;
  if (const auto tilts = tilts_.at(t, kHoldS)) {
    attitude.roll = between(tilts->before->roll, tilts->after->roll, tilts->fraction);
    attitude.pitch = between(tilts->before->pitch, tilts->after->pitch, tilts->fraction);
    estimate.tilts_known = true;
  }
  const auto heading = headings_.at(t, kHoldS);
  if (!heading) return estimate;
  const auto a = true_heading(*heading->before, t, place), b = true_heading(*heading->after, t, place);
  if (!a || !b) return estimate;
  attitude.heading = between(*a, *b, heading->fraction).wrapped_2pi();
  estimate.attitude = attitude;
  estimate.sd_heading = heading->after->sd;
  return estimate;
}

}  // namespace leadline::nav
