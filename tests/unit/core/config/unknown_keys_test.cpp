#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/config/readers.h"

namespace leadline::config {
namespace {

using test::lines_of;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> unknown_in(const std::string& text) {
  Document document = Document::parse(text, "leadline.toml");
  test::read_all(document);
  return lines_of(document);
}

TEST(UnknownKeys, NameTheNearestKnownKey) {
  EXPECT_THAT(
      unknown_in("[navigation.aiding]\n\nrate_hx = 2.0\n"),
      ElementsAre(
          "leadline.toml:3: navigation.aiding.rate_hx: unknown key; the nearest known key is rate_hz"));
}

TEST(UnknownKeys, AreLookedForInTheirOwnTable) {
  EXPECT_THAT(
      unknown_in("[[source]]\nname = 'dvl'\nchecksums = 'required'\nmount = { yaw = 3 }\n"),
      ElementsAre(
          "leadline.toml:3: source \"dvl\".checksums: unknown key; the nearest known key is checksum",
          "leadline.toml:4: source \"dvl\".mount.yaw: unknown key; the nearest known key is yaw_deg"));
}

TEST(UnknownKeys, WithoutANearOneListWhatIsKnown) {
  EXPECT_THAT(
      unknown_in("[[source]]\nname = 'dvl'\n[source.mount]\ncolour = 'red'\n"),
      ElementsAre(
          "leadline.toml:4: source \"dvl\".mount.colour: unknown key; known here are roll_deg, pitch_deg, "
          "yaw_deg, x_m, y_m, z_m"));
}

TEST(UnknownKeys, ATableNobodyKnowsIsOneProblem) {
  EXPECT_THAT(unknown_in("[navigaton]\nrate_hz = 1\nx = 2\n[navigaton.aiding]\n[[sources]]\nname = 'a'\n"),
              ElementsAre("leadline.toml:1: navigaton: unknown table; the nearest known key is navigation",
                          "leadline.toml:5: sources: unknown table; the nearest known key is source"));
}

TEST(UnknownKeys, ATableNobodyReadHasNoKnownKeys) {
  Document document = Document::parse("[ui]\nfont = 'x'\n", "a.toml");
  document.root().table("ui");
  document.finish();
  EXPECT_THAT(lines_of(document), ElementsAre("a.toml:2: ui.font: unknown key; nothing is known here"));
}

TEST(UnknownKeys, AreFoundInEachElementAndOnlyOnce) {
  Document document = Document::parse("[[source]]\nname = 'a'\n[[source]]\nname = 'b'\nlinc = 1\n", "a.toml");
  test::read_all(document);
  document.finish();
  EXPECT_THAT(lines_of(document),
              ElementsAre("a.toml:5: source \"b\".linc: unknown key; the nearest known key is link"));
}

TEST(UnknownKeys, AnEmptyKeyIsNamedByItsQuotes) {
  EXPECT_THAT(
      unknown_in("[navigation]\n'' = 1\n"),
      ElementsAre(testing::StartsWith("leadline.toml:2: navigation.\"\": unknown key; known here are ")));
}

TEST(UnknownKeys, AKnownKeyAlreadyFoundWrongIsNotToldTwice) {
  EXPECT_EQ(unknown_in("rate_hz = { a = 1 }\n").size(), 1u);
}

TEST(UnknownKeys, AThousandOfThemAreNotAllListed) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "zz" + std::to_string(i) + " = 1\n";
  const auto lines = unknown_in(text);
  EXPECT_EQ(lines.size(), Document::kMostProblems + 1);
  EXPECT_EQ(lines.back(), "leadline.toml: has more problems than these");
}

TEST(UnknownKeys, NoneInAKnownFile) {
  EXPECT_THAT(unknown_in("rate_hz = 1\n[navigation]\nname = 'x'\n"), IsEmpty());
}

}  // namespace
}  // namespace leadline::config
