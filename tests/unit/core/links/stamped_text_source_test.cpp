#include "core/links/stamped_text_source.h"

#include <algorithm>

#include "tests/support/files.h"
#include "tests/unit/core/links/made_file.h"

namespace leadline::links {
namespace {

using test::all_chunks;
using test::byte_sum;
using test::MadeFile;

const std::string kPalmer = "nmea_openrvdas_nbp1406/NBP1406_";

TEST(StampedText, TheSentenceBehindTheStampKeepsItsTerminator) {
  const MadeFile file("2014-08-01T00:00:00.183000Z $HEHDT,218.53,T*12\n2014-08-01T00:00:00.383Z \r\nx\n");
  StampedTextSource source(file.open(), 4);
  const auto chunks = all_chunks(source);
  const std::int64_t midnight = parse_date("2014-08-01")->ns;
  ASSERT_EQ(chunks.size(), 3u);
  EXPECT_EQ(chunks[0], (test::KeptChunk{4, midnight + 183000000, "$HEHDT,218.53,T*12\n", 28, {}, ""}));
  EXPECT_EQ(chunks[1], (test::KeptChunk{4, midnight + 383000000, "\r\n", 25, {}, ""}));
  EXPECT_EQ(chunks[2], (test::KeptChunk{4, midnight + 383000000, "x\n", 0, ByteClass::refused, "stamp"}));
}

TEST(StampedText, TheShipsLogsAreWholeAndEveryByteIsAccounted) {
  for (const char* name : {"adcp", "gp02", "gyr1", "knud", "mbdp", "s330", "svp1"}) {
    auto opened = FileReader::open(test::data_path(kPalmer + name + "-2014-08-01"));
    ASSERT_TRUE(opened) << opened.error().line();
    const std::uint64_t size = opened.value().size();
    StampedTextSource source(std::move(opened).value(), 0);
    const auto chunks = all_chunks(source);
    EXPECT_EQ(chunks.size(), 5000u) << name;
    EXPECT_EQ(byte_sum(chunks), size) << name;
    EXPECT_EQ(source.backward_stamps(), 0u) << name;
    EXPECT_TRUE(std::all_of(chunks.begin(), chunks.end(), [](const auto& c) {
      return !c.settled && c.stamp_bytes == 28 && c.bytes.back() == '\n';
    })) << name;
  }
}

TEST(StampedText, ATornLastLineIsTruncatedOrASentence) {
  const std::string whole = "2014-08-01T00:00:00.183000Z $HEHDT";
  for (std::size_t cut = 1; cut <= whole.size(); ++cut) {
    const MadeFile file(whole.substr(0, cut));
    StampedTextSource source(file.open(), 0);
    const auto chunks = all_chunks(source);
    ASSERT_EQ(chunks.size(), 1u);
    ASSERT_EQ(chunks[0].reason, cut < 28 ? "truncated" : "") << cut;
    ASSERT_EQ(byte_sum(chunks), cut);
  }
}

TEST(StampedText, DamageNeverLosesAByte) {
  std::string content = test::read_text(test::data_path(kPalmer + "s330-2014-08-01"));
  content.resize(20000);
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const std::string bad = test::damaged(content, random, 2.0);
    const MadeFile file(bad);
    StampedTextSource source(file.open(), 0);
    ASSERT_EQ(byte_sum(all_chunks(source)), bad.size()) << i;
  }
}

}  // namespace
}  // namespace leadline::links
