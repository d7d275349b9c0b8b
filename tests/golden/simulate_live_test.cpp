// `leadline simulate --live`: what arrives is what telegrams.tlog holds.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <future>
#include <map>
#include <sstream>

#include "tests/support/peer.h"
#include "tests/support/program.h"

namespace leadline {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string scenario(const std::string& links, const std::string& duration_s) {
  return R"(version = 1
[scenario]
duration_s = )" +
         duration_s + R"(
[vehicle]
speed_mps = 1.0
max_speed_mps = 2.0
[[vehicle.leg]]
heading_deg = 30.0
duration_s = 5.0
[[sensor]]
name = "gps"
kind = "gnss"
rate_hz = 20.0
latency_s = 0.02
jitter_s = 0.01
)" + links;
}

std::string dvl(const std::string& link) {
  return "[[sensor]]\nname = \"dvl\"\nkind = \"dvl\"\nrate_hz = 10.0\nlink = \"" + link + "\"\n";
}

/// The payloads of each source of a log, one behind the other and in order.
std::map<std::string, std::vector<std::string>> payloads(const std::string& path) {
  std::map<std::string, std::vector<std::string>> all;
  std::istringstream lines(test::read_text(path));
  std::string line;
  while (std::getline(lines, line)) {
    const auto name = line.find(' ') + 1, payload = line.find(' ', name) + 1;
    std::string bytes = line.substr(payload) + "\n";
    if (bytes.front() == '#') {
      std::string decoded;
      for (std::size_t i = 1; i + 1 < bytes.size(); i += 2)
        decoded.push_back(static_cast<char>(std::stoi(bytes.substr(i, 2), nullptr, 16)));
      bytes = decoded;
    }
    all[line.substr(name, payload - 1 - name)].push_back(bytes);
  }
  return all;
}

std::vector<std::string> receive(const test::Peer& peer, std::size_t datagrams) {
  std::vector<std::string> all;
  while (all.size() < datagrams) {
    all.push_back(peer.read_some());
    if (all.back().empty()) break;
  }
  return all;
}

TEST(SimulateLive, WhatArrivesOverUdpIsWhatTheLogHolds) {
  const std::string folder = test::scratch_folder();
  const auto gps_peer = test::udp_peer(), dvl_peer = test::udp_peer();
  const auto port = [](const test::Peer& peer) { return std::to_string(test::port_of(peer)); };
  const std::string made = scenario("link = \"udp://127.0.0.1:" + port(gps_peer) + "\"\n" +
                                        dvl("udp://127.0.0.1:" + port(dvl_peer)) +
                                        "[[sensor]]\nname = \"depth\"\nkind = \"depth\"\n",
                                    "2.0");
  const std::string path = test::write_file(folder + "/s.toml", made);
  const auto ran = test::leadline("simulate " + path + " --output " + folder + "/live --live");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.err, AllOf(HasSubstr("depth has no link: it is not sent"), HasSubstr("p50"),
                             HasSubstr("p99"), HasSubstr("max"), Not(HasSubstr("dropped"))));
  auto sent = payloads(folder + "/live/telegrams.tlog");
  ASSERT_GT(sent["gps"].size(), 60U);
  EXPECT_EQ(receive(gps_peer, sent["gps"].size()), sent["gps"]);
  EXPECT_EQ(receive(dvl_peer, sent["dvl"].size()), sent["dvl"]);

  // The same files as without, and a configuration that listens.
  ASSERT_EQ(test::leadline("simulate " + path + " --output " + folder + "/batch").status, 0);
  for (const char* file :
       {"telegrams.tlog", "truth.csv", "leadline.toml", "gps.nmea", "dvl.pd0", "depth.csv"})
    EXPECT_EQ(test::read_text(folder + "/live/" + file), test::read_text(folder + "/batch/" + file)) << file;
  EXPECT_THAT(test::read_text(folder + "/live/leadline.toml"),
              AllOf(HasSubstr("link = \"udp://0.0.0.0:" + port(gps_peer) + "\""),
                    HasSubstr("link = \"udp://0.0.0.0:" + port(dvl_peer) + "\"")));
  EXPECT_EQ(test::leadline("--check-config " + folder + "/live/leadline.toml").status, 0);
}

TEST(SimulateLive, InterruptedItKeepsWhatWasSent) {
  const std::string folder = test::scratch_folder();
  const auto peer = test::udp_peer();
  const std::string path = test::write_file(
      folder + "/s.toml",
      scenario("link = \"udp://127.0.0.1:" + std::to_string(test::port_of(peer)) + "\"\n", "3600.0"));
  // The shell says its number and becomes the program.
  auto running = std::async(std::launch::async, [&] {
    const std::string command = "echo $$ > " + folder + "/pid; exec " + std::string(LEADLINE_PROGRAM) +
                                " simulate " + path + " --output " + folder + "/out --live 2>" + folder +
                                "/err";
    return std::system(command.c_str());
  });
  const auto first = receive(peer, 10);
  EXPECT_EQ(first.size(), 10U);
  ::kill(std::stoi(test::read_text(folder + "/pid")), SIGINT);
  const int status = running.get();
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const auto kept = payloads(folder + "/out/telegrams.tlog")["gps"];
  ASSERT_GE(kept.size(), 10U);
  EXPECT_EQ(std::vector<std::string>(kept.begin(), kept.begin() + 10), first);
  EXPECT_GT(test::read_text(folder + "/out/truth.csv").size(), 100U);
}

TEST(SimulateLive, NoLinkAtAllAndABadLinkAreRefused) {
  const std::string folder = test::scratch_folder();
  const std::string none = test::write_file(folder + "/none.toml", scenario("", "2.0"));
  auto ran = test::leadline("simulate " + none + " --output " + folder + "/out --live");
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.err, HasSubstr("no sensor has a link"));
  const std::string bad =
      test::write_file(folder + "/bad.toml", scenario("link = \"udp://127.0.0.1\"\n", "2.0"));
  ran = test::leadline("simulate " + bad + " --output " + folder + "/out --live");
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.err, AllOf(HasSubstr("bad.toml:16"), HasSubstr("no port is given")));
  EXPECT_FALSE(std::filesystem::exists(folder + "/out"));
}

}  // namespace
}  // namespace leadline
