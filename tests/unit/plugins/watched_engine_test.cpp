#include "plugins/host/watched_engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <thread>

#include "tests/unit/plugins/facts.h"

namespace leadline {
namespace {

using std::chrono::milliseconds;
using test::fact;
using test::fix_at;
using test::Heard;
using testing::HasSubstr;

/// An engine from a lambda.
class Scripted final : public Engine {
 public:
  using Script = std::function<void(const Envelope&, EngineOutput&)>;
  explicit Scripted(Script script) : script_(std::move(script)) {}
  void take(const Envelope& envelope, EngineOutput& out) override { script_(envelope, out); }

 private:
  Script script_;
};

std::unique_ptr<Engine> watched(Scripted::Script script, milliseconds patience = milliseconds(5000)) {
  return WatchedEngine::start({.engine = "e", .plugin = "p", .id = 3, .patience = patience},
                              [script]() -> Result<std::unique_ptr<Engine>> {
                                return std::unique_ptr<Engine>(std::make_unique<Scripted>(script));
                              })
      .value();
}

void say(const Envelope& envelope, EngineOutput& out, double var_m2 = 1.0) {
  Solution solution{.engine = 3, .var_north_m2 = var_m2, .var_east_m2 = 1.0};
  out.publish(envelope.valid, solution, envelope.source);
}

TEST(WatchedEngine, PassesEachAnswerOnBeforeTheNextMessage) {
  int n = 0;
  const auto engine = watched([&](const Envelope& e, EngineOutput& out) {
    for (int i = 0; i <= n % 3; ++i) say(e, out, 1.0 + n * 10 + i);
    ++n;
  });
  Heard heard;
  std::vector<double> expected;
  for (int i = 0; i < 500; ++i) {
    engine->take(fact(i, Pressure{}), heard);
    for (int k = 0; k <= i % 3; ++k) expected.push_back(1.0 + i * 10 + k);
    ASSERT_EQ(heard.messages.size(), expected.size());
    EXPECT_EQ(heard.messages.back().valid, test::at_s(i));
    EXPECT_EQ(heard.messages.back().source, 0);
  }
  const auto rows = heard.all<Solution>();
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].var_north_m2, expected[i]);
}

TEST(WatchedEngine, RunsOnOneThreadOfItsOwn) {
  std::set<std::thread::id> threads;
  {
    const auto engine = WatchedEngine::start({}, [&]() -> Result<std::unique_ptr<Engine>> {
      threads.insert(std::this_thread::get_id());
      return std::unique_ptr<Engine>(std::make_unique<Scripted>(
          [&](const Envelope&, EngineOutput&) { threads.insert(std::this_thread::get_id()); }));
    });
    ASSERT_TRUE(engine.ok());
    Heard heard;
    for (int i = 0; i < 10; ++i) engine.value()->take(fact(i, Pressure{}), heard);
  }
  EXPECT_EQ(threads.size(), 1u);
  EXPECT_FALSE(threads.contains(std::this_thread::get_id()));
}

TEST(WatchedEngine, NeverSeesRawBytes) {
  int taken = 0;
  const auto engine = watched([&](const Envelope&, EngineOutput&) { ++taken; });
  Heard heard;
  const std::vector<std::uint8_t> bytes(10);
  engine->take(fact(0, RawFrame{bytes}), heard);
  engine->take(fact(0, Tick{}), heard);
  EXPECT_EQ(taken, 1);
}

/// The engine's third answer is wrong; gives what was said and checks that it was taken out.
Heard taken_out(const Scripted::Script& wrong, milliseconds patience = milliseconds(5000)) {
  struct Counts {
    std::atomic<int> taken{0};
  };
  const auto counts = std::make_shared<Counts>();  // an engine that blocks outlives this function
  Heard heard;
  {
    const auto engine = watched(
        [counts, wrong](const Envelope& e, EngineOutput& out) {
          ++counts->taken;
          say(e, out);
          if (counts->taken == 3) wrong(e, out);
        },
        patience);
    for (int i = 0; i < 10; ++i) engine->take(fact(i, Pressure{}), heard);
    EXPECT_FALSE(static_cast<WatchedEngine&>(*engine).in_service());
  }
  EXPECT_EQ(counts->taken, 3) << "it was fed after it was taken out";
  EXPECT_EQ(heard.all<Solution>().size(), 2u) << "nothing of the wrong answer is passed on";
  const auto alarms = heard.all<Alarm>();
  EXPECT_EQ(alarms.size(), 1u);
  EXPECT_EQ(heard.messages.size(), 3u);
  EXPECT_EQ(heard.messages.back().valid, test::at_s(2));
  for (const auto& alarm : alarms) {
    EXPECT_EQ(alarm.priority, Alarm::Priority::alarm);
    EXPECT_THAT(std::string(alarm.text.view()), HasSubstr("engine \"e\" of plugin \"p\" is out of service"));
    std::cout << alarm.reason.view() << ": " << alarm.text.view() << "\n";
  }
  return heard;
}

TEST(WatchedEngine, ThatThrowsIsTakenOut) {
  auto heard =
      taken_out([](const Envelope&, EngineOutput&) { throw std::runtime_error("sea\x1b[31m\nstate 9"); });
  EXPECT_EQ(heard.all<Alarm>().at(0).reason, "exception");
  EXPECT_THAT(std::string(heard.all<Alarm>()[0].text.view()), HasSubstr("it threw sea?[31m?state 9"));
  heard = taken_out([](const Envelope&, EngineOutput&) { throw 42; });
  EXPECT_EQ(heard.all<Alarm>().at(0).reason, "exception");
}

TEST(WatchedEngine, ThatBlocksIsTakenOutAndMayWakeWhenAllElseIsGone) {
  const auto woken = std::make_shared<std::atomic<bool>>(false);
  const auto heard = taken_out(
      [woken](const Envelope& e, EngineOutput& out) {
        const Envelope copy = e;
        std::this_thread::sleep_for(milliseconds(400));
        for (int i = 0; i < 5000; ++i) say(e, out);
        EXPECT_EQ(copy.valid, e.valid);
        *woken = true;
      },
      milliseconds(50));
  EXPECT_EQ(heard.all<Alarm>().at(0).reason, "blocked");
  EXPECT_FALSE(*woken);
  while (!*woken) std::this_thread::sleep_for(milliseconds(10));
  std::this_thread::sleep_for(milliseconds(50));  // it leaves by itself; the sanitizer looks on
}

TEST(WatchedEngine, WithAResultThatCannotBeIsTakenOut) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      taken_out([](const Envelope& e, EngineOutput& out) { say(e, out, kNan); }).all<Alarm>().at(0).reason,
      "not finite");
  EXPECT_EQ(
      taken_out([](const Envelope& e, EngineOutput& out) { say(e, out, -1.0); }).all<Alarm>().at(0).reason,
      "range");
  EXPECT_EQ(
      taken_out([](const Envelope& e, EngineOutput& out) { out.publish(e.valid, Solution{.engine = 0}); })
          .all<Alarm>()
          .at(0)
          .reason,
      "foreign id");
  EXPECT_EQ(taken_out([](const Envelope& e, EngineOutput& out) { out.publish(e.valid, GnssFix{}); })
                .all<Alarm>()
                .at(0)
                .reason,
            "foreign message");
  EXPECT_EQ(taken_out([](const Envelope& e, EngineOutput& out) {
              for (int i = 0; i < 2000; ++i) say(e, out);
            })
                .all<Alarm>()
                .at(0)
                .reason,
            "flood");
}

TEST(WatchedEngine, ThatCannotBeMadeIsAnErrorAtTheDoor) {
  const WatchedEngine::Watch watch{.engine = "e", .plugin = "p", .patience = milliseconds(50)};
  auto threw = WatchedEngine::start(watch, []() -> Result<std::unique_ptr<Engine>> { throw 1; });
  ASSERT_FALSE(threw.ok());
  EXPECT_THAT(threw.error().line(), HasSubstr("engine \"e\" of plugin \"p\" could not be made: it threw"));
  auto refused = WatchedEngine::start(watch, []() -> Result<std::unique_ptr<Engine>> {
    return Error{"needs a DVL", "", ""};
  });
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().line(), HasSubstr("needs a DVL"));
  auto nothing = WatchedEngine::start(
      watch, []() -> Result<std::unique_ptr<Engine>> { return std::unique_ptr<Engine>(); });
  EXPECT_FALSE(nothing.ok());
  auto waited = WatchedEngine::start(watch, []() -> Result<std::unique_ptr<Engine>> {
    std::this_thread::sleep_for(milliseconds(200));
    return Error{"too late", "", ""};
  });
  ASSERT_FALSE(waited.ok());
  EXPECT_THAT(waited.error().line(), HasSubstr("it did not answer for 0.05 s"));
  std::this_thread::sleep_for(milliseconds(300));
}

TEST(WatchedEngine, ThatBlocksInItsDestructorIsLeftAlone) {
  struct Sticky final : Engine {
    std::shared_ptr<std::atomic<bool>> gone;
    void take(const Envelope&, EngineOutput&) override {}
    ~Sticky() override {
      std::this_thread::sleep_for(milliseconds(300));
      *gone = true;
    }
  };
  const auto gone = std::make_shared<std::atomic<bool>>(false);
  {
    auto engine =
        WatchedEngine::start({.patience = milliseconds(50)}, [gone]() -> Result<std::unique_ptr<Engine>> {
          auto sticky = std::make_unique<Sticky>();
          sticky->gone = gone;
          return std::unique_ptr<Engine>(std::move(sticky));
        });
    ASSERT_TRUE(engine.ok());
  }
  EXPECT_FALSE(*gone);
  while (!*gone) std::this_thread::sleep_for(milliseconds(10));
  std::this_thread::sleep_for(milliseconds(50));
}

TEST(WatchedEngine, CostsMicrosecondsAMessage) {
  const auto engine = watched([](const Envelope& e, EngineOutput& out) { say(e, out); });
  Heard heard;
  constexpr int kMessages = 20000;
  heard.messages.reserve(kMessages);
  const auto begun = std::chrono::steady_clock::now();
  for (int i = 0; i < kMessages; ++i) engine->take(fact(i * 0.01, Pressure{}), heard);
  const double us =
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count();
  std::cout << us / kMessages << " us a message handed over and answered\n";
  EXPECT_EQ(heard.messages.size(), static_cast<std::size_t>(kMessages));
  EXPECT_LT(us / kMessages, 1000.0);
}

}  // namespace
}  // namespace leadline
