#include "core/nav/engines/ship_state.h"

#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"

namespace leadline::nav {
namespace {

constexpr double kPositionHoldS = 10.0;
constexpr double kCourseHoldS = 3.0;

}  // namespace

double drms_m(const GnssFix& fix, double configured_m) {
  if (!fix.sd_north_m || !fix.sd_east_m) return configured_m;
  return std::max(std::hypot(*fix.sd_north_m, *fix.sd_east_m), 0.1 * configured_m);
}

ShipState::ShipState(std::span<const SourceInfo> sources, const Options& options,
                     const geo::MagneticModel* magnetic)
    : sources_(sources), options_(options), attitude_(Body::ship, magnetic) {}

bool ShipState::take(const Envelope& envelope) {
  if (envelope.source >= sources_.size() || sources_[envelope.source].body != Body::ship) return false;
  const SourceInfo& source = sources_[envelope.source];
  attitude_.take(envelope, source);
  if (const auto* course = std::get_if<Course>(&envelope.message)) {
    if (course_source_.takes(source.id, envelope.valid)) course_ = *course, course_at_ = envelope.valid;
    return false;
  }
  const auto* fix = std::get_if<GnssFix>(&envelope.message);
  if (fix == nullptr || !gnss_.takes(source.id, envelope.valid)) return false;
  fixed_at_ = envelope.valid;
  position_ = fix->position;
  height_ = fix->height;
  drms_m_ = drms_m(*fix, options_.aiding.gnss_drms_m);
  if (!(source.lever == Vec3<BodyFrame>{})) {
    if (const auto attitude = attitude_.at(envelope.valid, position_).attitude) {
      const Vec3<Ned> lever_n = Rotation<Ned, BodyFrame>::zyx(*attitude) * source.lever;
      position_ = geo::displaced(position_, -lever_n.x, -lever_n.y);
    }
  }
  return true;
}

std::optional<Geodetic> ShipState::position_at(Time t) const {
  if (!fixed_at_ || std::abs(seconds(t - *fixed_at_)) > kPositionHoldS) return std::nullopt;
  if (!course_ || !course_->course || std::abs(seconds(*fixed_at_ - course_at_)) > kPositionHoldS)
    return position_;
  const double run_m = course_->speed_mps * seconds(t - *fixed_at_);
  return geo::displaced(position_, run_m * cos(*course_->course), run_m * sin(*course_->course));
}

Solution ShipState::solution() {
  Solution s;
  s.engine = kShipTrack;
  s.position = position_;
  if (height_) {
    s.depth = Depth{-height_->m};
    s.sd_down_m = options_.aiding.gnss_height_noise_m;
  }
  const auto attitude = attitude_.at(*fixed_at_, position_);
  if (attitude.attitude) {
    s.heading = attitude.attitude->heading;
    if (attitude.tilts_known) s.roll = attitude.attitude->roll, s.pitch = attitude.attitude->pitch;
    s.sd_heading = attitude.sd_heading.value_or(Angle::deg(options_.aiding.heading_noise_deg));
  }
  if (course_ && course_->course && std::abs(seconds(*fixed_at_ - course_at_)) <= kCourseHoldS) {
    s.vel_north_mps = course_->speed_mps * cos(*course_->course);
    s.vel_east_mps = course_->speed_mps * sin(*course_->course);
    s.vel_down_mps = course_->vel_down_mps;
  }
  s.var_north_m2 = s.var_east_m2 = 0.5 * drms_m_ * drms_m_;
  s.position_source = PositionSource::gnss;
  return s;
}

}  // namespace leadline::nav
