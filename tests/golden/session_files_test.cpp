// Sessions as a user meets them: recorded by a replay, replayed, exported, refused.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace leadline {
namespace {

using test::data_path;
using test::leadline;
using test::read_text;
using test::scratch_folder;
using test::write_file;

const std::string kPalmerFiles[] = {"fusion.csv", "dead-reckoning.csv", "ship.csv", "fixes.csv",
                                    "dead-reckoning_fixes.csv"};

std::string palmer_inputs() {
  std::string words;
  for (const char* name : {"s330", "gyr1", "gp02", "adcp"})
    words += std::string(" ") + name + "=" +
             data_path("nmea_openrvdas_nbp1406/NBP1406_" + std::string(name) + "-2014-08-01");
  return words;
}

const char* const kBothEngines = " --engine fusion --engine dead-reckoning ";

void expect_same(const std::string& a, const std::string& b, std::initializer_list<const char*> files) {
  for (const char* file : files) EXPECT_EQ(read_text(a + "/" + file), read_text(b + "/" + file)) << file;
}

TEST(Session, LogSessionAndTlogGiveTheSameCsvThreeWays) {
  const std::string folder = scratch_folder(), config = data_path("demo/palmer.toml");
  const auto recorded = leadline("replay --config " + config + palmer_inputs() + kBothEngines + "--csv " +
                                 folder + "/log --session " + folder + "/palmer.leadline");
  ASSERT_EQ(recorded.status, 0) << recorded.err;
  const auto replayed =
      leadline("replay " + folder + "/palmer.leadline" + kBothEngines + "--csv " + folder + "/session");
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  const auto exported =
      leadline("export " + folder + "/palmer.leadline --format tlog --output " + folder + "/palmer.tlog");
  ASSERT_EQ(exported.status, 0) << exported.err;
  const auto from_tlog = leadline("replay " + folder + "/palmer.tlog --config " + config + kBothEngines +
                                  "--csv " + folder + "/tlog");
  ASSERT_EQ(from_tlog.status, 0) << from_tlog.err;
  const auto tables =
      leadline("export " + folder + "/palmer.leadline --format csv --output " + folder + "/export");
  ASSERT_EQ(tables.status, 0) << tables.err;
  for (const auto& file : kPalmerFiles) {
    const std::string log = read_text(folder + "/log/" + file);
    EXPECT_GT(log.size(), 10000u);
    EXPECT_EQ(log, read_text(folder + "/session/" + file)) << file;
    EXPECT_EQ(log, read_text(folder + "/tlog/" + file)) << file;
    EXPECT_EQ(log, read_text(folder + "/export/" + file)) << file;
  }
}

TEST(Session, BinaryStreamsGiveTheSameCsvThreeWays) {
  const std::string folder = scratch_folder(), config = data_path("demo/riverpro.toml");
  ASSERT_EQ(leadline("replay --config " + config + " adcp=" + data_path("dvl_pd0_adcp/RiverPro_test01.PD0") +
                     " --csv " + folder + "/log --session " + folder + "/boat.leadline")
                .status,
            0);
  ASSERT_EQ(leadline("replay " + folder + "/boat.leadline --csv " + folder + "/session").status, 0);
  ASSERT_EQ(
      leadline("export " + folder + "/boat.leadline --format tlog --output " + folder + "/boat.tlog").status,
      0);
  ASSERT_EQ(
      leadline("replay " + folder + "/boat.tlog --config " + config + " --csv " + folder + "/tlog").status,
      0);
  expect_same(folder + "/log", folder + "/session", {"fusion.csv", "fixes.csv"});
  expect_same(folder + "/log", folder + "/tlog", {"fusion.csv", "fixes.csv"});
}

TEST(Session, ALongTableGivesTheSameCsvThreeWays) {
  const std::string folder = scratch_folder();
  std::string table = "unix_s,lat,lon,heading,vx,vy\n";
  for (int i = 0; i < 20000; ++i) {
    char row[160];
    std::snprintf(row, sizeof row, "%.2f,%.9f,%.9f,%.3f,%.4f,%.4f\n", 1700000000.0 + 0.2 * i, 59.0 + 1e-6 * i,
                  5.0 + 2e-7 * i, 5.0 + 0.001 * (i % 100), 0.55 + 0.001 * (i % 7), 0.02);
    table += row;
  }
  write_file(folder + "/survey.csv", table);
  const std::string config = write_file(folder + "/survey.toml", R"(version = 1
[navigation]
body = "ship"
[[source]]
name = "survey"
decoder = "table"
body = "ship"
skip_lines = 1
columns = ["unix_s", "lat_deg", "lon_deg", "heading_deg", "vel_x_mps", "vel_y_mps"]
)");
  ASSERT_EQ(leadline("replay --config " + config + " survey=" + folder + "/survey.csv --csv " + folder +
                     "/log --session " + folder + "/survey.leadline")
                .status,
            0);
  ASSERT_EQ(leadline("replay " + folder + "/survey.leadline --csv " + folder + "/session").status, 0);
  ASSERT_EQ(
      leadline("export " + folder + "/survey.leadline --format tlog --output " + folder + "/survey.tlog")
          .status,
      0);
  expect_same(folder + "/log", folder + "/session", {"fusion.csv", "fixes.csv", "ship.csv"});
  EXPECT_GT(read_text(folder + "/log/fusion.csv").size(), 1000000u);
}

TEST(Session, ReplayedIntoItselfGetsAnotherRunAndNoSecondCopyOfItsFrames) {
  const std::string folder = scratch_folder(), file = folder + "/boat.leadline";
  ASSERT_EQ(leadline("replay --config " + data_path("demo/riverpro.toml") +
                     " adcp=" + data_path("dvl_pd0_adcp/RiverPro_test01.PD0") + " --session " + file)
                .status,
            0);
  const auto size = std::filesystem::file_size(file);
  const auto again = leadline("replay " + file + " --engine dead-reckoning --session " + file);
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_LT(std::filesystem::file_size(file), size * 2);
  ASSERT_EQ(leadline("replay " + file + " --csv " + folder + "/after").status, 0);
}

TEST(Session, AnExistingOutputIsRefusedWithoutForce) {
  const std::string folder = scratch_folder(), file = folder + "/a.leadline";
  const std::string words = "replay --config " + data_path("demo/riverpro.toml") +
                            " adcp=" + data_path("dvl_pd0_adcp/RiverPro_test01.PD0") + " --session " + file;
  ASSERT_EQ(leadline(words).status, 0);
  const auto refused = leadline(words);
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  EXPECT_EQ(leadline(words + " --force").status, 0);
  ASSERT_EQ(leadline("export " + file + " --format tlog --output " + folder + "/a.tlog").status, 0);
  EXPECT_EQ(leadline("export " + file + " --format tlog --output " + folder + "/a.tlog").status, 1);
}

TEST(Session, WhatIsNoSessionIsRefusedAndLeftAlone) {
  const std::string folder = scratch_folder();
  const std::string note = write_file(folder + "/note.txt", "dear diary\n");
  EXPECT_EQ(leadline("export " + note + " --format tlog").status, 1);
  EXPECT_EQ(read_text(note), "dear diary\n");
  EXPECT_EQ(leadline("export " + folder + "/none.leadline --format tlog").status, 1);
  const auto unconfigured = leadline("replay x=" + note);
  EXPECT_EQ(unconfigured.status, 2);
  EXPECT_NE(unconfigured.err.find("--config"), std::string::npos) << unconfigured.err;
}

TEST(Session, InfoAccountsForItsFramesAndItsFile) {
  const std::string folder = scratch_folder(), file = folder + "/boat.leadline";
  ASSERT_EQ(leadline("replay --config " + data_path("demo/riverpro.toml") +
                     " adcp=" + data_path("dvl_pd0_adcp/RiverPro_test01.PD0") + " --session " + file)
                .status,
            0);
  const auto ran = leadline("info --json " + file);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto info = nlohmann::json::parse(ran.out)["files"][0];
  EXPECT_EQ(info["kind"], "session");
  EXPECT_EQ(info["frames"], 273);
  std::uint64_t sum = 0;
  for (const auto& [name, bytes] : info["byte_classes"].items()) sum += bytes.get<std::uint64_t>();
  EXPECT_EQ(sum, std::filesystem::file_size(file));
}

}  // namespace
}  // namespace leadline
