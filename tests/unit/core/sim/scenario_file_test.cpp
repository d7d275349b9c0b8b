#include "app/scenario_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/config/document.h"
#include "tests/unit/core/sim/simulated.h"

namespace leadline::sim {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kGood = R"(version = 1
[scenario]
duration_s = 10.0
[vehicle]
speed_mps = 1.0
max_speed_mps = 2.0
[[vehicle.leg]]
heading_deg = 0.0
duration_s = 5.0
[[sensor]]
name = "dvl"
kind = "dvl"
noise_mps = 0.01
)";

std::vector<std::string> problems_of(const std::string& text) {
  return app::parse_scenario(text, "s.toml").problems;
}
std::string with(const std::string& line, const std::string& instead) {
  std::string text = kGood;
  const auto at = text.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  return text.replace(at, line.size(), instead);
}

TEST(ScenarioFile, AGoodOneHasNoProblems) { EXPECT_THAT(problems_of(kGood), ElementsAre()); }

TEST(ScenarioFile, AnUnknownKeyNamesTheNearest) {
  EXPECT_THAT(problems_of(with("noise_mps", "noize_mps")),
              ElementsAre(AllOf(HasSubstr("s.toml:13"), HasSubstr("nearest known key is noise_mps"))));
}

TEST(ScenarioFile, ANegativeSigmaIsRefusedWithItsLine) {
  EXPECT_THAT(problems_of(with("noise_mps = 0.01", "noise_mps = -0.01")),
              ElementsAre(AllOf(HasSubstr("s.toml:13: sensor \"dvl\".noise_mps"), HasSubstr("from 0"))));
}

TEST(ScenarioFile, ARouteFasterThanTheVehicleIsImpossible) {
  EXPECT_THAT(problems_of(with("duration_s = 5.0", "duration_s = 5.0\nspeed_mps = 2.5")),
              ElementsAre(AllOf(HasSubstr("s.toml:10"), HasSubstr("vehicle.leg[1].speed_mps"),
                                HasSubstr("impossible route"), HasSubstr("2.5 m/s is faster"))));
}

TEST(ScenarioFile, ADiveSteeperThanTheVehicleIsImpossible) {
  EXPECT_THAT(problems_of(with("duration_s = 5.0", "duration_s = 5.0\ndepth_m = 50.0")),
              ElementsAre(AllOf(HasSubstr("s.toml:10"), HasSubstr("impossible route"), HasSubstr("10 m/s"))));
}

TEST(ScenarioFile, ARouteBelowTheSeabedIsImpossible) {
  EXPECT_THAT(problems_of(with("speed_mps = 1.0", "speed_mps = 1.0\ndepth_m = 150.0")),
              ElementsAre(AllOf(HasSubstr("s.toml:6: vehicle.depth_m"), HasSubstr("below the seabed"))));
}

TEST(ScenarioFile, AWaypointAgainstTheStreamIsImpossible) {
  const std::string text = with("heading_deg = 0.0\nduration_s = 5.0", "north_m = 50.0\neast_m = 0.0") +
                           "[water]\ncurrent_mps = 1.5\n";
  EXPECT_THAT(problems_of(text),
              ElementsAre(AllOf(HasSubstr("s.toml:7"), HasSubstr("cannot reach a waypoint"))));
}

TEST(ScenarioFile, ALegWithoutAnEndIsRefused) {
  EXPECT_THAT(problems_of(with("duration_s = 5.0", "")), ElementsAre(HasSubstr("has no end")));
}

TEST(ScenarioFile, SensorsNeedTheirBodyTheirFormatAndTheirSentences) {
  EXPECT_THAT(problems_of(std::string(kGood) + "body = \"ship\"\n"),
              ElementsAre(AllOf(HasSubstr("s.toml:14"), HasSubstr("there is no [ship]"))));
  EXPECT_THAT(problems_of(std::string(kGood) + "sentences = [\"GGA\"]\n"),
              ElementsAre(HasSubstr("a dvl does not speak \"GGA\"")));
  EXPECT_THAT(problems_of(with("kind = \"dvl\"\nnoise_mps = 0.01", "kind = \"usbl\"\ntransponder = \"B01\"")),
              ElementsAre(HasSubstr("a USBL transceiver is the ship's")));
  EXPECT_THAT(problems_of(with("kind = \"dvl\"\nnoise_mps = 0.01", "kind = \"imu\"\nformat = \"nmea0183\"")),
              ElementsAre(HasSubstr("a imu speaks table")));
}

TEST(ScenarioFile, FaultsThatMakeNoSenseAreRefused) {
  EXPECT_THAT(problems_of(std::string(kGood) + "[[sensor.fault]]\nkind = \"false-fixes\"\n"),
              ElementsAre(AllOf(HasSubstr("s.toml:15"), HasSubstr("false fixes need"))));
  EXPECT_THAT(
      problems_of(std::string(kGood) + "[[sensor.fault]]\nkind = \"freeze\"\nfrom_s = 5.0\nuntil_s = 4.0\n"),
      ElementsAre(HasSubstr("is not after from_s")));
}

TEST(ScenarioFile, GivesAConfigurationOfItsSources) {
  Scenario scenario = shipped("mine-disposal");
  const Simulation simulation(scenario, 1, nullptr);
  const std::string text = replay_configuration(scenario, simulation.at_start());
  auto document = config::Document::parse(text, "leadline.toml");
  for (const auto& problem : document.problems()) ADD_FAILURE() << problem.line_text();
  auto sources = document.root().tables("source");
  ASSERT_EQ(sources.size(), scenario.sensors.size());
  EXPECT_THAT(text, HasSubstr("name = \"dvl\"\ndecoder = \"trdi-pd0\"\nbody = \"vehicle\"\nlatency_s = "
                              "0.1\ntime_offset_s = -0.4\n"));
  EXPECT_THAT(text, HasSubstr("name = \"usbl-target\"\ndecoder = \"nmea0183\"\nbody = \"target\""));
  EXPECT_THAT(text, HasSubstr("address = \"9\""));
}

}  // namespace
}  // namespace leadline::sim
