#include "core/nav/motion/motion.h"

#include <cmath>

#include "core/geo/geodesy.h"
#include "core/nav/motion/dvl_velocity.h"

namespace leadline::nav {
namespace {

/// Without a ping over the bottom for this long, one through the water serves.
constexpr double kBottomHoldS = 3.0;

}  // namespace

Motion::Motion(Body body, std::span<const SourceInfo> sources, const Options& options,
               const geo::MagneticModel* magnetic)
    : track({options.aiding.dvl_scale_ppm * 1e-6,
             std::hypot(options.aiding.dvl_misalignment_deg, options.aiding.heading_noise_deg) * kRadPerDeg}),
      body_(body),
      sources_(sources),
      options_(options),
      attitude_(body, magnetic) {}

bool Motion::is_bottom_ping(const Envelope& envelope) const {
  const auto* ping = std::get_if<DvlVelocity>(&envelope.message);
  return ping != nullptr && own(envelope.source) && ping->reference == DvlReference::bottom &&
         envelope.source == dvl_.speaker();
}

std::optional<Motion::Ping> Motion::take(const Envelope& envelope) {
  if (!own(envelope.source)) return std::nullopt;
  const SourceInfo& source = sources_[envelope.source];
  attitude_.take(envelope, source);
  if (const auto* depth = std::get_if<DepthMeasured>(&envelope.message)) {
    if (depth_source_.takes(source.id, envelope.valid)) {
      depth_measured_ = true;
      depth_ = Depth{depth->depth.m - source.lever.z};
      track.at_depth(*depth_);
      sd_depth_m_ =
          std::max(depth->sd_m.value_or(options_.aiding.depth_noise_m), 0.1 * options_.aiding.depth_noise_m);
    }
  } else if (const auto* altitude = std::get_if<AltitudeAboveBottom>(&envelope.message)) {
    above_bottom_m_ = altitude->above_bottom_m;
  }
  const auto* measured = std::get_if<DvlVelocity>(&envelope.message);
  if (measured == nullptr || !dvl_.takes(source.id, envelope.valid) || !measured->valid) return std::nullopt;

  const bool bottom = measured->reference == DvlReference::bottom;
  if (!bottom && bottom_pings_.last() && seconds(envelope.valid - *bottom_pings_.last()) <= kBottomHoldS)
    return std::nullopt;
  const auto attitude = attitude_.at(envelope.valid, track.position());
  if (!attitude.attitude) return std::nullopt;
  const Vec3<Ned> v_n = velocity_ned(*measured, source, *attitude.attitude);
  Ping ping;
  ping.t = envelope.valid;
  ping.bottom = bottom;
  ping.velocity.v_ne = {v_n.x, v_n.y};
  ping.velocity.noise_mps =
      std::max(measured->sd_mps.value_or(options_.aiding.dvl_noise_mps), 0.1 * options_.aiding.dvl_noise_mps);
  ping.velocity.drift_mps = bottom ? 0.0 : options_.aiding.water_current_mps;
  ping.vel_down_mps = v_n.z;
  if (bottom) bottom_pings_.event(ping.t);
  last_ping_ = ping;
  return ping;
}

std::optional<Health> Motion::notice() {
  if (attitude_.lacks_declination() && !told_lacking_) {
    told_lacking_ = true;
    return Health{
        Health::Level::warning,
        "a magnetic heading is not used: no magnetic model is loaded; set declination_deg for its source"};
  }
  if (attitude_.outside_model() && !told_outside_) {
    told_outside_ = true;
    return Health{Health::Level::warning,
                  "the declination is of the nearest magnetic model: the date is outside 2015 to 2030; "
                  "set declination_deg if it is known better"};
  }
  return std::nullopt;
}

void Motion::height_known(EllipsoidHeight height) {
  if (depth_measured_) return;
  depth_ = Depth{-height.m};
  track.at_depth(*depth_);
  sd_depth_m_ = options_.aiding.gnss_height_noise_m;
}

void Motion::depth_known(Depth depth, double sd_m) {
  depth_ = depth;
  track.at_depth(depth);
  sd_depth_m_ = sd_m;
}

Geodetic Motion::without_lever(const Geodetic& instrument, const SourceInfo& source, Time t) {
  if (source.lever == Vec3<BodyFrame>{}) return instrument;
  const auto attitude = attitude_.at(t, instrument).attitude;
  if (!attitude) return instrument;
  const Vec3<Ned> lever_n = Rotation<Ned, BodyFrame>::zyx(*attitude) * source.lever;
  return geo::displaced(instrument, -lever_n.x, -lever_n.y);
}

Solution Motion::solution() {
  Solution s;
  s.position = track.position();
  s.depth = depth_;
  if (depth_) s.sd_down_m = sd_depth_m_;
  const auto attitude = attitude_.at(track.time(), track.position());
  if (attitude.attitude) {
    s.heading = attitude.attitude->heading;
    if (attitude.tilts_known) s.roll = attitude.attitude->roll, s.pitch = attitude.attitude->pitch;
    s.sd_heading = attitude.sd_heading.value_or(Angle::deg(options_.aiding.heading_noise_deg));
  }
  if (last_ping_ && last_ping_->bottom && last_ping_->t == track.time()) {
    s.vel_north_mps = last_ping_->velocity.v_ne.x();
    s.vel_east_mps = last_ping_->velocity.v_ne.y();
    s.vel_down_mps = last_ping_->vel_down_mps;
  }
  const Eigen::Matrix2d P = track.covariance();
  s.var_north_m2 = P(0, 0);
  s.cov_north_east_m2 = P(0, 1);
  s.var_east_m2 = P(1, 1);
  return s;
}

}  // namespace leadline::nav
