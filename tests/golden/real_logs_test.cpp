// Real recordings through the program: where each byte went, and a vehicle at rest stays where it is.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/decode/nmea0183.h"
#include "tests/support/decoder_harness.h"
#include "tests/support/program.h"

namespace leadline {
namespace {

using nlohmann::json;
using test::data_path;

json account_of(const std::string& path) {
  const auto ran = test::leadline("info --json " + data_path(path));
  return json::parse(ran.out).at("files").at(0);
}
int count_of(const json& file, const std::string& kind) {
  int count = 0;
  for (const auto& source : file.at("sources"))
    if (source.at("kind") == kind) count += source.at("count").get<int>();
  return count;
}

TEST(RealLogs, EveryLineOfThePalmersInstrumentsIsDecoded) {
  for (const char* name : {"s330", "gyr1", "gp02", "adcp", "mbdp"}) {
    const json file = account_of("nmea_openrvdas_nbp1406/NBP1406_" + std::string(name) + "-2014-08-01");
    const auto& bytes = file.at("byte_classes");
    EXPECT_EQ(file.at("frames"), 5000) << name;
    EXPECT_EQ(bytes.at("decoded").get<int>() + bytes.at("stamp").get<int>(), file.at("bytes")) << name;
    EXPECT_TRUE(file.at("refused").empty()) << name;
  }
}

TEST(RealLogs, EveryEnsembleOfEveryPd0FileIsDecoded) {
  const std::vector<std::tuple<std::string, int, std::string>> files = {
      {"dvl_pd0_adcp/RDI_withBT.000", 1721, R"({"truncated":1})"},
      {"dvl_pd0_adcp/RDI_test01.000", 22, R"({"truncated":1})"},
      {"dvl_pd0_adcp/RDI_7f79.000", 60, R"({"truncated":1})"},
      {"dvl_pd0_adcp/RiverPro_test01.PD0", 273, "{}"},
      {"dvl_pd0_adcp/winriver01.PD0", 262, "{}"},
      {"dvl_pd0_adcp/winriver02.PD0", 75, R"({"nmea body":1500,"nmea text":25})"},
      {"dvl_pd0_adcp/sentinelv_b5.pd0", 50, R"({"truncated":1})"},
      {"dvl_pd0_remus600/adcp_auv_3.pd0", 3, "{}"},
      {"dvl_pd0_remus600/adcp_auv_51.pd0", 51, "{}"},
      {"dvl_pd0_remus600/glider/LA100204.PD0", 107, "{}"},
      {"dvl_pd0_remus600/glider/LA281913.PD0", 19, "{}"},
      {"dvl_pd0_remus600/glider/LB180210_50.PD0", 50, "{}"},
      {"dvl_pd0_remus600/glider/LB180210_3_corrupted.PD0", 2, R"({"checksum":1})"},
      {"dvl_pd0_remus600/glider/ND072023.PD0", 54, "{}"},
      {"dvl_pd0_remus600/glider/NE051400.PD0", 193, "{}"}};
  for (const auto& [path, ensembles, refused] : files) {
    const json file = account_of(path);
    EXPECT_EQ(count_of(file, "ensemble"), ensembles) << path;
    EXPECT_EQ(file.at("refused"), json::parse(refused)) << path;
    EXPECT_EQ(file.at("byte_classes").at("skipped"), 0) << path;
  }
}

/// Every kind a log's sentences were reported under, refused ones too.
std::set<std::string> kinds_of(const std::string& path) {
  DecoderSettings settings;
  settings.checksum_required = false;
  const auto decoder = decode::make_nmea0183(settings);
  const auto bytes = test::read_bytes(data_path(path));
  std::set<std::string> kinds;
  for (const auto& report : test::decode_all(*decoder, bytes).frames) kinds.emplace(report.kind);
  return kinds;
}

TEST(RealLogs, EverySentenceKindOfTheGofreeStreamIsNamed) {
  const std::set<std::string> known = {"VDM", "GGA", "GLL", "GSA", "GSV", "RMC", "VTG", "ZDA",
                                       "AAM", "APB", "BOD", "RMB", "XTE", "DBT", "DPT", "MTW",
                                       "VLW", "VHW", "HDG", "MWD", "MWV", "XDR", "BWC", "BWR"};
  EXPECT_EQ(kinds_of("nmea_signalk/gofree-merrimac.log"), known);
  const json file = account_of("nmea_signalk/gofree-merrimac.log");
  EXPECT_EQ(file.at("unknown"), 0);
  // 142 distance sentences hold seven others inside, cut off at their $; 142 dates have a year of two digits.
  EXPECT_EQ(file.at("refused"), json::parse(R"({"torn":994,"checksum":142,"fields":142})"));
}

TEST(RealLogs, EverySentenceOfTheN2kGatewayIsKnownWhateverItsTalker) {
  EXPECT_EQ(kinds_of("nmea_signalk/n2kd-183-merrimac.log"),
            (std::set<std::string>{"MWV", "HDG", "HDM", "DBS", "DBT"}));
  const json file = account_of("nmea_signalk/n2kd-183-merrimac.log");
  EXPECT_EQ(file.at("frames"), 541);
  EXPECT_EQ(file.at("unknown"), 0);
  EXPECT_TRUE(file.at("refused").empty());
}

TEST(RealLogs, EveryFrameOfTheArduSubLogIsFound) {
  const json file = account_of("ardusub_mavlink/small.tlog");
  EXPECT_EQ(file.at("frames"), 35916);
  EXPECT_TRUE(file.at("refused").empty());
  EXPECT_EQ(file.at("byte_classes").at("skipped"), 0);
  EXPECT_EQ(count_of(file, "GPS_INPUT"), 1011);
}

std::vector<std::map<std::string, std::string>> rows_of(const std::string& path) {
  std::istringstream in(test::read_text(path));
  const auto cells = [](const std::string& line) {
    std::vector<std::string> found;
    std::istringstream cells_in(line);
    for (std::string cell; std::getline(cells_in, cell, ',');) found.push_back(cell);
    return found;
  };
  std::string line;
  std::getline(in, line);
  const auto header = cells(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(in, line)) {
    const auto values = cells(line);
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(header.size(), values.size()); ++i) row[header[i]] = values[i];
  }
  return rows;
}

TEST(RealLogs, AnArduSubAtRestStaysInsideItsSigma) {
  const std::string out = test::scratch_folder() + "/csv";
  const auto ran = test::leadline("replay --quiet --config " + data_path("demo/ardusub.toml") + " --csv " +
                                  out + " ardusub=" + data_path("ardusub_mavlink/small.tlog"));
  ASSERT_EQ(ran.status, 0) << ran.err;
  constexpr double kLat_deg = 48.3861418, kLon_deg = -124.6305732;  // all 1011 GPS_INPUT say so
  constexpr double kMetresPerDegree = 111'320.0;
  const auto rows = rows_of(out + "/fusion.csv");
  ASSERT_GT(rows.size(), 900u);
  double farthest_m = 0.0, fastest_mps = 0.0;
  for (const auto& row : rows) {
    const double north_m = (std::stod(row.at("lat_deg")) - kLat_deg) * kMetresPerDegree;
    const double east_m =
        (std::stod(row.at("lon_deg")) - kLon_deg) * kMetresPerDegree * std::cos(kLat_deg * kRadPerDeg);
    EXPECT_LE(std::abs(north_m), std::stod(row.at("sd_north_m"))) << row.at("utc");
    EXPECT_LE(std::abs(east_m), std::stod(row.at("sd_east_m"))) << row.at("utc");
    farthest_m = std::max(farthest_m, std::hypot(north_m, east_m));
    fastest_mps = std::max(fastest_mps,
                           std::hypot(std::stod(row.at("vel_north_mps")), std::stod(row.at("vel_east_mps"))));
  }
  std::printf("ArduSub at rest: %zu rows, at most %.4f m off, %.4f m/s\n", rows.size(), farthest_m,
              fastest_mps);
  EXPECT_LT(farthest_m, 0.01) << "the fixes do not move at all";
  EXPECT_LT(fastest_mps, 0.01);
}

}  // namespace
}  // namespace leadline
