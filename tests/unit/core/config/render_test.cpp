#include "core/config/render.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/core/config/readers.h"

namespace leadline::config {
namespace {

using test::Every;
using test::lines_of;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Render, DocumentsEachKeyOnItsLine) {
  Every every;
  EXPECT_EQ(render("[every]", every.keys()),
            "[every]\n"
            "rate_hz = 1.0                     # how often (0 to 100)\n"
            "# declination_deg =               # east positive (-180 to 180)\n"
            "enabled = true\n"
            "skip_lines = 0                    # lines (at least 0)\n"
            "# name = \"\"                       # its name\n"
            "mode = \"utc\"                      # the clock (utc | gps)\n"
            "# date = \"\"                       # YYYY-MM-DD\n"
            "# columns = []                    # what they hold\n"
            "# sentences = []                  # what is sent (GGA | HDT)\n");
}

TEST(Render, DefaultsOfASourceParseBackAndPass) {
  SourceOptions source;
  MountOptions mount;
  CalibrationOptions calibration;
  const std::string text = render("[[source]]", bind(source_keys(), source)) +
                           render("[source.mount]", bind(mount_keys(), mount)) +
                           render("[[calibration]]", bind(calibration_keys(), calibration));
  EXPECT_THAT(text, HasSubstr("checksum = \"required\""));
  EXPECT_THAT(text, HasSubstr("# declination_deg ="));
  Document document = Document::parse(text, "example.toml");
  for (Table& table : document.root().tables("source")) {
    table.read(bind(source_keys(), source));
    table.table("mount").read(bind(mount_keys(), mount));
  }
  for (Table& table : document.root().tables("calibration"))
    table.read(bind(calibration_keys(), calibration));
  document.finish();
  EXPECT_THAT(lines_of(document), IsEmpty());
}

TEST(Render, AnyValuesComeBack) {
  std::mt19937_64 random(5);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto text = [&] {
    std::string t;
    for (std::uint64_t n = random() % 12; n > 0; --n) t += static_cast<char>(random() % 128);
    return t + "\xC3\xA4";
  };
  for (int i = 0; i < 300; ++i) {
    Every written;
    written.rate_hz = i % 7 == 0 ? 100.0 : number(0, 100) * (i % 3 == 0 ? 1e-12 : 1.0);
    if (i % 2) written.declination_deg = number(-180, 180);
    written.enabled = i % 3 == 0;
    written.skip_lines = static_cast<std::int64_t>(random() >> 1);
    written.name = text();
    written.mode = i % 2 ? "gps" : "utc";
    written.date = i % 2 ? "2024-02-29" : "";
    written.columns = {text(), "", text()};
    if (i % 2) written.sentences = {"HDT", "GGA"};
    const std::string toml = render("[\"a b\"]", written.keys());
    Document document = Document::parse(toml, "r.toml");
    Every read;
    document.root().table("a b").read(read.keys());
    document.finish();
    ASSERT_THAT(lines_of(document), IsEmpty()) << toml;
    ASSERT_EQ(read, written) << toml;
  }
}

TEST(Render, KeysOfTheRootHaveNoHeader) {
  std::int64_t version = 1;
  EXPECT_EQ(render("", {{"version", &version, "of this file's keys", 1, 1, {}}}),
            "version = 1                       # of this file's keys (1 to 1)\n");
}

TEST(Render, WhatIsNoNumberIsCommentedOut) {
  double limit = std::numeric_limits<double>::infinity();
  EXPECT_EQ(render("", {{"limit_m", &limit, "", 0, limit, {}}}),
            "# limit_m =                       # (at least 0)\n");
}

}  // namespace
}  // namespace leadline::config
