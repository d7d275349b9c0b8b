// Files that are no configuration: each is a problem with its line, none is a crash.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/unit/core/config/readers.h"

namespace leadline::config {
namespace {

using test::lines_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Problem only_problem(const std::string& text) {
  const Document document = Document::parse(text, "a.toml");
  EXPECT_THAT(document.problems(), SizeIs(1)) << text.substr(0, 100);
  return document.ok() ? Problem{} : document.problems()[0];
}

TEST(Syntax, ErrorsHaveTheirLine) {
  for (const char* bad :
       {"a = ", "= 1", "[a", "a = 'x", "a = 01", "a = [1,", "a b = 1", "a = tru", "a = \"\\q\"",
        "a = 2017-13-01", "a = 1 b = 2", "a = \x01", "a = \"\xff\"", "a = 99999999999999999999"}) {
    const Problem problem = only_problem("version = 1\n\n" + std::string(bad) + "\n");
    EXPECT_THAT(problem.line, testing::AnyOf(3, 4))
        << bad;  // a line end inside a value is where toml++ notices
    EXPECT_THAT(problem.text, HasSubstr("not TOML: ")) << bad;
  }
}

TEST(Syntax, DuplicatesHaveTheirLine) {
  EXPECT_EQ(only_problem("a = 1\nb = 2\na = 3\n").line, 3);
  EXPECT_EQ(only_problem("[a]\n[b]\n\n[a]\n").line, 4);
  EXPECT_EQ(only_problem("[[source]]\nname = 'x'\nname = 'y'\n").line, 3);
  EXPECT_EQ(only_problem("m = { a = 1, a = 2 }\n").line, 1);
  EXPECT_THAT(only_problem("a = 1\na = 3\n").line_text(), HasSubstr("a.toml:2: not TOML: "));
}

TEST(Syntax, ABrokenFileIsAnEmptyDocument) {
  Document document = Document::parse("rate_hz = 5\n[", "a.toml");
  test::Every every;
  document.root().read(every.keys());
  document.finish();
  EXPECT_EQ(every.rate_hz, 1.0);
  EXPECT_THAT(document.problems(), SizeIs(1));
}

TEST(Depth, Of32IsReadAnd33Refused) {
  const auto nested = [](std::size_t depth) {
    return "\nx = " + std::string(depth, '[') + std::string(depth, ']') + "\n";
  };
  EXPECT_TRUE(Document::parse(nested(32), "a.toml").ok());
  const Problem problem = only_problem(nested(33));
  EXPECT_EQ(problem.line, 2);
  EXPECT_EQ(problem.text, "tables and lists are inside each other more than 32 deep");
}

TEST(Depth, CountsKeysHeadersAndInlineTablesTogether) {
  std::string header = "[a", key = "a", braces = "{ a = 1 }";
  for (int i = 0; i < 19; ++i) header += ".a", key += ".a", braces = "{ a = " + braces + " }";
  EXPECT_EQ(only_problem(header + "]\nb = 1\n" + key + " = 1\n").line, 3);
  EXPECT_TRUE(Document::parse(header + "]\n", "a.toml").ok());
  EXPECT_EQ(only_problem(header + "]\n\nx = " + braces + "\n").line, 3);
}

TEST(Depth, OfMillionsIsRefusedBeforeItIsBuilt) {
  std::string dots = "a";
  for (int i = 0; i < 1'000'000; ++i) dots += ".a";
  EXPECT_EQ(only_problem("\n" + dots + " = 1\n").line, 2);
  EXPECT_EQ(only_problem("\n\n[" + dots + "]\n").line, 3);
  EXPECT_EQ(only_problem(std::string(1'000'000, '[')).line, 1);
  EXPECT_EQ(only_problem("a = " + std::string(1'000'000, '{')).line, 1);
  EXPECT_EQ(only_problem("x = \"\"\"\n\"\"\"\"\nm = { " + dots + " = 1 }\n").line, 3);
}

TEST(Depth, DotsAndBracketsInTextsAndCommentsDoNotCount) {
  const std::string many(100, '['), dots(100, '.');
  Document document =
      Document::parse("# " + many + dots + "\na = \"" + many + "\\\"" + dots + "\"\nb = '" + many +
                          "\\'\nc = \"\"\"\n" + many + "\"\" " + dots + "\"\"\"\nd = '''\n" + dots + "'''\n",
                      "a.toml");
  EXPECT_THAT(lines_of(document), IsEmpty());
}

TEST(Size, Over10MiBIsRefused) {
  std::string text(Document::kLargest, '\n');
  EXPECT_TRUE(Document::parse(text, "a.toml").ok());
  text += '\n';
  const Problem problem = only_problem(text);
  EXPECT_EQ(problem.line_text(), "a.toml: is larger than 10 MiB: not a configuration");
}

struct Load : testing::Test {
  std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "leadline_config_load.toml";
  void write(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  ~Load() override { std::filesystem::remove(path); }
};

TEST_F(Load, ReadsAFile) {
  write("version = 1\r\nrate_hz = 7\r\n");
  Document document = Document::load(path.string());
  test::Every every;
  document.root().read(every.keys());
  EXPECT_TRUE(document.ok());
  EXPECT_EQ(every.rate_hz, 7.0);
  EXPECT_EQ(document.file(), path.string());
}

TEST_F(Load, NamesTheFileInEachProblem) {
  write("a = \n");
  EXPECT_THAT(lines_of(Document::load(path.string())),
              ElementsAre(testing::StartsWith(path.string() + ":1: not TOML: ")));
}

TEST_F(Load, RefusesTooLargeAFile) {
  write(std::string(Document::kLargest + 1, '\n'));
  EXPECT_THAT(lines_of(Document::load(path.string())),
              ElementsAre(path.string() + ": is larger than 10 MiB: not a configuration"));
}

TEST_F(Load, WhatCannotBeReadIsAProblem) {
  EXPECT_THAT(lines_of(Document::load("/no/such/file.toml")),
              ElementsAre("/no/such/file.toml: cannot be read: No such file or directory"));
  EXPECT_THAT(lines_of(Document::load("/")), ElementsAre("/: cannot be read: Is a directory"));
}

const char* const kWhole = R"(
rate_hz = 5.5e0 # five
enabled = true
date = 2017-08-01
[navigation]
name = "a \"b\" \u00e4"
columns = [ "a", 'b',
  """c
d""", '''e''' ]
[navigation.aiding]
declination_deg = -7_8.0
skip_lines = 0x10
[[source]]
name = "dvl"
link = 'udp://0.0.0.0:4001'
mount = { yaw_deg = 45.0, x_m = 0.2 }
[[source]]
name = "imu"
date = "2017-08-01"
[source.mount]
roll_deg = +1
)";

TEST(Damage, EveryPrefixIsReadOrRefused) {
  const std::string whole = kWhole;
  Document complete = Document::parse(whole, "a.toml");
  test::read_all(complete);
  ASSERT_THAT(lines_of(complete), IsEmpty());
  int refused = 0;
  for (std::size_t n = 0; n < whole.size(); ++n) {
    Document document = Document::parse(whole.substr(0, n), "a.toml");
    test::read_all(document);
    refused += document.ok() ? 0 : 1;
    for (const Problem& problem : document.problems()) ASSERT_GE(problem.line, 1) << n;
  }
  EXPECT_GT(refused, 100);
}

TEST(Damage, AnyBytesAreReadOrRefused) {
  std::mt19937_64 random(13);
  const std::string alphabet = "[]{}=.,\"'#\n\\ab1e-+:T_ \t\r\xff\xc3";
  for (int round = 0; round < 3000; ++round) {
    std::string text = round % 2 ? kWhole : "";
    if (text.empty())
      for (std::uint64_t n = random() % 60; n > 0; --n) text += alphabet[random() % alphabet.size()];
    for (std::uint64_t n = random() % 4; n > 0 && !text.empty(); --n)
      text[random() % text.size()] =
          round % 3 ? alphabet[random() % alphabet.size()] : static_cast<char>(random());
    Document document = Document::parse(text, "a.toml");
    test::read_all(document);
    for (const Problem& problem : document.problems()) {
      const std::string line = problem.line_text();
      ASSERT_EQ(line.find('\n'), std::string::npos) << line;
    }
  }
}

}  // namespace
}  // namespace leadline::config
