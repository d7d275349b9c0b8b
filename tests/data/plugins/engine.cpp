// An engine plugin that behaves as TEST_BEHAVIOUR says; its engine is called TEST_ENGINE.

#include <QObject>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>

#include "plugins/sdk/engine_plugin.h"

#ifndef TEST_TABLE
#define TEST_TABLE TEST_ENGINE
#endif

namespace leadline {
namespace {

enum Behaviour { healthy, throws_at_load, throws_when_asked, throws_when_made, throws, blocks, not_finite };
constexpr Behaviour kBehaviour = TEST_BEHAVIOUR;
constexpr int kGoodFixes = 20;

class TestEngine final : public Engine {
 public:
  explicit TestEngine(EngineId id) : id_(id) {}

  void take(const Envelope& envelope, EngineOutput& out) override {
    const auto* fix = std::get_if<GnssFix>(&envelope.message);
    if (fix == nullptr) return;
    Solution solution;
    solution.engine = id_;
    solution.position = fix->position;
    if (++fixes_ > kGoodFixes) {
      if (kBehaviour == throws) throw std::runtime_error("the sea is \x1b[31mtoo rough");
      if (kBehaviour == blocks && fixes_ == kGoodFixes + 1)
        std::this_thread::sleep_for(std::chrono::seconds(4));
      if (kBehaviour == not_finite) solution.var_east_m2 = std::numeric_limits<double>::quiet_NaN();
    }
    out.publish(envelope.valid, solution);
  }

 private:
  EngineId id_;
  int fixes_ = 0;
};

struct Options {
  bool loud = false;
};
struct Settings final : EngineSettings {
  Options options;
  std::vector<OptionTable> tables() override {
    static const Key<Options> key{"loud", &Options::loud, "of no use"};
    return {{TEST_TABLE, bind(std::span<const Key<Options>>(&key, 1), options)}};
  }
};

}  // namespace

class TestPlugin final : public QObject, public EnginePlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID LEADLINE_ENGINE_PLUGIN FILE "leadline_plugin.json")
  Q_INTERFACES(leadline::EnginePlugin)

 public:
  TestPlugin() {
    if (kBehaviour == throws_at_load) throw std::runtime_error("no");
  }
  std::vector<Offer> engines() const override {
    if (kBehaviour == throws_when_asked) throw std::runtime_error("ask somebody else");
    return {{TEST_ENGINE, "for tests"}};
  }
  std::unique_ptr<EngineSettings> settings() const override { return std::make_unique<Settings>(); }
  Result<std::unique_ptr<Engine>> make(std::string_view, const EngineSettings&,
                                       const EngineSetup& setup) const override {
    if (kBehaviour == throws_when_made) throw 7;
    return std::unique_ptr<Engine>(std::make_unique<TestEngine>(setup.id));
  }
};

}  // namespace leadline

#include "engine.moc"
