#include "core/nav/engines/ekf7_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"
#include "core/nav/motion/dvl_velocity.h"

namespace leadline::nav {
namespace {

using Eigen::Vector2d;

constexpr double kStep_s = 0.1;  // the paper's
constexpr double kMostSteps = 100.0;
constexpr double kLatest_s = 1.0;
constexpr double kRateSd_rps = 0.05 * kRadPerDeg;
constexpr double kHighestHdop = 2.0;
constexpr double kCalibrated_deg = 0.7, kCalibrated_m = 60.0;

Vector2d turned(double x, double y, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * x - s * y, s * x + c * y};
}

}  // namespace

Ekf7Engine::Ekf7Engine(const EngineSetup& setup)
    : setup_(setup),
      motion_(setup.body, setup.sources, setup.options, setup.magnetic),
      measured_(setup.body, nullptr),
      fixes_(setup.sources, setup.options, setup.magnetic),
      pace_(setup.options.navigation.output_hz),
      filter_(Filter::Settings{}) {
  apply_initial_depth(setup.options.initial, motion_);
}

void Ekf7Engine::take(const Envelope& envelope, EngineOutput& out) {
  if (std::holds_alternative<Tick>(envelope.message)) {
    evaluate(envelope.valid, out);
    return;
  }
  (void)motion_.take(envelope);
  if (motion_.own(envelope.source)) {
    const SourceInfo& source = motion_.source(envelope.source);
    if (const auto* heading = std::get_if<Heading>(&envelope.message)) {
      Envelope as_measured = envelope;
      std::get<Heading>(as_measured.message).reference = HeadingReference::true_north;
      measured_.take(as_measured, source);
      on_heading(envelope, *heading);
    } else {
      measured_.take(envelope, source);
    }
    if (const auto* rates = std::get_if<Rates>(&envelope.message);
        rates != nullptr && rates_.takes(source.id, envelope.valid) && filter_.started() &&
        advance(envelope.valid)) {
      const Vector2d before = filter_.x().head<2>();
      filter_.rate(rates->rate_z_rps, kRateSd_rps);
      shift_from(before);
    }
    if (const auto* ping = std::get_if<DvlVelocity>(&envelope.message)) {
      if (motion_.is_bottom_ping(envelope)) {
        availability_.dvl_ping(envelope.valid, ping->valid, motion_.above_bottom_m());
        evaluate(envelope.valid, out);
      }
      on_velocity(envelope, *ping);
    }
  }
  if (const auto fix = fixes_.take(envelope)) {
    const auto* gnss = std::get_if<GnssFix>(&envelope.message);
    on_fix(*fix, gnss != nullptr ? gnss->hdop : std::nullopt, out);
  }
  if (filter_.started()) {
    tell_bias(envelope.valid, out);
    publish_row(out);
  }
}

void Ekf7Engine::evaluate(Time now, EngineOutput& out) {
  if (const auto change = availability_.evaluate(now)) publish_change(*change, setup_.id, now, out);
}

bool Ekf7Engine::advance(Time t) {
  const double dt_s = seconds(t - now_);
  if (dt_s <= 0.0) return dt_s > -kLatest_s;
  const Vector2d before = filter_.x().head<2>();
  const auto steps = static_cast<int>(std::clamp(std::ceil(dt_s / kStep_s - 1e-6), 1.0, kMostSteps));
  for (int i = 0; i < steps; ++i) filter_.predict(dt_s / steps);
  const Vector2d moved = filter_.x().head<2>() - before;
  motion_.track.advance(t, moved);
  motion_.track.hear(t, {.v_ne = moved / dt_s});
  drift_.grow(moved.norm() / dt_s, dt_s);
  run_m_ += moved.norm();
  now_ = t;
  return true;
}

void Ekf7Engine::shift_from(const Vector2d& before) {
  const Vector2d step = filter_.x().head<2>() - before;
  motion_.track.shift(step);
  corrections_ += step;
}

void Ekf7Engine::on_heading(const Envelope& envelope, const Heading& heading) {
  const SourceInfo& source = motion_.source(envelope.source);
  if (!compass_.takes(source.id, envelope.valid)) return;
  heading_at_ = envelope.valid;
  if (!filter_.started()) {
    if (const auto initial = initial_position(setup_.options.initial))
      start(envelope.valid, initial->position, setup_.options.initial.sd_position_m);
    return;
  }
  if (!advance(envelope.valid)) return;
  const Angle least = Angle::deg(setup_.options.aiding.heading_noise_deg);
  const double sd_rad =
      heading.sd ? std::max(heading.sd->rad(), 0.1 * least.rad()) : std::max(least.rad(), 1e-4);
  const Vector2d before = filter_.x().head<2>();
  filter_.heading((heading.heading - source.mount.heading).rad(), sd_rad);
  shift_from(before);
}

void Ekf7Engine::on_velocity(const Envelope& envelope, const DvlVelocity& ping) {
  const SourceInfo& source = motion_.source(envelope.source);
  if (!ping.valid || ping.reference != DvlReference::bottom || !dvl_.takes(source.id, envelope.valid)) return;
  const auto attitude = measured_.at(envelope.valid, motion_.track.position()).attitude;
  if (!attitude || !filter_.started() || !advance(envelope.valid)) return;
  const Vec3<Ned> v_n = velocity_ned(ping, source, *attitude);
  const Vector2d uv = turned(v_n.x, v_n.y, -attitude->heading.rad());
  const double least_mps = ping.sd_mps.value_or(setup_.options.aiding.dvl_noise_mps);
  const Vector2d before = filter_.x().head<2>();
  filter_.velocity(uv, {std::max(least_mps, Filter::velocity_sd_mps(uv.x())),
                        std::max(least_mps, Filter::velocity_sd_mps(uv.y()))});
  shift_from(before);
  vel_down_mps_ = v_n.z;
  down_at_ = envelope.valid;
}

Vector2d Ekf7Engine::lever_ne(const SourceInfo& source, Time t) {
  const auto attitude = measured_.at(t, motion_.track.position()).attitude;
  const double psi = attitude ? attitude->heading.rad() + filter_.x()(Filter::b) : filter_.x()(Filter::psi);
  return turned(source.lever.x, source.lever.y, psi);
}

void Ekf7Engine::start(Time t, const Geodetic& position, double sd_m) {
  const auto measured = measured_.at(t, position).attitude;
  if (!measured) return;
  double bias_rad = 0.0;
  if (const auto known = motion_.attitude_at(t).attitude)
    bias_rad = (known->heading - measured->heading).wrapped_pi().rad();
  Filter::Settings settings;
  settings.sd_position_m = sd_m;
  filter_ = Filter(settings);
  filter_.start(Vector2d::Zero(), measured->heading.rad(), bias_rad);
  now_ = epoch_ = t;
  motion_.track.start(t, position, sd_m * sd_m * Eigen::Matrix2d::Identity());
}

void Ekf7Engine::on_fix(const PositionFix& fix, std::optional<double> hdop, EngineOutput& out) {
  FixVerdict verdict{.engine = setup_.id, .position = fix.position, .depth = fix.depth};
  const bool use = fix.body == setup_.body && fix.kind == PositionSource::gnss &&
                   gnss_.takes(fix.source, fix.t) && hdop.value_or(0.0) <= kHighestHdop;
  const SourceInfo& source = motion_.source(fix.source);
  const double sd_m = fix.drms_m / std::sqrt(2.0);
  if (use) {
    availability_.surfaced(motion_.surfaced());
    availability_.gnss_fix(fix.t);
  }
  if (use && !filter_.started()) {
    if (initial_position(setup_.options.initial)) {
      out.publish(fix.t, verdict, fix.source);
      return;
    }
    start(fix.t, fix.position, sd_m);
    if (filter_.started()) {
      const Vector2d lever = lever_ne(source, fix.t);
      motion_.track.shift(-lever);
      verdict.accepted = true;
      position_source_ = fix.kind;
      if (fix.height) motion_.height_known(*fix.height);
    }
    out.publish(fix.t, verdict, fix.source);
    evaluate(fix.t, out);
    return;
  }
  if (filter_.started() && fix.body == setup_.body) {
    if (use) advance(fix.t);
    if (const auto here = motion_.track.position_at(fix.t)) {
      const auto off = geo::difference(*here, fix.position);
      Vector2d residual(off.north_m, off.east_m);
      if (fix.kind == PositionSource::gnss) residual -= lever_ne(source, fix.t);
      verdict.residual_m = residual.norm();
      if (use && filter_.fast_enough()) {
        filter_.lever({source.lever.x, source.lever.y});
        verdict.gate_m = filter_.gate_m(residual, sd_m);
        const Vector2d before = filter_.x().head<2>();
        verdict.accepted = filter_.position(residual, sd_m);
        if (!*verdict.accepted) {
          rejected_.push(seconds(fix.t - epoch_), residual + corrections_, fix.drms_m);
          if (const auto agreement = rejected_.agreement(corrections_, drift_)) {
            filter_.moved(agreement->e - corrections_, agreement->variance);
            verdict.accepted = true;
            Health health{.level = Health::Level::warning,
                          .text = fmt::format(
                              "position set anew from {} fixes of {} that agree, {:.0f} m from the track",
                              agreement->count, source.name, (agreement->e - corrections_).norm())};
            out.publish(fix.t, health, fix.source);
          }
        }
        shift_from(before);
        if (*verdict.accepted) {
          rejected_.clear();
          drift_ = {};
          position_source_ = fix.kind;
          if (fix.height) motion_.height_known(*fix.height);
        }
      }
    }
  }
  out.publish(fix.t, verdict, fix.source);
  if (use) evaluate(fix.t, out);
}

void Ekf7Engine::tell_bias(Time now, EngineOutput& out) {
  const double sd_deg = std::sqrt(filter_.P()(Filter::b, Filter::b)) / kRadPerDeg;
  if (bias_told_ || sd_deg > kCalibrated_deg || run_m_ < kCalibrated_m) return;
  bias_told_ = true;
  const double bias_deg = filter_.x()(Filter::b) / kRadPerDeg;
  std::string beside = "; no declination is known here";
  const auto measured = measured_.at(now_, motion_.track.position()).attitude;
  const auto known = motion_.attitude_at(now_).attitude;
  if (measured && known) {
    const double declination_deg = (known->heading - measured->heading).wrapped_pi().deg();
    beside = fmt::format(", {:+.1f} deg of it the declination, {:+.1f} deg mount, deviation and DVL",
                         declination_deg, bias_deg - declination_deg);
  }
  Health health{.text = fmt::format("heading bias {:+.1f} deg, sigma {:.1f}, after {:.0f} m{}", bias_deg,
                                    sd_deg, run_m_, beside)};
  out.publish(now, health);
}

void Ekf7Engine::publish_row(EngineOutput& out) {
  if (now_ <= epoch_ || !pace_.due(now_)) return;
  const auto& x = filter_.x();
  const auto& P = filter_.P();
  Solution solution = motion_.solution();
  const auto tilts = measured_.at(now_, motion_.track.position());
  if (tilts.attitude && tilts.tilts_known) {
    solution.roll = tilts.attitude->roll;
    solution.pitch = tilts.attitude->pitch;
  }
  solution.heading = Angle::rad(x(Filter::psi)).wrapped_2pi();
  solution.sd_heading = Angle::rad(std::sqrt(P(Filter::psi, Filter::psi)));
  solution.heading_bias = Angle::rad(x(Filter::b));
  const Vector2d v_ne = turned(x(Filter::u), x(Filter::v), x(Filter::psi));
  solution.vel_north_mps = v_ne.x();
  solution.vel_east_mps = v_ne.y();
  solution.vel_down_mps.reset();
  if (down_at_ && *down_at_ == now_) solution.vel_down_mps = vel_down_mps_;
  solution.var_north_m2 = P(0, 0);
  solution.cov_north_east_m2 = P(0, 1);
  solution.var_east_m2 = P(1, 1);
  solution.engine = setup_.id;
  solution.mode = availability_.mode();
  solution.position_source = position_source_;
  out.publish(now_, solution);
}

}  // namespace leadline::nav
