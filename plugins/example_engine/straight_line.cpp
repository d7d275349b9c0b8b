// A whole engine plugin: options, engine, and the root object the program loads.

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/flow/engine.h"
#include "core/geo/geodesy.h"
#include "plugins/sdk/engine_plugin.h"

namespace leadline::example {
namespace {

/// [navigation.straight-line]
struct StraightLineOptions {
  double manoeuvre_mps2 = 0.05;
  double longest_s = 60.0;
};

/// The body goes on as between its last two GNSS fixes: one Solution a Tick, at most output_hz, until
/// longest_s after the last fix. The antenna's lever arm is not taken off.
class StraightLine final : public Engine {
 public:
  StraightLine(const StraightLineOptions& options, const EngineSetup& setup);
  void take(const Envelope& envelope, EngineOutput& out) override;

 private:
  struct Fix {
    Time t;
    Geodetic position;
    double sd_m = 0.0;  // one sigma of each horizontal axis
  };
  void on_fix(const Envelope& envelope, const GnssFix& fix, EngineOutput& out);
  [[nodiscard]] std::optional<Solution> at(Time t) const;

  StraightLineOptions options_;
  EngineSetup setup_;
  std::optional<Fix> before_, last_;
  std::optional<Time> last_row_;
};

constexpr double kShortestBetweenFixes_s = 0.1;

StraightLine::StraightLine(const StraightLineOptions& options, const EngineSetup& setup)
    : options_(options), setup_(setup) {}

void StraightLine::take(const Envelope& envelope, EngineOutput& out) {
  if (const auto* fix = std::get_if<GnssFix>(&envelope.message)) {
    if (envelope.source < setup_.sources.size() && setup_.sources[envelope.source].body == setup_.body)
      on_fix(envelope, *fix, out);
  } else if (const auto* tick = std::get_if<Tick>(&envelope.message)) {
    const Time now = tick->at.host();
    if (last_row_ && seconds(now - *last_row_) < 0.999 / setup_.common.navigation.output_hz) return;
    if (const auto solution = at(now)) {
      out.publish(now, *solution);
      last_row_ = now;
    }
  }
}

void StraightLine::on_fix(const Envelope& envelope, const GnssFix& fix, EngineOutput& out) {
  FixVerdict verdict{.engine = setup_.id, .position = fix.position};
  if (const auto expected = at(envelope.valid)) {
    const auto residual = geo::difference(expected->position, fix.position);
    verdict.residual_m = std::hypot(residual.north_m, residual.east_m);
  }
  // Two fixes at nearly the same time say nothing of the velocity, one from the past says too little.
  const bool usable = !last_ || seconds(envelope.valid - last_->t) >= kShortestBetweenFixes_s;
  verdict.accepted = usable;
  if (usable) {
    const double assumed_m = setup_.common.aiding.gnss_drms_m / std::sqrt(2.0);
    const double stated_m = std::max(fix.sd_north_m.value_or(assumed_m), fix.sd_east_m.value_or(assumed_m));
    before_ = last_;
    last_ = Fix{envelope.valid, fix.position, std::max(stated_m, 0.1 * assumed_m)};
  }
  out.publish(envelope.valid, verdict, envelope.source);
}

/// p(t) = p2 + (p2 - p1) r with r = (t - t2) / (t2 - t1). Fixes independent:
/// var = (1 + r)^2 s2^2 + r^2 s1^2; an acceleration a that went unseen puts it a tau (tau + dt) / 2 off.
std::optional<Solution> StraightLine::at(Time t) const {
  if (!before_ || !last_) return std::nullopt;
  const double dt = seconds(last_->t - before_->t), tau = seconds(t - last_->t);
  if (tau < 0.0 || tau > options_.longest_s) return std::nullopt;
  const double r = tau / dt;
  const auto step = geo::difference(before_->position, last_->position);
  const double unseen_m = 0.5 * options_.manoeuvre_mps2 * tau * (tau + dt);
  const double var_m2 = (1 + r) * (1 + r) * last_->sd_m * last_->sd_m +
                        r * r * before_->sd_m * before_->sd_m + unseen_m * unseen_m;
  Solution solution;
  solution.engine = setup_.id;
  solution.position = geo::displaced(last_->position, step.north_m * r, step.east_m * r);
  solution.vel_north_mps = step.north_m / dt;
  solution.vel_east_mps = step.east_m / dt;
  solution.var_north_m2 = solution.var_east_m2 = var_m2;
  solution.position_source = PositionSource::gnss;
  return solution;
}

struct Settings final : EngineSettings {
  StraightLineOptions options;

  std::vector<OptionTable> tables() override {
    using O = StraightLineOptions;
    static const std::array<Key<O>, 2> keys{{
        {"manoeuvre_mps2", &O::manoeuvre_mps2, "one sigma of the acceleration between fixes", 0, 100},
        {"longest_s", &O::longest_s, "how long after the last fix there is still a solution", 0, 3600},
    }};
    return {{"straight-line", bind(std::span<const Key<O>>(keys), options)}};
  }
};

}  // namespace

class StraightLinePlugin final : public QObject, public EnginePlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID LEADLINE_ENGINE_PLUGIN FILE "leadline_plugin.json")
  Q_INTERFACES(leadline::EnginePlugin)

 public:
  std::vector<Offer> engines() const override {
    return {{"straight-line", "goes on as between the last two GNSS fixes (an example)"}};
  }
  std::unique_ptr<EngineSettings> settings() const override { return std::make_unique<Settings>(); }
  Result<std::unique_ptr<Engine>> make(std::string_view, const EngineSettings& settings,
                                       const EngineSetup& setup) const override {
    return std::unique_ptr<Engine>(
        std::make_unique<StraightLine>(static_cast<const Settings&>(settings).options, setup));
  }
};

}  // namespace leadline::example

#include "straight_line.moc"
