#include "core/nav/engines/fusion_engine.h"

#include <fmt/format.h>

#include <cmath>

#include "core/geo/geodesy.h"

namespace leadline::nav {
namespace {

/// A velocity older than this says nothing of the motion now.
constexpr double kVelocityHoldS = 5.0;
constexpr double kUnknownSpeedMps = 5.0, kKnownSpeedMps = 0.5;
constexpr int kComparisons = 60;

Eigen::Matrix2d isotropic(double variance) { return Eigen::Matrix2d::Identity() * variance; }

/// What the filter estimates is not declared as a sigma of dead reckoning a second time.
Options of_reckoning(const Options& options) {
  Options own = options;
  if (estimates_misalignment(options.fusion))
    own.aiding.dvl_misalignment_deg = own.aiding.dvl_scale_ppm = 0.0;
  return own;
}

/// Where it is plain which way: along the ship's axis an offset smells of latency.
const char* bearing_word(double off_bow_deg) {
  if (std::abs(off_bow_deg) < 10.0) return ", dead ahead";
  if (std::abs(off_bow_deg) > 170.0) return ", dead astern";
  return "";
}

}  // namespace

FusionEngine::FusionEngine(const EngineSetup& setup)
    : setup_(setup),
      motion_(setup.body, setup.sources, of_reckoning(setup.options), setup.magnetic),
      fixes_(setup.sources, setup.options, setup.magnetic),
      pace_(setup.options.navigation.output_hz),
      filter_(setup.options),
      rivals_(setup.sources.size()) {
  apply_initial_depth(setup.options.initial, motion_);
}

void FusionEngine::take(const Envelope& envelope, EngineOutput& out) {
  if (std::holds_alternative<Tick>(envelope.message)) {
    evaluate(envelope.valid, out);
    return;
  }
  if (const auto* course = std::get_if<Course>(&envelope.message);
      course != nullptr && motion_.own(envelope.source)) {
    course_ = *course;
    course_at_ = envelope.valid;
  }
  const auto ping = motion_.take(envelope);
  if (const auto notice = motion_.notice()) out.publish(envelope.valid, *notice, envelope.source);
  if (motion_.is_bottom_ping(envelope)) {
    availability_.dvl_ping(envelope.valid, std::get<DvlVelocity>(envelope.message).valid,
                           motion_.above_bottom_m());
    evaluate(envelope.valid, out);
  }
  if (ping) on_ping(*ping, out);
  if (const auto fix = fixes_.take(envelope)) on_fix(*fix, out);
}

void FusionEngine::evaluate(Time now, EngineOutput& out) {
  const bool had_gnss = availability_.gnss_ok();
  if (const auto change = availability_.evaluate(now)) publish_change(*change, setup_.id, now, out);
  if (had_gnss && !availability_.gnss_ok()) tell_comparisons(now, out);
  const Mode mode = availability_.mode();
  propagate_with(mode == Mode::C || mode == Mode::D ? Propagation::constant_velocity : Propagation::reckoning,
                 now);
}

void FusionEngine::propagate_with(Propagation propagation, Time now) {
  if (propagation == propagation_ || !motion_.track.started()) return;
  propagation_ = propagation;
  if (propagation == Propagation::reckoning) {
    filter_.predict(Eigen::Vector2d::Zero(), seconds(motion_.track.time() - reckoned_until_));
    reckoned_until_ = motion_.track.time();
    filter_.reset(constant_velocity_.P_position());
    motion_.track.fixed(constant_velocity_.P_position());
    return;
  }
  Eigen::Vector2d v_ne = Eigen::Vector2d::Zero();
  double sd_mps = kUnknownSpeedMps;
  const auto heard = motion_.track.last_heard();
  if (course_ && course_->course && std::abs(seconds(now - course_at_)) < kVelocityHoldS) {
    v_ne = course_->speed_mps * Eigen::Vector2d(cos(*course_->course), sin(*course_->course));
    sd_mps = kKnownSpeedMps;
  } else if (heard && std::abs(seconds(now - *heard)) < kVelocityHoldS) {
    v_ne = motion_.track.last_velocity();
    sd_mps = kKnownSpeedMps;
  }
  constant_velocity_.reset(covariance(), v_ne, isotropic(sd_mps * sd_mps));
  pure_reckoning_ = false;
  filter_.forget_pairs();
}

void FusionEngine::start(Time t, const Geodetic& position, const Eigen::Matrix2d& P) {
  motion_.track.start(t, position, P);
  filter_.reset(P);
  epoch_ = reckoned_until_ = t;
  origin_ = position;
}

void FusionEngine::on_ping(const Motion::Ping& ping, EngineOutput& out) {
  if (!motion_.track.started()) {
    if (const auto initial = initial_position(setup_.options.initial))
      start(ping.t, initial->position, initial->P);
  }
  DeadReckoning::Velocity velocity = ping.velocity;
  velocity.v_ne = filter_.over_ground(ping.velocity.v_ne);
  const Eigen::Vector2d correction_mps = velocity.v_ne - ping.velocity.v_ne;
  if (propagation_ == Propagation::constant_velocity) {
    motion_.track.hear(ping.t, velocity);
    return;
  }
  const auto step = motion_.track.velocity(ping.t, velocity);
  if (!step) return;
  if (!ping.bottom) {
    pure_reckoning_ = false;
    filter_.forget_pairs();
  }
  corrections_ += correction_mps * step->dt_s;
  filter_.predict(step->displacement / step->dt_s, step->dt_s);
  reckoned_until_ = ping.t;
  evaluate(ping.t, out);
  publish_row(ping.t, out);
}

bool FusionEngine::used(const PositionFix& fix) {
  if (fix.kind == PositionSource::usbl) return !availability_.gnss_ok();
  return !rivals_[fix.source].disagrees && gnss_.takes(fix.source, fix.t);
}

void FusionEngine::on_fix(const PositionFix& fix, EngineOutput& out) {
  FixVerdict verdict{.engine = setup_.id, .position = fix.position, .depth = fix.depth};
  if (fix.body != setup_.body) {
    out.publish(fix.t, verdict, fix.source);
    return;
  }
  const Geodetic reference = reference_point(fix, motion_);
  const bool use = used(fix);
  availability_.surfaced(motion_.surfaced());

  if (use && !motion_.track.started() && !initial_position(setup_.options.initial)) {
    const Eigen::Matrix2d P = isotropic(0.5 * fix.drms_m * fix.drms_m);
    start(fix.t, reference, P);
    position_source_ = fix.kind;
    verdict.accepted = true;
    if (fix.kind == PositionSource::gnss)
      availability_.gnss_fix(fix.t);
    else
      availability_.usbl_fix(fix.t, true);
    if (fix.height) motion_.height_known(*fix.height);
    out.publish(fix.t, verdict, fix.source);
    evaluate(fix.t, out);
    return;
  }

  if (use && propagation_ == Propagation::constant_velocity && fix.t > motion_.track.time())
    motion_.track.advance(fix.t, constant_velocity_.predict(seconds(fix.t - motion_.track.time())));
  const auto here = motion_.track.position_at(fix.t);
  Eigen::Vector2d residual = Eigen::Vector2d::Zero();
  if (here) {
    const auto off = geo::difference(*here, reference);
    residual = {off.north_m, off.east_m};
    verdict.residual_m = residual.norm();
    if (pure_reckoning_) verdict.dr_residual_m = (residual + corrections_).norm();
  }
  if (!use || !here) {
    if (use && fix.kind == PositionSource::gnss) availability_.gnss_fix(fix.t);
    if (here && fix.kind == PositionSource::gnss)
      compare(fix, residual, filter_.drift().gate_m(fix.drms_m), out);
    out.publish(fix.t, verdict, fix.source);
    return;
  }

  if (propagation_ == Propagation::reckoning) align(fix, reference, residual + corrections_, out);
  const FixResult result = update(fix, residual);
  if (fix.kind == PositionSource::gnss)
    availability_.gnss_fix(fix.t);
  else
    availability_.usbl_fix(fix.t, result.accepted);
  if (result.accepted) {
    position_source_ = fix.kind;
    if (fix.height) motion_.height_known(*fix.height);
  }
  verdict.accepted = result.accepted;
  verdict.gate_m = result.gate_m;
  out.publish(fix.t, verdict, fix.source);
  if (result.reacquired) {
    Health health{
        .level = Health::Level::warning,
        .text = fmt::format("position set anew from {} fixes of {} that agree, {:.0f} m from the track",
                            result.agreeing, motion_.source(fix.source).name, result.step.norm())};
    out.publish(fix.t, health, fix.source);
  }
  const bool epoch_of_fixes = propagation_ == Propagation::constant_velocity;
  evaluate(fix.t, out);
  if (epoch_of_fixes) publish_row(fix.t, out);
}

FixResult FusionEngine::update(const PositionFix& fix, const Eigen::Vector2d& residual) {
  FixResult result;
  if (propagation_ == Propagation::constant_velocity) {
    result = constant_velocity_.fix(residual, isotropic(0.5 * fix.drms_m * fix.drms_m));
    motion_.track.shift(result.step);
    motion_.track.fixed(constant_velocity_.P_position());
  } else {
    result =
        filter_.fix(residual, seconds(fix.t - epoch_), fix.drms_m, std::sqrt(motion_.track.grown().trace()));
    motion_.track.shift(result.step);
    if (result.accepted) motion_.track.fixed(filter_.P());
  }
  corrections_ += result.step;
  return result;
}

void FusionEngine::align(const PositionFix& fix, const Geodetic& reference,
                         const Eigen::Vector2d& dr_residual, EngineOutput& out) {
  const auto off = geo::difference(origin_, reference);
  const Eigen::Vector2d z(off.north_m, off.east_m);
  const auto found = filter_.align(seconds(fix.t - epoch_), {z - dr_residual, z}, fix.drms_m);
  if (!found) return;
  Health health{
      .level = Health::Level::warning,
      .text = fmt::format("the DVL is turned by {:+.1f} deg beyond its mount (sigma {:.1f}, scale {:.3f}, {} "
                          "fixes): the position allows for it; calibrate",
                          found->alpha_rad / kRadPerDeg, found->sd_alpha_rad / kRadPerDeg, found->scale,
                          found->inliers)};
  out.publish(fix.t, health);
}

Eigen::Matrix2d FusionEngine::covariance() const {
  if (propagation_ == Propagation::reckoning && estimates_misalignment(setup_.options.fusion))
    return filter_.P() + motion_.track.grown();
  return motion_.track.covariance();
}

void FusionEngine::compare(const PositionFix& fix, const Eigen::Vector2d& residual, double gate_m,
                           EngineOutput& out) {
  Rival& rival = rivals_[fix.source];
  if (position_source_ != PositionSource::gnss || !availability_.gnss_ok()) return;
  rival.residuals += residual;
  rival.squares_m2 += residual.squaredNorm();
  if (const auto attitude = motion_.attitude_at(fix.t).attitude) {
    const Angle bearing = Angle::rad(std::atan2(rival.residuals.y(), rival.residuals.x()));
    rival.off_bow_deg = (bearing - attitude->heading).wrapped_pi().deg();
  }
  if (++rival.compared != kComparisons) return;
  const double off_m = rival.residuals.norm() / kComparisons;
  if (off_m < gate_m) return;
  rival.disagrees = true;
  Health health{
      .level = Health::Level::warning,
      .text = fmt::format("{} is not used: it lies {:.0f} m from the position{}, gate {:.0f} m; look for "
                          "latency or a lever arm",
                          motion_.source(fix.source).name, off_m, bearing_word(rival.off_bow_deg), gate_m)};
  out.publish(fix.t, health, fix.source);
}

void FusionEngine::tell_comparisons(Time now, EngineOutput& out) {
  for (std::size_t id = 0; id < rivals_.size(); ++id) {
    Rival& rival = rivals_[id];
    if (!rival.disagrees || rival.told) continue;
    rival.told = true;
    const Eigen::Vector2d mean = rival.residuals / rival.compared;
    Health health{
        .text = fmt::format("{} against the position while both were there: {:+.1f} m north, {:+.1f} m east, "
                            "RMS {:.1f} m over {} fixes{}",
                            motion_.source(static_cast<SourceId>(id)).name, mean.x(), mean.y(),
                            std::sqrt(rival.squares_m2 / rival.compared), rival.compared,
                            bearing_word(rival.off_bow_deg))};
    out.publish(now, health, static_cast<SourceId>(id));
  }
}

void FusionEngine::publish_row(Time t, EngineOutput& out) {
  if (!pace_.due(t)) return;
  Solution solution = motion_.solution();
  if (propagation_ == Propagation::constant_velocity) {
    solution.vel_north_mps = constant_velocity_.velocity().x();
    solution.vel_east_mps = constant_velocity_.velocity().y();
  } else if (solution.vel_north_mps) {
    solution.vel_north_mps = motion_.track.last_velocity().x();
    solution.vel_east_mps = motion_.track.last_velocity().y();
  }
  const Eigen::Matrix2d P = covariance();
  solution.var_north_m2 = P(0, 0);
  solution.cov_north_east_m2 = P(0, 1);
  solution.var_east_m2 = P(1, 1);
  solution.heading_bias = filter_.misalignment();
  solution.engine = setup_.id;
  solution.mode = availability_.mode();
  solution.position_source = position_source_;
  out.publish(t, solution);
}

}  // namespace leadline::nav
