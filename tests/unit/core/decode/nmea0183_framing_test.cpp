#include <gtest/gtest.h>

#include <random>
#include <string>

#include "core/decode/nmea0183.h"
#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"

namespace leadline::decode {
namespace {

using test::Decoded;

const Arrival kArrival = arrival_at(*parse_iso8601("2026-11-22T12:35:20Z"));
const std::string kHdt = "$HEHDT,001.7,T*29";

DecoderSettings checksum_optional() {
  DecoderSettings settings;
  settings.checksum_required = false;
  return settings;
}

/// Names of unknown sentences live in their decoder, so it outlives what it reported.
Decoder& kept_decoder(const DecoderSettings& settings) {
  static std::vector<std::unique_ptr<Decoder>> kept;
  return *kept.emplace_back(make_nmea0183(settings));
}

Decoded decode(std::string_view text, std::size_t chunk = 0, const DecoderSettings& settings = {}) {
  return test::decode_all(kept_decoder(settings), test::as_bytes(text), kArrival, chunk);
}

Decoded decode_in_two(std::string_view text, std::size_t cut) {
  Decoder& decoder = kept_decoder({});
  Decoded out;
  decoder.feed(test::as_bytes(text.substr(0, cut)), kArrival, out);
  decoder.feed(test::as_bytes(text.substr(cut)), kArrival, out);
  decoder.finish(out);
  return out;
}

::testing::AssertionResult covers(const Decoded& all, std::size_t size) {
  std::uint64_t at = 0;
  for (const auto& frame : all.frames) {
    if (frame.offset != at || frame.length == 0)
      return ::testing::AssertionFailure() << "a report at " << frame.offset << ", expected at " << at;
    at += frame.length;
  }
  if (at != size || all.ledger.bytes_total() != size)
    return ::testing::AssertionFailure() << at << " of " << size << " bytes";
  return ::testing::AssertionSuccess();
}

struct Expected {
  ByteClass byte_class;
  std::string kind, reason;
  std::uint32_t length;
};

void expect_frames(const std::string& text, const std::vector<Expected>& expected,
                   const DecoderSettings& settings = {}) {
  const auto all = decode(text, 0, settings);
  EXPECT_TRUE(covers(all, text.size())) << text;
  ASSERT_EQ(all.frames.size(), expected.size()) << text;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(all.frames[i].byte_class, expected[i].byte_class) << text << " #" << i;
    EXPECT_EQ(all.frames[i].kind, expected[i].kind) << text << " #" << i;
    EXPECT_EQ(all.frames[i].reason, expected[i].reason) << text << " #" << i;
    EXPECT_EQ(all.frames[i].length, expected[i].length) << text << " #" << i;
  }
}

TEST(Nmea0183Framing, EndsASentenceAtCrLfAtLfAndAtCr) {
  expect_frames(kHdt + "\r\n" + kHdt + "\n" + kHdt + "\r" + kHdt + "\r\r\n",
                {{ByteClass::decoded, "HDT", "", 19},
                 {ByteClass::decoded, "HDT", "", 18},
                 {ByteClass::decoded, "HDT", "", 18},
                 {ByteClass::decoded, "HDT", "", 18},
                 {ByteClass::comment, "", "", 2}});
}

TEST(Nmea0183Framing, GivesTheFactsAtTheCrAndTheReportAfterTheLf) {
  const auto decoder = make_nmea0183({});
  Decoded out;
  decoder->feed(test::as_bytes(kHdt + "\r"), kArrival, out);
  EXPECT_EQ(out.facts.size(), 1u);
  EXPECT_EQ(out.frames.size(), 0u);
  decoder->feed(test::as_bytes("\n"), kArrival, out);
  ASSERT_EQ(out.frames.size(), 1u);
  EXPECT_EQ(out.frames[0].length, 19u);
}

TEST(Nmea0183Framing, ANewSentenceTearsTheOneBefore) {
  // As in a public log (wire-formats 1).
  const std::string gga =
      "$GPGGA,123519.50,5912.34567,N,00512.34567,E,4,14,0.7,41.20,M,44.10,M,1.2,0123*71\r\n";
  expect_frames("$PRDID,-000.16,-000.47,185280" + gga,
                {{ByteClass::refused, "PRDID", "torn", 29}, {ByteClass::decoded, "GGA", "", 82}});
  expect_frames("4.4343,N,01025.5386,E,200002,A,D*48\r\n", {{ByteClass::refused, "sentence", "torn", 37}});
}

TEST(Nmea0183Framing, RefusalsHaveFixedWords) {
  expect_frames("$HEHDT,001.7,T*28\r\n", {{ByteClass::refused, "HDT", "checksum", 19}});
  expect_frames("$HEHDT,001.7,T*2\r\n", {{ByteClass::refused, "HDT", "checksum", 18}});
  expect_frames("$HEHDT,001.7,T\r\n", {{ByteClass::refused, "HDT", "checksum absent", 16}});
  expect_frames("$HEHDT,00\x01.7,T*29\r\n", {{ByteClass::refused, "HDT", "not printable", 19}});
  expect_frames("$HEHDT,00", {{ByteClass::refused, "HDT", "truncated", 9}});
  expect_frames("$HEHDT,001.7,T*2", {{ByteClass::refused, "HDT", "truncated", 16}});
  expect_frames("$HEHDT,x,T*79\n", {{ByteClass::refused, "HDT", "fields", 14}});
}

TEST(Nmea0183Framing, AWholeSentenceAtTheEndNeedsNoTerminatorButAChecksum) {
  expect_frames(kHdt, {{ByteClass::decoded, "HDT", "", 17}});
  expect_frames("$HEHDT,001.7,T", {{ByteClass::refused, "HDT", "truncated", 14}}, checksum_optional());
}

TEST(Nmea0183Framing, ChecksumsMayBeAbsentWhereThatIsAllowedAndAreNeverWrong) {
  const auto all = decode("$HEHDT,001.7,T\r\n", 0, checksum_optional());
  EXPECT_EQ(all.all<Heading>().size(), 1u);
  EXPECT_EQ(all.ledger.checksums(ChecksumState::absent), 1u);
  expect_frames("$HEHDT,001.7,T*28\r\n", {{ByteClass::refused, "HDT", "checksum", 19}}, checksum_optional());
  const auto lower = decode("$KIDPT,4419.96,8.20,12000.0*7e\n");
  EXPECT_EQ(lower.ledger.checksums(ChecksumState::ok), 1u);
}

TEST(Nmea0183Framing, TakesUpTo512BytesAndNoMore) {
  const auto padded = [](std::size_t size) { return "$GPTXT," + std::string(size - 7, 'x'); };
  expect_frames(padded(512) + "\r\n", {{ByteClass::unused, "TXT", "", 514}}, checksum_optional());
  expect_frames(padded(513) + "\r\n" + kHdt + "\n",
                {{ByteClass::refused, "TXT", "too long", 512},
                 {ByteClass::skipped, "", "", 3},
                 {ByteClass::decoded, "HDT", "", 18}},
                checksum_optional());
  expect_frames(padded(3000) + kHdt + "\n",
                {{ByteClass::refused, "TXT", "too long", 512},
                 {ByteClass::skipped, "", "", 2488},
                 {ByteClass::decoded, "HDT", "", 18}},
                checksum_optional());
}

TEST(Nmea0183Framing, SortsWhatLiesBetweenSentences) {
  expect_frames("# log of $GPGGA*00\n\n \nhello, world\n\x01\x02\xB5" + kHdt + "\n",
                {{ByteClass::comment, "", "", 19},
                 {ByteClass::comment, "", "", 1},
                 {ByteClass::comment, "", "", 2},
                 {ByteClass::unknown, "text", "", 13},
                 {ByteClass::skipped, "", "", 3},
                 {ByteClass::decoded, "HDT", "", 18}});
  expect_frames(std::string(600, 'a') + "\n", {{ByteClass::skipped, "", "", 601}});
}

TEST(Nmea0183Framing, TagBlocksAreAccountedApart) {
  expect_frames("\\s:HE0001*45\\$HEROT,+000.05,A*35\r\n",
                {{ByteClass::unused, "TAG", "", 13}, {ByteClass::decoded, "ROT", "", 21}});
  expect_frames("\\s:HE0001*44\\$HEROT,+000.05,A*35\r\n",
                {{ByteClass::refused, "TAG", "checksum", 13}, {ByteClass::decoded, "ROT", "", 21}});
  EXPECT_EQ(decode("\\s:HE0001*45\\$HEROT,+000.05,A*35\r\n").ledger.frames(), 1u);
}

TEST(Nmea0183Framing, EndlessLinesAreToldInPieces) {
  const auto all = decode("#" + std::string(3 << 20, 'x'), 65536);
  EXPECT_TRUE(covers(all, (3 << 20) + 1));
  EXPECT_EQ(all.ledger.bytes(ByteClass::comment), static_cast<std::uint64_t>((3 << 20) + 1));
  const auto rubbish = decode(std::string(3 << 20, '\x02'), 65536);
  EXPECT_EQ(rubbish.ledger.bytes(ByteClass::skipped), static_cast<std::uint64_t>(3 << 20));
  EXPECT_LE(rubbish.frames.size(), 4u);
}

TEST(Nmea0183Framing, EverySplitInTwoGivesTheSame) {
  const std::string text =
      "# "
      "log\r\n\r\n$PRDID,-000.16,185280$GPGGA,123519.50,5912.34567,N,00512.34567,E,4,14,0.7,41.20,M,44.10,M,"
      "1.2,0123*71\r"
      "$GNRMC,123519.50,A,3348.1234,S,15112.5678,E,4.20,271.4,221126,11.5,E,D,S*41\r\n\\s:HE0001*45\\$HEROT,+"
      "000.05,A*35"
      "\n\x01\x02tail*7F\r\r\n$PSXN,23,0.35,-1.74,218.26,0.58*13\r\n$GPTXT," +
      std::string(700, 'x') + "\r\nplain text\n" + kHdt;
  const auto whole = decode(text);
  EXPECT_TRUE(covers(whole, text.size()));
  EXPECT_EQ(whole.facts.size(), 8u);
  for (std::size_t cut = 1; cut < text.size(); ++cut) {
    const Decoded parts = decode_in_two(text, cut);
    ASSERT_TRUE(whole.frames.size() == parts.frames.size() && test::same(whole, parts)) << "cut at " << cut;
  }
}

TEST(Nmea0183Framing, EveryChunkSizeGivesTheSameOverAllSamples) {
  const std::string text = test::read_text(test::data_path("wire-samples/nmea.txt")) +
                           test::read_text(test::data_path("nmea_gpsd/ac12.log")) +
                           test::read_text(test::data_path("nmea_gpsd/ait250.log"));
  const auto whole = decode(text);
  EXPECT_TRUE(covers(whole, text.size()));
  for (const std::size_t chunk : {1, 2, 3, 7, 64, 511, 512, 513, 4096}) {
    const Decoded parts = decode(text, chunk);
    ASSERT_TRUE(whole.frames.size() == parts.frames.size() && test::same(whole, parts)) << chunk;
  }
}

TEST(Nmea0183Framing, EveryPrefixIsAccountedFor) {
  const std::string text = test::read_text(test::data_path("wire-samples/nmea.txt"));
  for (std::size_t size = 0; size <= text.size(); ++size)
    ASSERT_TRUE(covers(decode(std::string_view(text).substr(0, size)), size)) << size;
}

TEST(Nmea0183Framing, RandomEditsNeverCrashAndLoseNoByte) {
  const std::string original = test::read_text(test::data_path("wire-samples/nmea.txt")) +
                               test::read_text(test::data_path("nmea_gpsd/ac12.log"));
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::string text = original;
    for (char& c : text)
      if (random() % 50 == 0) c = static_cast<char>(random());
    const auto all = decode(text, 0, round % 2 == 0 ? DecoderSettings{} : checksum_optional());
    ASSERT_TRUE(covers(all, text.size())) << "round " << round;
    for (const auto& fact : all.facts)
      if (const auto* fix = std::get_if<GnssFix>(&fact.message)) {
        ASSERT_LE(std::abs(fix->position.lat.deg()), 90.0);
        ASSERT_LE(std::abs(fix->position.lon.deg()), 180.0);
      }
  }
}

TEST(Nmea0183Framing, TheSecondSentenceAfterGarbageIsDecoded) {
  std::mt19937 random(2);
  for (int round = 0; round < 300; ++round) {
    std::string garbage(1 + random() % 700, ' ');
    for (char& c : garbage) c = static_cast<char>(random());
    const auto all = decode(garbage + kHdt + "\r\n" + kHdt + "\r\n");
    ASSERT_GE(all.all<Heading>().size(), 1u) << round;
    ASSERT_EQ(all.frames.back().byte_class, ByteClass::decoded) << round;
  }
}

}  // namespace
}  // namespace leadline::decode
