// The SDK as its users have it: installed elsewhere, the two examples built against nothing else, and loaded.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "core/geo/geodesy.h"
#include "plugins/host/plugin_host.h"
#include "plugins/sdk/interface_version.h"
#include "tests/support/decoder_harness.h"
#include "tests/support/program.h"

namespace leadline {
namespace {

namespace fs = std::filesystem;
using test::as_bytes;

/// Runs a shell's words; its output is shown when it fails.
bool run(const std::string& words) {
  const std::string log = std::string(LEADLINE_BINARY_DIR) + "/scratch/sdk.log";
  fs::create_directories(std::string(LEADLINE_BINARY_DIR) + "/scratch");
  const bool well = std::system((words + " >" + log + " 2>&1").c_str()) == 0;
  if (!well) std::cout << words << "\n" << test::read_text(log) << "\n";
  return well;
}

/// Installed once for all tests, examples built and loaded.
class Sdk : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const fs::path scratch = fs::path(LEADLINE_BINARY_DIR) / "scratch" / "sdk";
    fs::remove_all(scratch);
    prefix = scratch / "prefix";
    ASSERT_TRUE(run("cmake --install " LEADLINE_BINARY_DIR " --prefix " + prefix.string()));
    for (const std::string example : {"example_engine", "example_decoder"}) {
      // A copy, so that nothing of the source tree is in reach.
      const fs::path source = scratch / example, build = scratch / (example + "_build");
      fs::copy(fs::path(LEADLINE_SOURCE_DIR) / "plugins" / example, source, fs::copy_options::recursive);
      ASSERT_TRUE(run("cmake -G Ninja -S " + source.string() + " -B " + build.string() +
                      " -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=" + prefix.string()));
      ASSERT_TRUE(run("cmake --build " + build.string()));
    }
    host = new PluginHost(PluginHost::load(
        {.program = prefix / "bin",
         .plugin_paths = {scratch / "example_engine_build", scratch / "example_decoder_build"}}));
  }
  static void TearDownTestSuite() { delete host; }
  void SetUp() override { ASSERT_NE(host, nullptr); }

  static inline fs::path prefix;
  static inline PluginHost* host = nullptr;
};

TEST_F(Sdk, InstalledPluginAndBothExamplesLoad) {
  for (const auto& refusal : host->refusals()) ADD_FAILURE() << refusal.line();
  ASSERT_EQ(host->plugins().size(), 3u);
  EXPECT_EQ(host->plugins()[0].name, "navigation");
  EXPECT_EQ(host->plugins()[0].file,
            fs::canonical(prefix / "lib/leadline/plugins/leadline_navigation.so").string());
  EXPECT_TRUE(host->plugins()[0].house);
  EXPECT_TRUE(host->has_engine("straight-line") && host->has_decoder("depth-line"));
}

TEST_F(Sdk, TheInstalledProgramFindsWhatItNeeds) {
  EXPECT_TRUE(run("env -i " + (prefix / "bin/leadline").string() + " list engines"));
  EXPECT_TRUE(fs::exists(prefix / "lib/libleadline-core.so"));
  EXPECT_TRUE(fs::exists(prefix / "share/leadline/magnetic/wmm2025.wmm.cof"));
  EXPECT_FALSE(fs::exists(prefix / "include/leadline/core/nav")) << "no plugin's business";
}

TEST_F(Sdk, TheInstalledProgramReplaysWithBoth) {
  const fs::path scratch = prefix.parent_path();
  std::string tlog;
  for (int i = 0; i < 100; ++i)
    tlog += "(" + std::to_string(1406851200 + i) + ".500000) depth *00011." + std::to_string(100 + i) + "\n";
  test::write_file((scratch / "depth.tlog").string(), tlog);
  test::write_file((scratch / "both.toml").string(), R"(version = 1
[navigation]
engine = "straight-line"
body = "ship"
[[source]]
name = "s330"
decoder = "nmea0183"
body = "ship"
[[source]]
name = "depth"
decoder = "depth-line"
body = "ship"
)");
  const std::string paths = " --plugin-path " + (scratch / "example_engine_build").string() +
                            " --plugin-path " + (scratch / "example_decoder_build").string();
  const std::string csv = (scratch / "csv").string();
  ASSERT_TRUE(run("env -i " + (prefix / "bin/leadline").string() + " replay" + paths + " --config " +
                  (scratch / "both.toml").string() + " --engine straight-line --engine fusion --session " +
                  (scratch / "both.leadline").string() + " --csv " + csv + " " +
                  (scratch / "depth.tlog").string() +
                  " s330=" LEADLINE_TEST_DATA "/nmea_openrvdas_nbp1406/NBP1406_s330-2014-08-01"));
  for (const char* engine : {"straight-line", "fusion"}) {
    const std::string rows = test::read_text(csv + "/" + engine + ".csv");
    EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 600) << engine;
  }
  EXPECT_NE(test::read_text(csv + "/summary.json").find("\"decoded\": 100"), std::string::npos);
  EXPECT_TRUE(
      run("test $(" + (prefix / "bin/leadline").string() + " list engines" + paths + " | wc -l) = 4"));
}

TEST_F(Sdk, TheInterfaceHashIsThatOfTheInstalledHeaders) {
  const std::string list =
      "$(LC_ALL=C find . -name '*.h' ! -name interface_version.h | cut -c3- | LC_ALL=C sort)";
  EXPECT_TRUE(run("cd " + (prefix / "include/leadline").string() + " && test $(sha256sum " + list +
                  " | sha256sum | cut -c-64) = " + std::string(kInterfaceHash)));
}

struct Heard final : EngineOutput {
  std::vector<Solution> solutions;
  std::vector<FixVerdict> verdicts;
  std::vector<Alarm> alarms;
  void publish(Time, const Message& message, SourceId) override {
    if (const auto* s = std::get_if<Solution>(&message)) solutions.push_back(*s);
    if (const auto* v = std::get_if<FixVerdict>(&message)) verdicts.push_back(*v);
    if (const auto* a = std::get_if<Alarm>(&message)) alarms.push_back(*a);
  }
};

TEST_F(Sdk, TheExampleEngineGoesOnStraightWithAnHonestSigma) {
  const auto tables = host->engine_tables();
  const std::vector<SourceInfo> sources{{.id = 0, .name = "gnss"}};
  EngineSetup setup{.id = 2, .sources = sources};
  setup.common.aiding.gnss_drms_m = 2.0 * std::sqrt(2.0);  // 2 m each axis
  const auto engine = host->make_engine("straight-line", tables, setup, nullptr).value();
  const Geodetic start{Angle::deg(60), Angle::deg(4)};
  Heard heard;
  const auto tell = [&](double t_s, const Message& message) {
    const Time t = from_unix(1.7e9 + t_s);
    engine->take({.valid = t, .arrival = arrival_at(t), .source = 0, .message = message}, heard);
  };
  const auto tick = [&](double t_s) { tell(t_s, Tick{arrival_at(from_unix(1.7e9 + t_s))}); };
  tell(0, GnssFix{.position = start});
  tick(1);
  EXPECT_TRUE(heard.solutions.empty()) << "one fix gives no line";
  tell(10, GnssFix{.position = geo::displaced(start, 20, -10)});
  tick(15);
  ASSERT_EQ(heard.solutions.size(), 1u);
  const Solution& s = heard.solutions[0];
  const auto off = geo::difference(start, s.position);
  EXPECT_NEAR(off.north_m, 30.0, 1e-3);
  EXPECT_NEAR(off.east_m, -15.0, 1e-3);
  EXPECT_NEAR(s.vel_north_mps.value(), 2.0, 1e-4);
  // (1.5^2 + 0.5^2) 2^2 of the fixes, (0.05 * 5 * 15 / 2)^2 of a turn that went unseen.
  EXPECT_NEAR(s.var_north_m2, 10.0 + 1.875 * 1.875, 1e-9);
  EXPECT_EQ(s.engine, 2);
  tick(100);
  EXPECT_EQ(heard.solutions.size(), 1u) << "longest_s after the last fix it is silent";
  EXPECT_EQ(heard.verdicts.size(), 2u);
  EXPECT_TRUE(heard.alarms.empty());
}

std::unique_ptr<Decoder> depth_line(const PluginHost& host, const std::string& unit_id = "") {
  const auto settings = host.source_settings("depth-line");
  for (const auto& key : settings->keys())
    if (key.name == "unit_id") *std::get<std::string*>(key.target) = unit_id;
  return host.make_decoder("depth-line", {}, settings).value();
}

TEST_F(Sdk, TheExampleDecoderTakesWhatIsRightAndRefusesTheRest) {
  struct Case {
    const char* bytes;
    std::size_t depths;
    const char* reason;
  };
  for (const auto& [bytes, depths, reason] : std::vector<Case>{
           {"*000112.345\r\n", 1, ""},
           {"*0001-0.5\r\n*0002+3\r\n", 2, ""},
           {"noise*000112.345\r\n", 1, ""},
           {"*0001nan\r\n", 0, "syntax"},
           {"*00011e3\r\n", 0, "syntax"},
           {"*00011.2.3\r\n", 0, "syntax"},
           {"*0001\r\n", 0, "syntax"},
           {"*000112.3\n", 1, ""},
           {"*000199999\r\n", 0, "range"},
           {"*000112.*00015.0\r\n", 1, "torn"},
           {"*000112.34", 0, "truncated"},
           {"*00011111111111111111111111111111111111\r\n", 0, "oversize"},
       }) {
    const auto all = test::decode_all(*depth_line(*host), as_bytes(bytes));
    EXPECT_EQ(all.all<DepthMeasured>().size(), depths) << bytes;
    EXPECT_EQ(all.ledger.bytes_total(), std::string(bytes).size()) << bytes;
    EXPECT_EQ(all.ledger.refusals().empty() ? "" : all.ledger.refusals()[0].name, reason) << bytes;
    for (std::size_t chunk = 1; chunk < 12; ++chunk)
      EXPECT_TRUE(test::same(all, test::decode_all(*depth_line(*host), as_bytes(bytes), {}, chunk))) << bytes;
  }
  const auto decoder = depth_line(*host, "02");
  const auto one = test::decode_all(*decoder, as_bytes("*000112.345\r\n*00024.5\r\n"));
  ASSERT_EQ(one.all<DepthMeasured>().size(), 1u) << "only the gauge that was asked for";
  EXPECT_DOUBLE_EQ(one.all<DepthMeasured>()[0].depth.m, 4.5);
  EXPECT_EQ(one.ledger.bytes(ByteClass::unused), 13u);
}

}  // namespace
}  // namespace leadline
