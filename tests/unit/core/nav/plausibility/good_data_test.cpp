// No instrument that is well is accused: a false alarm is worse than silence.

#include "tests/support/recording.h"
#include "tests/unit/core/nav/plausibility/watched_run.h"

namespace leadline {
namespace {

void print(const std::string& name, const std::vector<test::Finding>& findings) {
  for (const auto& f : findings)
    std::printf("%s %8.1f s %s: %s\n", name.c_str(), f.t_s, f.source.c_str(), f.text.c_str());
}

test::Heard recorded(const std::vector<test::Instrument>& instruments, Body body) {
  const auto replayed = test::replay(instruments, nav::Options{}, body, {});
  test::Heard heard;
  for (const auto& instrument : instruments) {
    SourceInfo info = instrument.info;
    info.id = static_cast<SourceId>(heard.sources.size());
    info.name = instrument.name;
    info.body = body;
    heard.sources.push_back(info);
  }
  std::int64_t tick_ns = 0;
  for (const auto& e : replayed.envelopes) {
    if (tick_ns == 0) tick_ns = e.arrival.ns;
    for (; tick_ns <= e.arrival.ns; tick_ns += 100'000'000) {
      Envelope tick;
      tick.arrival = {tick_ns};
      tick.message = Tick{tick.arrival};
      heard.envelopes.push_back(tick);
    }
    heard.envelopes.push_back(e);
  }
  return heard;
}

TEST(PlausibilityOfGoodData, NoRecordingIsAccused) {
  const auto palmer = [](const char* name) {
    const bool bare = std::string(name) == "gp02" || std::string(name) == "adcp";
    return test::Instrument{
        .name = name,
        .decoder = "nmea0183",
        .path = test::data_path("nmea_openrvdas_nbp1406/NBP1406_" + std::string(name) + "-2014-08-01"),
        .settings = {.checksum_required = !bare}};
  };
  const auto palmers =
      recorded({palmer("s330"), palmer("gyr1"), palmer("gp02"), palmer("adcp"), palmer("knud")}, Body::ship);
  ASSERT_GT(palmers.envelopes.size(), 10000U);
  const auto of_palmer = test::Watched(palmers).findings;
  print("palmer", of_palmer);
  EXPECT_TRUE(of_palmer.empty());
  for (const char* file :
       {"dvl_pd0_adcp/winriver01.PD0", "dvl_pd0_adcp/winriver02.PD0", "dvl_pd0_adcp/RiverPro_test01.PD0",
        "dvl_pd0_adcp/RDI_test01.000", "dvl_pd0_adcp/RDI_7f79.000", "dvl_pd0_adcp/sentinelv_b5.pd0",
        "dvl_pd0_remus600/adcp_auv_3.pd0", "dvl_pd0_remus600/adcp_auv_51.pd0",
        "dvl_pd0_remus600/glider/LA281913.PD0"}) {
    const auto heard =
        recorded({{.name = "adcp", .decoder = "trdi-pd0", .path = test::data_path(file), .stamped = false}},
                 Body::ship);
    const auto findings = test::Watched(heard).findings;
    print(file, findings);
    EXPECT_TRUE(findings.empty()) << file;
  }
  // A boat whose inclinometers stick at their stops, 27 degrees, for eight minutes while her heading turns.
  const auto stuck = recorded({{.name = "adcp",
                                .decoder = "trdi-pd0",
                                .path = test::data_path("dvl_pd0_adcp/RDI_withBT.000"),
                                .stamped = false}},
                              Body::ship);
  const test::Watched watched(stuck);
  print("RDI_withBT", watched.findings);
  EXPECT_EQ(watched.findings.size(), 2U);
  EXPECT_TRUE(watched.named_s("adcp", "its roll and pitch is frozen"));

  const auto sub = recorded({{.name = "sub",
                              .decoder = "mavlink",
                              .path = test::data_path("ardusub_mavlink/small.tlog"),
                              .stamped = false}},
                            Body::vehicle);
  print("ardusub", test::Watched(sub).findings);
  EXPECT_TRUE(test::Watched(sub).findings.empty());
}

TEST(PlausibilityOfGoodData, NoScenarioIsAccusedButTheOneMountedBackwards) {
  // The first 400 s of each; LEADLINE_WHOLE_SCENARIOS in the environment: all of them, 40 s.
  const double longest_s = std::getenv("LEADLINE_WHOLE_SCENARIOS") ? 1e9 : 400.0;
  for (const char* name : {"deep-survey", "deep-survey-paper", "outage", "false-cluster", "hover-run",
                           "north-run", "waypoint-run", "mine-disposal"}) {
    auto scenario = test::scenario(name);
    scenario.options.duration_s = std::min(scenario.options.duration_s, longest_s);
    const auto findings =
        test::Watched(test::simulated(scenario, 1), {}, test::options_of(scenario)).findings;
    print(name, findings);
    EXPECT_TRUE(findings.empty()) << name;
  }
  auto scenario = test::scenario("mount-calibration");
  scenario.options.duration_s = std::min(scenario.options.duration_s, longest_s);
  const test::Watched watched(test::simulated(scenario, 1), {}, test::options_of(scenario));
  print("mount-calibration", watched.findings);
  ASSERT_EQ(watched.findings.size(), 1U);
  EXPECT_LE(watched.named_s("dvl", "mounted at 180 deg").value_or(1e9), 60.0);
}

}  // namespace
}  // namespace leadline
