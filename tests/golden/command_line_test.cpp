// The program as a user meets it: verbs, files, messages, exit statuses.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/types/time.h"
#include "tests/support/program.h"

namespace leadline {
namespace {

using nlohmann::json;
using test::data_path;
using test::leadline;
using test::scratch_folder;
using test::write_file;

const char* const kSolutionHeader =
    "unix_s,utc,lat_deg,lon_deg,depth_m,roll_deg,pitch_deg,heading_deg,vel_north_mps,vel_east_mps,vel_down_"
    "mps,"
    "sd_north_m,sd_east_m,sd_down_m,sd_heading_deg,heading_bias_deg,mode,position_source";

std::string palmer(const std::string& name) {
  return data_path("nmea_openrvdas_nbp1406/NBP1406_" + name + "-2014-08-01");
}

std::string palmer_inputs() {
  std::string words;
  for (const char* name : {"s330", "gyr1", "gp02", "adcp"})
    words += std::string(" ") + name + "=" + palmer(name);
  return words;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back().push_back(c);
  }
  return cells;
}

/// A configuration of one NMEA source of the ship.
const char* const kOneSource = R"(version = 1
[navigation]
body = "ship"
[[source]]
name = "gps"
decoder = "nmea0183"
body = "ship"
checksum = "optional"
)";

TEST(Replay, PalmerTwiceWritesTheSameFiles) {
  const std::string folder = scratch_folder(), config = data_path("demo/palmer.toml");
  for (const char* run : {"a", "b"}) {
    const auto ran = leadline("replay --engine fusion --engine dead-reckoning --config " + config +
                              palmer_inputs() + " --csv " + folder + "/" + run);
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(ran.out.empty());
  }
  for (const char* file :
       {"fusion.csv", "dead-reckoning.csv", "ship.csv", "fixes.csv", "dead-reckoning_fixes.csv"}) {
    const std::string a = test::read_text(folder + "/a/" + file);
    EXPECT_EQ(a, test::read_text(folder + "/b/" + file)) << file;
    EXPECT_GE(std::count(a.begin(), a.end(), '\n'), 601) << file;
  }
}

TEST(Replay, WritesTheColumnsOfTheContractAndNoNumberThatIsNone) {
  const std::string folder = scratch_folder();
  ASSERT_EQ(
      leadline("replay --config " + data_path("demo/palmer.toml") + palmer_inputs() + " --csv " + folder)
          .status,
      0);
  for (const char* file : {"fusion.csv", "ship.csv"}) {
    const auto lines = lines_of(test::read_text(folder + "/" + file));
    ASSERT_GT(lines.size(), 1u);
    EXPECT_EQ(lines[0], kSolutionHeader);
    double last = 0.0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const auto cells = cells_of(lines[i]);
      ASSERT_EQ(cells.size(), 18u) << lines[i];
      EXPECT_EQ(lines[i].find("nan"), std::string::npos);
      EXPECT_EQ(lines[i].find("inf"), std::string::npos);
      const double t = std::stod(cells[0]), heading = cells[7].empty() ? 0.0 : std::stod(cells[7]);
      EXPECT_GE(t, last);
      last = t;
      EXPECT_TRUE(heading >= 0.0 && heading < 360.0) << lines[i];
      EXPECT_GE(cells[2].size() - cells[2].find('.') - 1, 9u);
      EXPECT_EQ(cells[0].size() - cells[0].find('.') - 1, 6u);
    }
  }
  const auto fixes = lines_of(test::read_text(folder + "/fixes.csv"));
  EXPECT_EQ(fixes[0], "unix_s,source,body,lat_deg,lon_deg,depth_m,residual_m,gate_m,accepted");
  std::map<std::string, int> by_source;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    const auto cells = cells_of(fixes[i]);
    ++by_source[cells[1]];
    if (cells[1] == "gp02") {
      EXPECT_EQ(cells[8], "") << fixes[i];
    }
  }
  EXPECT_EQ(by_source["s330"], 625);
  EXPECT_EQ(by_source["gp02"], 1667);
}

TEST(Replay, SummarySpeaksForEverySourceAndEngine) {
  const std::string folder = scratch_folder();
  ASSERT_EQ(
      leadline("replay --config " + data_path("demo/palmer.toml") + palmer_inputs() + " --csv " + folder)
          .status,
      0);
  const json summary = json::parse(test::read_text(folder + "/summary.json"));
  for (const char* key : {"inputs", "body", "sources", "start_utc", "end_utc", "span_s", "wall_s",
                          "realtime_factor", "clock_offset_s", "engines"})
    EXPECT_TRUE(summary.contains(key)) << key;
  for (const char* source : {"s330", "gyr1", "gp02", "adcp"}) {
    EXPECT_EQ(summary["sources"][source]["frames"], 5000);
    EXPECT_EQ(summary["sources"][source]["rejected"], json::object());
  }
  EXPECT_NEAR(summary["clock_offset_s"]["s330"].get<double>(), 0.115, 0.01);
  EXPECT_NEAR(summary["clock_offset_s"]["gp02"].get<double>(), 0.300, 0.01);
  EXPECT_TRUE(summary["clock_offset_s"]["gyr1"].is_null());
  const json& fusion = summary["engines"]["fusion"];
  for (const char* key :
       {"rows", "distance_run_m", "fixes_accepted", "fixes_rejected", "end_error_m", "end_error_percent",
        "dr_end_error_m", "dr_end_error_percent", "heading_misalignment_deg"})
    EXPECT_TRUE(fusion.contains(key)) << key;
}

TEST(Replay, ClockOfABoatIsComparedWithTheGnssInsideItsEnsembles) {
  const std::string folder = scratch_folder();
  ASSERT_EQ(leadline("replay adcp=" + data_path("dvl_pd0_adcp/winriver01.PD0") + " --config " +
                     data_path("demo/winriver.toml") + " --engine dead-reckoning --csv " + folder)
                .status,
            0);
  const json summary = json::parse(test::read_text(folder + "/summary.json"));
  EXPECT_NEAR(summary["clock_offset_s"]["adcp"].get<double>(), 14426.35, 0.01);
}

TEST(Replay, ATlogOfTextAndBinaryFramesGivesWhatItsFilesGive) {
  const std::string folder = scratch_folder();
  // The Palmer's own lines as a tlog, in order of arrival, with a source nobody knows among them.
  std::vector<std::pair<double, std::string>> frames;
  for (const char* name : {"s330", "gyr1", "gp02", "adcp"})
    for (const auto& line : lines_of(test::read_text(palmer(name)))) {
      const auto stamp = parse_iso8601(line.substr(0, 27));
      ASSERT_TRUE(stamp) << line;
      char text[64];
      std::snprintf(text, sizeof text, "(%.6f) %s ", to_unix(*stamp), name);
      const std::string payload = line.substr(28);
      std::string body = payload;
      if (std::string(name) == "gyr1") {  // binary: with its terminator
        body = "#";
        char hex[3];
        for (const char c : payload + "\n")
          body += (std::snprintf(hex, sizeof hex, "%02x", static_cast<unsigned char>(c)), hex);
      }
      frames.emplace_back(to_unix(*stamp), text + body + "\n");
    }
  std::stable_sort(frames.begin(), frames.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string tlog = "(1406851200.100000) nobody $GPGGA,torn\n";
  for (const auto& frame : frames) tlog += frame.second;
  write_file(folder + "/ship.tlog", tlog);

  const std::string config = data_path("demo/palmer.toml");
  const auto from_tlog =
      leadline("replay " + folder + "/ship.tlog --config " + config + " --csv " + folder + "/tlog");
  ASSERT_EQ(from_tlog.status, 0) << from_tlog.err;
  EXPECT_NE(from_tlog.err.find("1 lines of source \"nobody\""), std::string::npos) << from_tlog.err;
  ASSERT_EQ(leadline("replay --config " + config + palmer_inputs() + " --csv " + folder + "/files").status,
            0);
  for (const char* file : {"fusion.csv", "ship.csv", "fixes.csv"})
    EXPECT_EQ(test::read_text(folder + "/tlog/" + file), test::read_text(folder + "/files/" + file)) << file;
}

TEST(Replay, DamageIsSaidAndWhatWasReadIsKept) {
  const std::string folder = scratch_folder();
  const std::string whole = test::read_text(data_path("dvl_pd0_adcp/winriver01.PD0"));
  write_file(folder + "/cut.PD0", whole.substr(0, whole.size() / 2));
  const auto ran = leadline("replay adcp=" + folder + "/cut.PD0 --config " + data_path("demo/winriver.toml") +
                            " --engine dead-reckoning --csv " + folder + "/csv");
  EXPECT_EQ(ran.status, 3);
  EXPECT_NE(ran.err.find("adcp: 1 refused: truncated"), std::string::npos) << ran.err;
  EXPECT_GT(lines_of(test::read_text(folder + "/csv/dead-reckoning.csv")).size(), 100u);
}

TEST(Replay, BadInputsEndWithAMessageAndTheirStatus) {
  const std::string folder = scratch_folder();
  const std::string config = write_file(folder + "/one.toml", kOneSource);
  const auto refused = [&](const std::string& input, int status, const std::string& message) {
    const auto ran = leadline("replay " + input + " --config " + config + " --csv " + folder + "/csv");
    EXPECT_EQ(ran.status, status) << input << ": " << ran.err;
    EXPECT_NE(ran.err.find(message), std::string::npos) << input << ": " << ran.err;
    EXPECT_EQ(ran.err.find("ERROR: AddressSanitizer"), std::string::npos);
  };
  refused("gps=" + folder + "/missing.log", 1, "missing.log");
  refused("gps=" + folder, 1, folder);
  write_file(folder + "/empty.log", "");
  refused("gps=" + folder + "/empty.log", 1, "empty");
  refused("gps=" + data_path("dvl_pd0_adcp/winriver01.PD0"), 1, "holds trdi-pd0, not nmea0183");
  write_file(folder + "/noise.bin", std::string("\x01\x02\xff\xfe noise \x80\x81", 14));
  refused("gps=" + folder + "/noise.bin", 1, "noise.bin");
  write_file(folder + "/undated.log", "$HEHDT,001.7,T*29\r\n$HEHDT,001.7,T*29\r\n");
  refused("gps=" + folder + "/undated.log", 2, "date");
  refused("radar=" + folder + "/undated.log", 2, "no [[source]] is called \"radar\"");
}

TEST(Replay, AnEmptyFileAmongOthersIsSaidAndLeftOut) {
  const std::string folder = scratch_folder();
  write_file(folder + "/empty.log", "");
  const auto ran = leadline("replay --config " + data_path("demo/palmer.toml") + " s330=" + palmer("s330") +
                            " gyr1=" + folder + "/empty.log --csv " + folder + "/csv");
  EXPECT_EQ(ran.status, 3);
  EXPECT_NE(ran.err.find("empty.log: is empty"), std::string::npos) << ran.err;
  EXPECT_GT(lines_of(test::read_text(folder + "/csv/fusion.csv")).size(), 600u);
}

TEST(Configuration, MistakesAreNamedByFileLineAndKey) {
  const std::string folder = scratch_folder();
  const auto refused = [&](const std::string& text, const std::string& message) {
    const std::string config = write_file(folder + "/bad.toml", text);
    for (const std::string& words : {"--check-config " + config, "replay gps=x --config " + config}) {
      const auto ran = leadline(words);
      EXPECT_EQ(ran.status, 2) << ran.err;
      EXPECT_NE(ran.err.find(message), std::string::npos) << message << "\n" << ran.err;
    }
  };
  const std::string good = kOneSource;
  refused(good + "[navigation.aiding]\ngnss_drm_m = 3.0\n",
          "bad.toml:10: navigation.aiding.gnss_drm_m: unknown key; the nearest known key is gnss_drms_m");
  refused(good + "[navigation.aiding]\ngnss_drms_m = \"much\"\n",
          "bad.toml:10: navigation.aiding.gnss_drms_m");
  refused(good + "[navigation.aiding]\ngnss_drms_m = -1\n", "bad.toml:10: navigation.aiding.gnss_drms_m");
  refused("version = 2\n", "bad.toml:1: version");
  refused("version = 1\n[navigation\n", "bad.toml:2");
  refused(good + "[[source]]\nname = \"gps\"\ndecoder = \"nmea0183\"\n", "bad.toml:10");
  refused(good + "[[source]]\nname = \"x\"\ndecoder = \"nmea\"\n", "no decoder is called \"nmea\"");
  refused(good + "[[calibration]]\nsource = \"dvl\"\n", "is no [[source]]");
  refused(good + "[[source]]\nname = \"t\"\ndecoder = \"table\"\ncolumns = [\"latdeg\", \"lon_deg\"]\n",
          "lat_deg");
  refused(good + "[[source]]\nname = \"p\"\ndecoder = \"paroscientific\"\natmosphere_hp = 1.0\n",
          "atmosphere_hpa");
  refused(good + "[[source]]\nname = \"d\"\ndecoder = \"trdi-pd0\"\naxes = \"trdi\"\n", "axes: unknown key");
  EXPECT_EQ(leadline("--check-config " + folder + "/missing.toml").status, 2);
}

TEST(Configuration, TheExampleIsComplete) {
  const std::string folder = scratch_folder();
  const auto example = leadline("--example-config");
  ASSERT_EQ(example.status, 0);
  const auto checked = leadline("--check-config " + write_file(folder + "/example.toml", example.out));
  EXPECT_EQ(checked.status, 0) << checked.err;
  for (const char* key : {"gnss_drms_m", "water_current_mps", "latency_s", "[[calibration]]", "columns",
                          "x_m", "usbl_order", "velocity_sign"})
    EXPECT_NE(example.out.find(key), std::string::npos) << key;
}

TEST(CommandLine, MisuseIsStatusTwoWithAWayOut) {
  for (const char* words :
       {"replay", "replay x --config", "reply x", "list sensors", "--check-config", "info"}) {
    const auto ran = leadline(words);
    EXPECT_EQ(ran.status, 2) << words;
    EXPECT_FALSE(ran.err.empty()) << words;
  }
  const auto engine = leadline("replay s330=" + palmer("s330") + " --config " +
                               data_path("demo/palmer.toml") + " --engine kalman");
  EXPECT_EQ(engine.status, 2);
  EXPECT_NE(engine.err.find("dead-reckoning"), std::string::npos) << engine.err;
}

TEST(CommandLine, AnOptionTakesOneWordAndLeavesTheInputsAlone) {
  const std::string folder = scratch_folder();
  const auto ran = leadline("replay --csv " + folder + " --config " + data_path("demo/riverpro.toml") +
                            " --engine dead-reckoning --plugin-path " + folder + " --engine fusion " +
                            data_path("dvl_pd0_adcp/RiverPro_test01.PD0"));
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_GT(lines_of(test::read_text(folder + "/fusion.csv")).size(), 200u);
  EXPECT_GT(lines_of(test::read_text(folder + "/dead-reckoning.csv")).size(), 200u);
}

TEST(CommandLine, EveryVerbHasHelpWithAnExample) {
  for (const char* verb : {"", "replay ", "info ", "list "}) {
    const auto ran = leadline(std::string(verb) + "--help");
    EXPECT_EQ(ran.status, 0);
    EXPECT_NE(ran.out.find("Example: leadline"), std::string::npos) << verb;
  }
}

TEST(CommandLine, ListNamesWhatThisBuildHas) {
  const json engines = json::parse(leadline("list engines --json").out);
  EXPECT_EQ(engines[0]["name"], "dead-reckoning");
  EXPECT_EQ(engines[1]["name"], "fusion");
  const auto decoders = leadline("list decoders").out;
  for (const char* name : {"nmea0183", "trdi-pd0", "table"})
    EXPECT_NE(decoders.find(name), std::string::npos);
}

struct Holds {
  const char* file;
  int status;
  std::map<std::string, std::uint64_t> numbers;  // of the file's own counts
  std::map<std::string, std::uint64_t> kinds;
};

TEST(Info, CountsAreThoseOfTheSources) {
  const std::vector<Holds> cases = {
      {"nmea_openrvdas_nbp1406/NBP1406_s330-2014-08-01",
       0,
       {{"lines", 5000}, {"frames", 5000}, {"checksum_ok", 5000}, {"unknown", 0}},
       {{"GGA", 625}, {"ZDA", 625}, {"PSXN23", 625}}},
      {"nmea_openrvdas_nbp1406/NBP1406_gyr1-2014-08-01",
       0,
       {{"frames", 5000}, {"checksum_ok", 5000}},
       {{"HDT", 5000}}},
      {"nmea_openrvdas_nbp1406/NBP1406_gp02-2014-08-01",
       0,
       {{"frames", 5000}, {"checksum_absent", 5000}},
       {{"GLL", 1667}, {"ZDA", 1667}, {"VTG", 1666}}},
      {"nmea_openrvdas_nbp1406/NBP1406_adcp-2014-08-01",
       0,
       {{"frames", 5000}, {"checksum_absent", 5000}},
       {{"PUHAW", 5000}}},
      {"nmea_openrvdas_nbp1406/NBP1406_mbdp-2014-08-01",
       0,
       {{"frames", 5000}, {"checksum_ok", 5000}},
       {{"DPT", 5000}}},
      {"dvl_pd0_adcp/winriver01.PD0", 0, {{"frames", 262}, {"checksum_ok", 262}}, {{"ensemble", 262}}},
      {"dvl_pd0_adcp/winriver02.PD0",
       3,
       {{"frames", 75}, {"gaps", 1}},
       {{"ensemble", 75}, {"NMEA GGA", 611}}},
      {"dvl_pd0_adcp/RiverPro_test01.PD0", 0, {{"frames", 273}}, {{"ensemble", 273}}},
      {"dvl_pd0_adcp/RDI_withBT.000", 3, {{"checksum_ok", 1721}}, {{"ensemble", 1721}}},
      {"dvl_pd0_adcp/RDI_test01.000", 3, {{"checksum_ok", 22}}, {{"ensemble", 22}}},
      {"dvl_pd0_adcp/RDI_7f79.000", 3, {{"unused", 122}}, {{"ensemble", 60}, {"waves", 122}}},
      {"dvl_pd0_adcp/sentinelv_b5.pd0", 3, {{"checksum_ok", 50}}, {{"ensemble", 50}}},
      {"dvl_pd0_remus600/adcp_auv_51.pd0", 0, {{"frames", 51}}, {{"ensemble", 51}}},
      {"dvl_pd0_remus600/adcp_auv_3.pd0", 0, {{"frames", 3}}, {{"ensemble", 3}}},
      {"dvl_pd0_remus600/glider/LA100204.PD0", 0, {{"frames", 107}}, {{"ensemble", 107}}},
      {"dvl_pd0_remus600/glider/NE051400.PD0", 0, {{"frames", 193}}, {{"ensemble", 193}}},
      {"dvl_pd0_remus600/glider/LB180210_3_corrupted.PD0", 3, {{"checksum_ok", 2}}, {{"ensemble", 2}}},
  };
  for (const auto& wanted : cases) {
    const std::string path = data_path(wanted.file);
    const auto ran = leadline("info --json " + path);
    EXPECT_EQ(ran.status, wanted.status) << wanted.file << ran.err;
    const json file = json::parse(ran.out)["files"][0];
    EXPECT_EQ(file["bytes"], std::filesystem::file_size(path));
    std::uint64_t sum = 0;
    for (const auto& [name, bytes] : file["byte_classes"].items()) sum += bytes.get<std::uint64_t>();
    EXPECT_EQ(sum, std::filesystem::file_size(path)) << wanted.file;
    EXPECT_EQ(file["byte_classes"].size(), 7u);
    for (const auto& [key, count] : wanted.numbers) EXPECT_EQ(file[key], count) << wanted.file << " " << key;
    for (const auto& [kind, count] : wanted.kinds) {
      std::uint64_t found = 0;
      for (const auto& source : file["sources"])
        if (source["kind"] == kind) found += source["count"].get<std::uint64_t>();
      EXPECT_EQ(found, count) << wanted.file << " " << kind;
    }
  }
}

}  // namespace
}  // namespace leadline
