#include "core/links/tlog_source.h"

#include <chrono>

#include "core/flow/ledger.h"
#include "tests/support/files.h"
#include "tests/unit/core/links/made_file.h"

namespace leadline::links {
namespace {

using test::all_chunks;
using test::byte_sum;
using test::MadeFile;

const std::vector<SourceName> kNames = {{"gps", 0}, {"dvl", 1}};

TEST(Tlog, ATextPayloadKeepsItsTerminatorAndTheStampIsCountedApart) {
  const MadeFile file("(1795350919.500000) gps $GPZDA,1*00\r\n(1795350919.600001) dvl :SA, 1.0\n");
  TlogSource source(file.open(), kNames);
  const auto chunks = all_chunks(source);
  ASSERT_EQ(chunks.size(), 2u);
  EXPECT_EQ(chunks[0], (test::KeptChunk{0, 1795350919500000000, "$GPZDA,1*00\r\n", 24, {}, ""}));
  EXPECT_EQ(chunks[1], (test::KeptChunk{1, 1795350919600001000, ":SA, 1.0\n", 24, {}, ""}));
  EXPECT_EQ(source.lines(), 2u);
}

TEST(Tlog, AHexPayloadIsDecodedAndItsSurplusOfFileBytesIsStamp) {
  const std::string line = "(1.000000) dvl #7f7F00aB\r\n";
  const MadeFile file(line + "(1.000000) dvl #\n");
  TlogSource source(file.open(), kNames);
  const auto chunks = all_chunks(source);
  ASSERT_EQ(chunks.size(), 2u);
  EXPECT_EQ(chunks[0].bytes, std::string("\x7f\x7f\x00\xab", 4));
  EXPECT_EQ(chunks[0].stamp_bytes, line.size() - 4);
  EXPECT_TRUE(chunks[1].bytes.empty()) << "an empty datagram";
  EXPECT_EQ(byte_sum(chunks), file.open().size());
}

TEST(Tlog, HexThatIsNoneIsRefused) {
  const MadeFile file("(1.0) dvl #7f7\n(2.0) dvl #7g\n(3.0) dvl #7f 7f\n(4.0) dvl #7f7");
  TlogSource source(file.open(), kNames);
  const auto chunks = all_chunks(source);
  ASSERT_EQ(chunks.size(), 4u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(chunks[i].reason, "hex") << i;
  EXPECT_EQ(chunks[3].reason, "truncated") << "the file ends inside it";
  EXPECT_EQ(chunks[2].arrival_ns, 3000000000);
  EXPECT_EQ(byte_sum(chunks), file.open().size());
}

TEST(Tlog, UnknownSourcesAreSettledAndCountedByName) {
  const MadeFile file("(1.0) sonar a\n(2.0) gps b\n(3.0) sonar #zz\n(4.0) GPS d\n");
  TlogSource source(file.open(), kNames);
  const auto chunks = all_chunks(source);
  EXPECT_EQ(chunks[0], (test::KeptChunk{kNoSource, 1000000000, "a\n", 12, ByteClass::unknown, ""}));
  EXPECT_EQ(chunks[1].settled, std::nullopt);
  EXPECT_EQ(source.unknown_sources(), (TlogSource::Counts{{"GPS", 1}, {"sonar", 2}})) << "names are exact";
  EXPECT_EQ(byte_sum(chunks), file.open().size());
}

TEST(Tlog, TheListOfUnknownNamesIsBounded) {
  std::string content;
  for (int i = 0; i < 1000; ++i) content += "(1.0) name" + std::to_string(i) + std::string(200, 'x') + " y\n";
  const MadeFile file(content);
  TlogSource source(file.open(), kNames);
  all_chunks(source);
  EXPECT_EQ(source.unknown_sources().size(), 256u);
  EXPECT_EQ(source.unknown_sources().at("(others)"), 1000u - 255u);
  for (const auto& [name, count] : source.unknown_sources()) EXPECT_LE(name.size(), 64u) << name;
}

TEST(Tlog, DamagedLinesAreRefusedAndCommentsAreComment) {
  const MadeFile file(
      "garbage\n# made by hand\n \r\n(5.0) gps a\n(x.0) gps b\n(6.0)\n(6.0) \n(7.0) gps\n(8.0) gps\t#\n");
  TlogSource source(file.open(), kNames);
  const auto chunks = all_chunks(source);
  ASSERT_EQ(chunks.size(), 9u);
  EXPECT_EQ(chunks[0], (test::KeptChunk{kNoSource, 5000000000, "garbage\n", 0, ByteClass::refused, "stamp"}))
      << "before the first stamp: its arrival is that stamp's, not 1970";
  EXPECT_EQ(chunks[1].settled, ByteClass::comment);
  EXPECT_EQ(chunks[2].settled, ByteClass::comment);
  EXPECT_EQ(chunks[3].settled, std::nullopt);
  for (int i : {4, 5, 6}) EXPECT_EQ(chunks[i].reason, "stamp") << i;
  EXPECT_EQ(chunks[4].arrival_ns, 5000000000);
  EXPECT_EQ(chunks[7].bytes, "\n") << "an empty sentence";
  EXPECT_EQ(byte_sum(chunks), file.open().size());
}

TEST(Tlog, TheLastLineIsALineWithoutANewlineAndTruncatedWithoutAPayload) {
  const std::string whole = "(1.0) gps a\n(1795350919.500000) gps $GPZDA";
  for (std::size_t cut = 12; cut <= whole.size(); ++cut) {
    const MadeFile file(whole.substr(0, cut));
    TlogSource source(file.open(), kNames);
    const auto chunks = all_chunks(source);
    ASSERT_EQ(byte_sum(chunks), cut);
    if (cut == 12) {
      EXPECT_EQ(chunks.size(), 1u);
    } else if (cut < std::string("(1.0) gps a\n(1795350919.500000) gps ").size()) {
      ASSERT_EQ(chunks.at(1).reason, "truncated") << whole.substr(0, cut);
    } else {
      ASSERT_EQ(chunks.at(1).settled, std::nullopt) << whole.substr(0, cut);
    }
  }
}

TEST(Tlog, BackwardStampsAreHandedOnAsTheyAreAndCounted) {
  const MadeFile file("(10.0) gps a\n(9.0) gps b\n(9.5) gps c\n(8.0) gps d\n(11.0) gps e\n");
  TlogSource source(file.open(), kNames);
  std::vector<std::int64_t> seconds;
  for (const auto& c : all_chunks(source)) seconds.push_back(c.arrival_ns / 100000000);
  EXPECT_EQ(seconds, (std::vector<std::int64_t>{100, 90, 95, 80, 110}));
  EXPECT_EQ(source.backward_stamps(), 2u);
}

TEST(Tlog, StampsAreRoundedToTheMicrosecond) {
  const MadeFile file("(1.0000005) gps a\n(1.000000499) gps b\n(2.9999999) gps c\n");
  TlogSource source(file.open(), kNames);
  const auto chunks = all_chunks(source);
  EXPECT_EQ(chunks[0].arrival_ns, 1000001000);
  EXPECT_EQ(chunks[1].arrival_ns, 1000000000);
  EXPECT_EQ(chunks[2].arrival_ns, 3000000000);
}

TEST(Tlog, ALineAboveTheCeilingIsRefusedOnce) {
  const MadeFile file("(1.0) gps a\n(2.0) gps " + std::string(200000, 'x') + "\n# " +
                      std::string(200000, 'y') + "\n(3.0) gps b\n");
  TlogSource source(file.open(), kNames);
  const auto chunks = all_chunks(source);
  Ledger ledger;
  for (Chunk c; const auto& k : chunks) {
    c.bytes = {reinterpret_cast<const std::uint8_t*>(k.bytes.data()), k.bytes.size()};
    c.stamp_bytes = k.stamp_bytes, c.settled = k.settled, c.reason = k.reason;
    ledger.count(c);
  }
  ASSERT_EQ(ledger.refusals().size(), 1u);
  EXPECT_EQ(ledger.refusals()[0].name, "too long");
  EXPECT_EQ(ledger.refusals()[0].count, 1u);
  EXPECT_EQ(ledger.bytes(ByteClass::skipped), 10 + 200000 + 1 - 65536u);
  EXPECT_EQ(ledger.bytes(ByteClass::comment), 200003u);
  EXPECT_EQ(chunks.back().bytes, "b\n");
  EXPECT_EQ(source.lines(), 4u);
  EXPECT_EQ(byte_sum(chunks), file.open().size());
}

TEST(Tlog, AByteOrderMarkIsPartOfTheFirstStamp) {
  const MadeFile file("\xEF\xBB\xBF(1.0) gps a\n");
  TlogSource source(file.open(), kNames);
  const auto chunks = all_chunks(source);
  ASSERT_EQ(chunks.size(), 1u);
  EXPECT_EQ(chunks[0].bytes, "a\n");
  EXPECT_EQ(chunks[0].stamp_bytes, 13u);
}

TEST(Tlog, AnEmptyFileHasNoChunks) {
  const MadeFile file("");
  TlogSource source(file.open(), kNames);
  EXPECT_TRUE(all_chunks(source).empty());
}

TEST(Tlog, DamageNeverLosesAByte) {
  std::string content;
  for (int i = 0; i < 300; ++i) {
    const std::string stamp = "(17953509" + std::to_string(10 + i % 80) + ".123456) ";
    content += stamp + (i % 3 == 0   ? "dvl #7f7f0a0b0c\n"
                        : i % 3 == 1 ? "gps $GPGGA,1,2,3*00\r\n"
                                     : "none x\n");
  }
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const std::string bad = test::damaged(content, random, 2.0);
    const MadeFile file(bad);
    TlogSource source(file.open(), kNames);
    ASSERT_EQ(byte_sum(all_chunks(source)), bad.size()) << i;
  }
}

}  // namespace
}  // namespace leadline::links
