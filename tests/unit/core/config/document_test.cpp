#include "core/config/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/config/readers.h"

namespace leadline::config {
namespace {

using test::Every;
using test::lines_of;
using testing::ElementsAre;
using testing::IsEmpty;

/// Reads `text` as keys of the root; its problems.
std::vector<std::string> problems_of(const std::string& text, Every& every) {
  Document document = Document::parse(text, "a.toml");
  document.root().read(every.keys());
  document.finish();
  return lines_of(document);
}
std::vector<std::string> problems_of(const std::string& text) {
  Every every;
  return problems_of(text, every);
}

TEST(Document, SetsEachKindOfTarget) {
  Every every;
  EXPECT_THAT(
      problems_of("rate_hz = 2.5\ndeclination_deg = -7.8\nenabled = false\nskip_lines = 3\nname = 'dvl'\n"
                  "mode = \"gps\"\ndate = \"2017-08-01\"\ncolumns = [\"a\", \"b\"]\nsentences = ['HDT']\n",
                  every),
      IsEmpty());
  EXPECT_EQ(every.rate_hz, 2.5);
  EXPECT_EQ(every.declination_deg, -7.8);
  EXPECT_FALSE(every.enabled);
  EXPECT_EQ(every.skip_lines, 3);
  EXPECT_EQ(every.name, "dvl");
  EXPECT_EQ(every.mode, "gps");
  EXPECT_EQ(every.date, "2017-08-01");
  EXPECT_THAT(every.columns, ElementsAre("a", "b"));
  EXPECT_THAT(every.sentences, ElementsAre("HDT"));
}

TEST(Document, KeepsDefaultsOfWhatIsAbsentOrWrong) {
  Every every;
  every.columns = {"kept"};
  EXPECT_EQ(
      problems_of("rate_hz = 1e9\nmode = 'tai'\ncolumns = ['x', 1]\ndeclination_deg = nan", every).size(),
      4u);
  Every untouched;
  untouched.columns = {"kept"};
  EXPECT_EQ(every, untouched);
}

TEST(Document, AWholeNumberIsANumber) {
  Every every;
  EXPECT_THAT(problems_of("rate_hz = 10\ndeclination_deg = 3", every), IsEmpty());
  EXPECT_EQ(every.rate_hz, 10.0);
  EXPECT_EQ(every.declination_deg, 3.0);
}

TEST(Document, ADateMayStandWithoutQuotes) {
  Every every;
  EXPECT_THAT(problems_of("date = 2017-08-01", every), IsEmpty());
  EXPECT_EQ(every.date, "2017-08-01");
}

TEST(Document, RefusesWhatIsNoDate) {
  EXPECT_THAT(problems_of("\ndate = \"1/8/2017\""),
              ElementsAre("a.toml:2: date: is \"1/8/2017\"; must be a date YYYY-MM-DD"));
  EXPECT_THAT(problems_of("date = '2017-02-30'"),
              ElementsAre("a.toml:1: date: is \"2017-02-30\"; must be a date YYYY-MM-DD"));
  EXPECT_THAT(problems_of("date = 2017-08-01T10:00:00Z"),
              ElementsAre("a.toml:1: date: is a time; must be a date YYYY-MM-DD"));
}

TEST(Document, NamesAWrongTypeWithLineAndWhatIsLegal) {
  EXPECT_THAT(
      problems_of("# one\nrate_hz = \"ten\"\nenabled = 1\nskip_lines = 1.5\nname = 7\ncolumns = \"a\"\n"
                  "declination_deg = {}\nmode = ['utc']\n"),
      ElementsAre("a.toml:2: rate_hz: is \"ten\"; must be a number from 0 to 100",
                  "a.toml:3: enabled: is 1; must be true or false",
                  "a.toml:4: skip_lines: is 1.5; must be a whole number, at least 0",
                  "a.toml:5: name: is 7; must be a text in quotes",
                  "a.toml:6: columns: is \"a\"; must be a list, each element a text in quotes",
                  "a.toml:7: declination_deg: is a table; must be a number from -180 to 180",
                  "a.toml:8: mode: is a list; must be one of \"utc\", \"gps\""));
}

TEST(Document, NamesWhatIsOutOfRangeOrNotANumber) {
  EXPECT_THAT(problems_of("rate_hz = 100.5\ndeclination_deg = -inf\nskip_lines = -1"),
              ElementsAre("a.toml:1: rate_hz: is 100.5; must be a number from 0 to 100",
                          "a.toml:2: declination_deg: is -inf; must be a number from -180 to 180",
                          "a.toml:3: skip_lines: is -1; must be a whole number, at least 0"));
  EXPECT_THAT(problems_of("rate_hz = nan"),
              ElementsAre("a.toml:1: rate_hz: is nan; must be a number from 0 to 100"));
  EXPECT_THAT(problems_of("rate_hz = 100\ndeclination_deg = -180.0"), IsEmpty());  // the bounds are legal
}

TEST(Document, NamesTheElementOfAListThatIsWrong) {
  EXPECT_THAT(problems_of("sentences = [\n  'GGA',\n  'RMC',\n  5,\n]"),
              ElementsAre("a.toml:3: sentences[2]: is \"RMC\"; must be one of \"GGA\", \"HDT\"",
                          "a.toml:4: sentences[3]: is 5; must be one of \"GGA\", \"HDT\""));
}

TEST(Document, RequiredKeysMustBeThereAndNotEmpty) {
  Document document =
      Document::parse("[[source]]\nname = ''\n[[source]]\nlink = 'x'\nname = 'dvl'\n", "a.toml");
  auto sources = document.root().tables("source");
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_FALSE(sources[0].require("name"));
  EXPECT_TRUE(sources[1].require("name"));
  EXPECT_FALSE(sources[1].require("decoder"));
  EXPECT_THAT(lines_of(document), ElementsAre("a.toml:2: source[1].name: is empty; must be given",
                                              "a.toml:3: source \"dvl\".decoder: is missing; must be given"));
}

TEST(Document, PathsNameTablesAndListElements) {
  Document document = Document::parse(
      "[navigation.aiding]\nrate_hz = -1\n[[source]]\nname = \"dvl\"\nmount = { yaw_deg = 400 }\n[[source]]\n"
      "[source.mount]\npitch_deg = 91\n",
      "leadline.toml");
  test::read_all(document);
  EXPECT_THAT(
      lines_of(document),
      ElementsAre("leadline.toml:2: navigation.aiding.rate_hz: is -1; must be a number from 0 to 100",
                  "leadline.toml:5: source \"dvl\".mount.yaw_deg: is 400; must be a number from -360 to 360",
                  "leadline.toml:6: source[2].name: is missing; must be given",
                  "leadline.toml:8: source[2].mount.pitch_deg: is 91; must be a number from -90 to 90"));
}

TEST(Document, AnAbsentTableIsEmptyAndKnown) {
  Document document = Document::parse("[vehicle]\n", "a.toml");
  Table vehicle = document.root().table("vehicle");
  Table aiding = document.root().table("navigation").table("aiding");
  Every every;
  aiding.read(every.keys());
  EXPECT_TRUE(vehicle.given());
  EXPECT_FALSE(aiding.given());
  EXPECT_FALSE(aiding.has("rate_hz"));
  EXPECT_EQ(aiding.path_of("rate_hz"), "navigation.aiding.rate_hz");
  EXPECT_THAT(document.root().tables("source"), IsEmpty());
  document.finish();
  EXPECT_TRUE(document.ok());
}

TEST(Document, TablesOfTheWrongKindAreNamed) {
  Document document = Document::parse("navigation = 3\nsource = [1]\n[[vehicle]]\n[output]\n", "a.toml");
  document.root().table("navigation");
  document.root().table("vehicle");
  EXPECT_THAT(document.root().tables("source"), IsEmpty());
  EXPECT_THAT(document.root().tables("output"), IsEmpty());
  document.finish();
  EXPECT_THAT(lines_of(document),
              ElementsAre("a.toml:1: navigation: is 3; must be a table, [navigation]",
                          "a.toml:2: source[1]: is 1; must be a table, [[source]]",
                          "a.toml:3: vehicle: is a list; must be a table, [vehicle]",
                          "a.toml:4: output: is a table; must be a list of tables, each [[output]]"));
}

TEST(Document, ReadersAddTheirOwnProblemsInOrderOfLines) {
  Document document = Document::parse("\n[[source]]\nname = 'a'\n[[source]]\nname = 'a'\n", "a.toml");
  auto sources = document.root().tables("source");
  EXPECT_EQ(sources[0].line(), 2);
  EXPECT_EQ(sources[1].line_of("name"), 5);
  EXPECT_EQ(sources[1].line_of("link"), 4);
  sources[1].report("name", "is the name of another source");
  sources[0].report("", "has no link");
  document.report(1, "version", "is missing");
  EXPECT_THAT(lines_of(document),
              ElementsAre("a.toml:1: version: is missing", "a.toml:2: source \"a\": has no link",
                          "a.toml:5: source \"a\".name: is the name of another source"));
}

TEST(Document, ProblemsStayOnOneLine) {
  const auto lines = problems_of("\"a\\nb\" = 1\nmode = \"x\\ny\"\n");
  EXPECT_THAT(lines,
              ElementsAre("a.toml:1: \"a\\u000Ab\": unknown key; known here are rate_hz, declination_deg, "
                          "enabled, skip_lines, name, mode, date, columns ...",
                          "a.toml:2: mode: is \"x\\u000Ay\"; must be one of \"utc\", \"gps\""));
}

TEST(Document, KeepsItsText) {
  EXPECT_EQ(Document::parse("version = 1\n", "a.toml").text(), "version = 1\n");
}

}  // namespace
}  // namespace leadline::config
