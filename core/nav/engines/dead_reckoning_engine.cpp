#include "core/nav/engines/dead_reckoning_engine.h"

#include "core/geo/geodesy.h"

namespace leadline::nav {

std::optional<InitialPosition> initial_position(const InitialOptions& initial) {
  if (!initial.lat_deg || !initial.lon_deg) return std::nullopt;
  return InitialPosition{{Angle::deg(*initial.lat_deg), Angle::deg(*initial.lon_deg).wrapped_pi()},
                         Eigen::Matrix2d::Identity() * initial.sd_position_m * initial.sd_position_m};
}

void apply_initial_depth(const InitialOptions& initial, Motion& motion) {
  if (initial.depth_m)
    motion.depth_known(Depth{*initial.depth_m}, initial.sd_depth_m);
  else if (initial.ellipsoid_height_m)
    motion.depth_known(Depth{-*initial.ellipsoid_height_m}, initial.sd_depth_m);
}

Geodetic reference_point(const PositionFix& fix, Motion& motion) {
  if (fix.kind == PositionSource::usbl) return fix.position;
  return motion.without_lever(fix.position, motion.source(fix.source), fix.t);
}

void publish_change(const Availability::Change& change, EngineId engine, Time now, EngineOutput& out) {
  out.publish(now, ModeChange{engine, change.from, change.to, change.reason});
}

DeadReckoningEngine::DeadReckoningEngine(const EngineSetup& setup)
    : setup_(setup),
      motion_(setup.body, setup.sources, setup.options, setup.magnetic),
      fixes_(setup.sources, setup.options, setup.magnetic),
      pace_(setup.options.navigation.output_hz) {
  apply_initial_depth(setup.options.initial, motion_);
}

void DeadReckoningEngine::take(const Envelope& envelope, EngineOutput& out) {
  if (const auto* tick = std::get_if<Tick>(&envelope.message)) {
    if (const auto change = availability_.evaluate(tick->at.host()))
      publish_change(*change, setup_.id, envelope.valid, out);
    return;
  }
  const auto ping = motion_.take(envelope);
  if (const auto notice = motion_.notice()) out.publish(envelope.valid, *notice, envelope.source);
  if (motion_.is_bottom_ping(envelope))
    availability_.dvl_ping(envelope.valid, std::get<DvlVelocity>(envelope.message).valid,
                           motion_.above_bottom_m());
  if (ping) {
    if (!motion_.track.started()) {
      if (const auto initial = initial_position(setup_.options.initial))
        motion_.track.start(ping->t, initial->position, initial->P);
    }
    if (motion_.track.velocity(ping->t, ping->velocity) && pace_.due(ping->t)) {
      if (const auto change = availability_.evaluate(ping->t))
        publish_change(*change, setup_.id, ping->t, out);
      Solution solution = motion_.solution();
      solution.engine = setup_.id;
      solution.mode = availability_.mode();
      out.publish(ping->t, solution);
    }
  }
  if (const auto fix = fixes_.take(envelope)) on_fix(*fix, out);
}

void DeadReckoningEngine::on_fix(const PositionFix& fix, EngineOutput& out) {
  FixVerdict verdict{.engine = setup_.id, .position = fix.position, .depth = fix.depth};
  if (fix.body == setup_.body) {
    const Geodetic reference = reference_point(fix, motion_);
    if (fix.kind == PositionSource::gnss) {
      availability_.gnss_fix(fix.t);
      if (fix.height) motion_.height_known(*fix.height);
    } else {
      availability_.usbl_fix(fix.t, true);
    }
    availability_.surfaced(motion_.surfaced());
    if (!motion_.track.started() && !initial_position(setup_.options.initial)) {
      motion_.track.start(fix.t, reference, Eigen::Matrix2d::Identity() * 0.5 * fix.drms_m * fix.drms_m);
    } else if (const auto here = motion_.track.position_at(fix.t)) {
      const auto residual = geo::difference(*here, reference);
      verdict.residual_m = verdict.dr_residual_m = std::hypot(residual.north_m, residual.east_m);
    }
  }
  out.publish(fix.t, verdict, fix.source);
}

}  // namespace leadline::nav
