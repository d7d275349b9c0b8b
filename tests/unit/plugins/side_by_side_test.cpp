// A house engine beside third parties' that fail: recording and its solutions go on, bit for bit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <iostream>

#include "core/flow/bus.h"
#include "plugins/host/plugin_host.h"
#include "tests/unit/plugins/facts.h"

namespace leadline {
namespace {

using testing::HasSubstr;

constexpr int kSteps = 600;  // of 0.1 s

/// One byte is one instant of a made-up survey: heading, bottom velocity, a fix each second.
class Survey final : public Decoder {
 public:
  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) override {
    for ([[maybe_unused]] const auto byte : bytes) {
      const double t = 0.1 * n_;
      out.fact({}, Heading{.heading = Angle::deg(30.0 + 20.0 * std::sin(0.05 * t))});
      out.fact({},
               DvlVelocity{.frame = DvlFrame::ship, .x_mps = 1.5, .y_mps = 0.1 * std::sin(t), .valid = true});
      if (n_ % 10 == 0) out.fact({}, test::fix_at(1.2 * t + std::sin(3 * t), 0.8 * t + std::cos(5 * t)));
      out.frame({.kind = "instant", .offset = static_cast<std::uint64_t>(n_++), .length = 1});
    }
  }
  void finish(DecoderOutput&) override {}

 private:
  int n_ = 0;
};

struct Kept final : Sink {
  int raw_frames = 0;
  std::vector<Envelope> solutions;  // of engine 0
  std::vector<Alarm> alarms;
  std::vector<int> rows = std::vector<int>(10);  // of each engine
  void take(const Envelope& envelope) override {
    if (std::holds_alternative<RawFrame>(envelope.message)) ++raw_frames;
    if (const auto* alarm = std::get_if<Alarm>(&envelope.message)) alarms.push_back(*alarm);
    if (const auto* solution = std::get_if<Solution>(&envelope.message)) {
      ++rows.at(solution->engine);
      if (solution->engine == 0) solutions.push_back(envelope);
    }
  }
};

/// Runs the survey through "fusion" and then the named engines of test plugins.
Kept run(const std::vector<std::string>& guests) {
  PluginSearch search{.program = program_folder()};
  for (auto name : guests) {
    std::replace(name.begin(), name.end(), '-', '_');
    search.plugin_paths.push_back(std::filesystem::path(LEADLINE_TEST_PLUGINS) / name);
  }
  const auto host = PluginHost::load(search);
  for (const auto& refusal : host.refusals()) ADD_FAILURE() << refusal.line();
  const auto tables = host.engine_tables();
  Kept kept;
  Bus bus({SourceInfo{.id = 0, .name = "survey"}});
  bus.attach(0, std::make_unique<Survey>());
  bus.attach(kept);
  std::vector<std::string> names{"fusion"};
  names.insert(names.end(), guests.begin(), guests.end());
  std::vector<std::unique_ptr<Engine>> engines;
  for (const auto& name : names) {
    auto engine = host.make_engine(
        name, tables, {.id = static_cast<EngineId>(engines.size()), .sources = bus.sources()}, nullptr);
    EXPECT_TRUE(engine.ok()) << engine.error().line();
    engines.push_back(std::move(engine).value());
    bus.attach(*engines.back());
  }
  const std::uint8_t byte = 0;
  for (int i = 0; i < kSteps; ++i)
    bus.take({.source = 0, .arrival = arrival_at(test::at_s(0.1 * i)), .bytes = {&byte, 1}});
  bus.finish();
  return kept;
}

bool same_bits(const Envelope& a, const Envelope& b) {
  const auto& x = std::get<Solution>(a.message);
  const auto& y = std::get<Solution>(b.message);
  const auto bits = [](double v) {
    std::uint64_t u;
    std::memcpy(&u, &v, sizeof u);
    return u;
  };
  return a.valid == b.valid && a.arrival == b.arrival && x == y &&
         bits(x.position.lat.rad()) == bits(y.position.lat.rad()) &&
         bits(x.position.lon.rad()) == bits(y.position.lon.rad()) &&
         bits(x.var_north_m2) == bits(y.var_north_m2) &&
         bits(x.cov_north_east_m2) == bits(y.cov_north_east_m2) && bits(x.var_east_m2) == bits(y.var_east_m2);
}

TEST(SideBySide, FailingEnginesAreTakenOutAndTheRestGoesOnBitForBit) {
  const Kept alone = run({});
  ASSERT_GT(alone.solutions.size(), 500u);
  const auto begun = std::chrono::steady_clock::now();
  const Kept beside = run({"throws", "blocks", "not-finite", "healthy"});
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();

  EXPECT_EQ(beside.raw_frames, kSteps) << "records lost";
  ASSERT_EQ(beside.solutions.size(), alone.solutions.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < alone.solutions.size(); ++i)
    different += same_bits(alone.solutions[i], beside.solutions[i]) ? 0 : 1;
  EXPECT_EQ(different, 0u);
  for (const int failing : {1, 2, 3})
    EXPECT_EQ(beside.rows[static_cast<std::size_t>(failing)], 20) << failing;
  EXPECT_EQ(beside.rows[4], kSteps / 10) << "the healthy guest";

  std::vector<std::string> reasons;
  for (const auto& alarm : beside.alarms) {
    reasons.emplace_back(alarm.reason.view());
    std::cout << alarm.text.view() << "\n";
    EXPECT_THAT(std::string(alarm.text.view()), HasSubstr("is out of service: it "));
  }
  EXPECT_THAT(reasons, testing::ElementsAre("exception", "blocked", "not finite"));
  std::cout << alone.solutions.size() << " solutions alike; the engine that blocked cost " << took_s
            << " s\n";
  EXPECT_GE(took_s, 2.0);
}

TEST(SideBySide, AGuestGivesTheSameBitsTwiceAndTheSameAsOnTheCoreThread) {
  // The navigation plugin named by --plugin-path is a guest: its engines run watched.
  const Kept house = run({});
  const auto guest_run = [] {
    const auto host =
        PluginHost::load({.program = "/nonexistent", .plugin_paths = {program_folder() / "plugins"}});
    const auto tables = host.engine_tables();
    Kept kept;
    Bus bus({SourceInfo{.id = 0, .name = "survey"}});
    bus.attach(0, std::make_unique<Survey>());
    bus.attach(kept);
    const auto engine =
        host.make_engine("fusion", tables, {.sources = bus.sources()}, nullptr).value().release();
    const std::unique_ptr<Engine> owner(engine);
    bus.attach(*engine);
    const std::uint8_t byte = 0;
    for (int i = 0; i < kSteps; ++i)
      bus.take({.source = 0, .arrival = arrival_at(test::at_s(0.1 * i)), .bytes = {&byte, 1}});
    bus.finish();
    return kept;
  };
  for (const Kept& guest : {guest_run(), guest_run()}) {
    EXPECT_TRUE(guest.alarms.empty());
    ASSERT_EQ(guest.solutions.size(), house.solutions.size());
    for (std::size_t i = 0; i < house.solutions.size(); ++i)
      ASSERT_TRUE(same_bits(house.solutions[i], guest.solutions[i])) << i;
  }
}

}  // namespace
}  // namespace leadline
