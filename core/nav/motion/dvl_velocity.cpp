#include "core/nav/motion/dvl_velocity.h"

namespace leadline::nav {
namespace {

EulerAngles sum(const EulerAngles& a, const EulerAngles& b) {
  return {a.roll + b.roll, a.pitch + b.pitch, a.heading + b.heading};
}

EulerAngles level(Angle heading) { return {Angle(), Angle(), heading}; }

}  // namespace

Vec3<Ned> velocity_ned(const DvlVelocity& ping, const SourceInfo& source, const EulerAngles& attitude) {
  const Vec3<Instrument> measured = Vec3<Instrument>{ping.x_mps, ping.y_mps, ping.z_mps} * source.scale;
  switch (ping.frame) {
    case DvlFrame::instrument: {
      const auto R_bs = Rotation<BodyFrame, Instrument>::zyx(sum(source.mount, source.calibration));
      return Rotation<Ned, BodyFrame>::zyx(ping.tilt_applied ? level(attitude.heading) : attitude) *
             (R_bs * measured);
    }
    case DvlFrame::ship: {
      const auto R_bs = Rotation<BodyFrame, Instrument>::zyx(source.calibration);
      return Rotation<Ned, BodyFrame>::zyx(ping.tilt_applied ? level(attitude.heading) : attitude) *
             (R_bs * measured);
    }
    case DvlFrame::earth:
      break;
  }
  const Angle applied = ping.applied ? ping.applied->heading : attitude.heading;
  const auto unturned = Rotation<Instrument, Instrument>::zyx(level(-applied)) * measured;
  const auto R_bs = Rotation<BodyFrame, Instrument>::zyx(source.calibration);
  return Rotation<Ned, BodyFrame>::zyx(level(attitude.heading)) * (R_bs * unturned);
}

}  // namespace leadline::nav
