#include "core/flow/ledger.h"

#include <gtest/gtest.h>

#include <string>

namespace leadline {
namespace {

FrameReport report(ByteClass c, std::string_view kind, std::uint32_t length, std::string_view reason = "") {
  FrameReport r;
  r.byte_class = c, r.kind = kind, r.length = length, r.reason = reason;
  return r;
}

TEST(Ledger, CountsFramesByClassAndBytesByClass) {
  Ledger ledger;
  ledger.count(report(ByteClass::decoded, "GGA", 70), Arrival{1});
  ledger.count(report(ByteClass::unused, "GSV", 60), Arrival{2});
  ledger.count(report(ByteClass::unknown, "XYZ", 20), Arrival{3});
  ledger.count(report(ByteClass::refused, "GGA", 50, "checksum"), Arrival{4});
  ledger.count(report(ByteClass::skipped, "", 5), Arrival{5});
  EXPECT_EQ(ledger.frames(), 4u);
  EXPECT_EQ(ledger.frames(ByteClass::decoded), 1u);
  EXPECT_EQ(ledger.frames(ByteClass::refused), 1u);
  EXPECT_EQ(ledger.frames(ByteClass::skipped), 0u);
  EXPECT_EQ(ledger.bytes(ByteClass::skipped), 5u);
  EXPECT_EQ(ledger.bytes_total(), 205u);
}

TEST(Ledger, AKindHasItsFirstAndLastArrival) {
  Ledger ledger;
  const std::string same_text_elsewhere = "GGA";
  ledger.count(report(ByteClass::decoded, "GGA", 70), Arrival{10});
  ledger.count(report(ByteClass::decoded, same_text_elsewhere, 70), Arrival{20});
  ledger.count(report(ByteClass::refused, "GGA", 70, "checksum"), Arrival{30});
  ASSERT_EQ(ledger.kinds().size(), 1u);
  EXPECT_EQ(ledger.kinds()[0].count, 2u);
  EXPECT_EQ(ledger.kinds()[0].first.ns, 10);
  EXPECT_EQ(ledger.kinds()[0].last.ns, 20);
}

TEST(Ledger, APartReportedApartIsNoFrame) {
  Ledger ledger;
  FrameReport part = report(ByteClass::unused, "water track", 40);
  part.block = true;
  ledger.count(part, Arrival{1});
  ledger.count(report(ByteClass::decoded, "ensemble", 200), Arrival{1});
  EXPECT_EQ(ledger.frames(), 1u);
  EXPECT_EQ(ledger.bytes_total(), 240u);
  EXPECT_EQ(ledger.kinds().size(), 2u);
}

TEST(Ledger, RefusalsAndSkippedBytesAreDamageUnknownIsNot) {
  Ledger clean, refused, skipped;
  clean.count(report(ByteClass::unknown, "XYZ", 20), Arrival{});
  refused.count(report(ByteClass::refused, "GGA", 20, "checksum"), Arrival{});
  refused.count(report(ByteClass::refused, "GGA", 20, "checksum"), Arrival{});
  refused.count(report(ByteClass::refused, "", 20, "truncated"), Arrival{});
  skipped.count(report(ByteClass::skipped, "", 1), Arrival{});
  EXPECT_FALSE(clean.damaged());
  EXPECT_TRUE(refused.damaged());
  EXPECT_TRUE(skipped.damaged());
  ASSERT_EQ(refused.refusals().size(), 2u);
  EXPECT_EQ(refused.refusals()[0].name, "checksum");
  EXPECT_EQ(refused.refusals()[0].count, 2u);
}

TEST(Ledger, CountsChecksums) {
  Ledger ledger;
  for (const auto state : {ChecksumState::ok, ChecksumState::ok, ChecksumState::absent}) {
    FrameReport r = report(ByteClass::decoded, "HDT", 20);
    r.checksum = state;
    ledger.count(r, Arrival{});
  }
  EXPECT_EQ(ledger.checksums(ChecksumState::ok), 2u);
  EXPECT_EQ(ledger.checksums(ChecksumState::absent), 1u);
  EXPECT_EQ(ledger.checksums(ChecksumState::bad), 0u);
}

}  // namespace
}  // namespace leadline
