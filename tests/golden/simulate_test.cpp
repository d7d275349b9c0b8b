// `leadline simulate` through the command line: what it writes replays, twice is the same, and a scenario
// that cannot be is refused with its line.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/support/program.h"

namespace leadline {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string scenario(const std::string& name) {
  return std::string(LEADLINE_TEST_DATA) + "/scenarios/" + name + ".toml";
}

std::string with(const std::string& text, const std::string& from, const std::string& to) {
  std::string changed = text;
  const auto at = changed.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) changed.replace(at, from.size(), to);
  return changed;
}

/// unix_s, lat_deg, lon_deg of the rows of a file with solution columns.
std::vector<std::array<double, 3>> rows_of(const std::string& path) {
  std::istringstream lines(test::read_text(path));
  std::string line;
  std::getline(lines, line);
  std::vector<std::array<double, 3>> rows;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string unix_s, utc, lat, lon;
    std::getline(fields, unix_s, ',');
    std::getline(fields, utc, ',');
    std::getline(fields, lat, ',');
    std::getline(fields, lon, ',');
    rows.push_back({std::stod(unix_s), std::stod(lat), std::stod(lon)});
  }
  return rows;
}

TEST(Simulate, TheSameSeedWritesTheSameBytesAndAnotherOneOthers) {
  const std::string folder = test::scratch_folder();
  for (const std::string run : {"a", "b", "c --seed 7"}) {
    const auto ran = test::leadline("simulate " + scenario("hover-run") + " --output " + folder + "/" + run);
    ASSERT_EQ(ran.status, 0) << ran.err;
  }
  for (const char* file : {"telegrams.tlog", "truth.csv", "leadline.toml", "gps.nmea", "dvl.pd0"})
    EXPECT_EQ(test::read_text(folder + "/a/" + file), test::read_text(folder + "/b/" + file)) << file;
  EXPECT_NE(test::read_text(folder + "/a/telegrams.tlog"), test::read_text(folder + "/c/telegrams.tlog"));
  EXPECT_EQ(test::read_text(folder + "/a/truth.csv"), test::read_text(folder + "/c/truth.csv"));
}

TEST(Simulate, WhatItWritesReplaysWithoutARefusal) {
  const std::string folder = test::scratch_folder();
  ASSERT_EQ(test::leadline("simulate " + scenario("hover-run") + " --output " + folder + "/sim").status, 0);
  const auto ran = test::leadline("replay " + folder + "/sim/telegrams.tlog --config " + folder +
                                  "/sim/leadline.toml --engine fusion --csv " + folder + "/csv");
  EXPECT_EQ(ran.status, 0) << ran.err;
  const auto truth = rows_of(folder + "/sim/truth.csv"), solution = rows_of(folder + "/csv/fusion.csv");
  ASSERT_GT(truth.size(), 500U);
  ASSERT_GT(solution.size(), 100U);
  // The last row lies near the truth of its moment: 0.42 m of GNSS, a compass 5 degrees off over 16 m.
  const auto& last = solution.back();
  const auto at = std::min_element(truth.begin(), truth.end(), [&](const auto& a, const auto& b) {
    return std::abs(a[0] - last[0]) < std::abs(b[0] - last[0]);
  });
  const double north_m = (last[1] - (*at)[1]) * 111'000.0;
  const double east_m = (last[2] - (*at)[2]) * 111'000.0 * std::cos(last[1] * 3.14159265358979 / 180.0);
  EXPECT_LT(std::hypot(north_m, east_m), 1.5);
}

TEST(Simulate, DoesNotWriteOverAFolderUnlessTold) {
  const std::string folder = test::scratch_folder();
  const std::string words = "simulate " + scenario("hover-run") + " --output " + folder + "/sim";
  ASSERT_EQ(test::leadline(words).status, 0);
  const auto again = test::leadline(words);
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.err, HasSubstr("holds a simulation already"));
  EXPECT_EQ(test::leadline(words + " --force").status, 0);
}

TEST(Simulate, RefusesWhatCannotBeWithFileLineAndReason) {
  const std::string folder = test::scratch_folder();
  const std::string good = test::read_text(scenario("hover-run"));
  const auto refused = [&](const std::string& text, const char* line, const char* reason) {
    const std::string path = test::write_file(folder + "/s.toml", text);
    const auto ran = test::leadline("simulate " + path + " --output " + folder + "/out");
    EXPECT_EQ(ran.status, 2) << ran.err;
    EXPECT_THAT(ran.err, AllOf(HasSubstr("s.toml:" + std::string(line)), HasSubstr(reason)));
    EXPECT_FALSE(std::filesystem::exists(folder + "/out"));
  };
  refused(with(good, "duration_s = 60.0", "duratoin_s = 60.0"), "8:", "duration_s");
  refused(with(good, "tilt_noise_deg = 0.2", "tilt_noise_deg = -0.2"), "", "tilt_noise_deg");
  refused(with(good, "speed_mps = 0.335\nduration_s = 20.0", "speed_mps = 3.35\nduration_s = 20.0"), "",
          "speed");
  refused(with(good, "kind = \"gnss\"", "kind = \"gnsss\""), "", "gnss");
  refused("version = 1\n[scenario\n", "", "");
}

}  // namespace
}  // namespace leadline
