#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "core/decode/nmea0183.h"
#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"

namespace leadline::decode {
namespace {

using test::Decoded;

/// A file of stamped lines of RVIB Nathaniel B. Palmer; `bytes` counts what the instrument sent.
struct Log {
  Decoded all;
  std::size_t bytes = 0, lines = 0;
};

Log read_log(const std::string& instrument, bool checksum_required) {
  DecoderSettings settings;
  settings.checksum_required = checksum_required;
  const auto decoder = make_nmea0183(settings);
  Log log;
  std::istringstream lines(
      test::read_text(test::data_path("nmea_openrvdas_nbp1406/NBP1406_" + instrument + "-2014-08-01")));
  for (std::string line; std::getline(lines, line); ++log.lines) {
    const std::size_t blank = line.find(' ');
    const auto stamp = parse_iso8601(line.substr(0, blank));
    EXPECT_TRUE(stamp) << line;
    const std::string payload = line.substr(blank + 1) + "\n";
    decoder->feed(test::as_bytes(payload), arrival_at(*stamp), log.all);
    log.bytes += payload.size();
  }
  decoder->finish(log.all);
  return log;
}

TEST(Nmea0183Palmer, EveryByteIsAccountedForInEveryFile) {
  for (const char* instrument : {"adcp", "gp02", "gyr1", "knud", "mbdp", "s330", "svp1"}) {
    const Log log = read_log(instrument, false);
    EXPECT_EQ(log.lines, 5000u) << instrument;
    EXPECT_EQ(log.all.ledger.bytes_total(), log.bytes) << instrument;
    EXPECT_EQ(log.all.ledger.frames(), 5000u) << instrument;
    EXPECT_EQ(log.all.ledger.frames(ByteClass::refused), 0u) << instrument;
  }
}

TEST(Nmea0183Palmer, ChecksumsHoldWhereTheyAre) {
  for (const char* instrument : {"gyr1", "mbdp", "s330"}) {
    const Log log = read_log(instrument, true);
    EXPECT_EQ(log.all.ledger.checksums(ChecksumState::ok), 5000u) << instrument;
    EXPECT_EQ(log.all.ledger.bytes(ByteClass::decoded), log.bytes) << instrument;
  }
}

TEST(Nmea0183Palmer, ChecksumsAreDemandedUnlessConfiguredOtherwise) {
  for (const char* instrument : {"gp02", "adcp"}) {
    const Log refused = read_log(instrument, true);
    EXPECT_EQ(refused.all.ledger.bytes(ByteClass::refused), refused.bytes) << instrument;
    EXPECT_TRUE(refused.all.facts.empty()) << instrument;
    const Log taken = read_log(instrument, false);
    EXPECT_EQ(taken.all.ledger.bytes(ByteClass::decoded), taken.bytes) << instrument;
    EXPECT_EQ(taken.all.ledger.checksums(ChecksumState::absent), 5000u) << instrument;
  }
}

TEST(Nmea0183Palmer, TheSeapathGivesOneFixAnEpochAndAllItsKinds) {
  const Log log = read_log("s330", true);
  EXPECT_EQ(log.all.all<GnssFix>().size(), 625u);
  EXPECT_EQ(log.all.all<Course>().size(), 625u);
  EXPECT_EQ(log.all.all<Attitude>().size(), 625u);
  EXPECT_EQ(log.all.all<Heading>().size(), 1250u) << "HDT and PSXN,23";
  EXPECT_EQ(log.all.all<ClockReading>().size(), 1875u) << "ZDA, GGA, RMC";
  for (const auto& kind : log.all.ledger.kinds()) EXPECT_EQ(kind.count, 625u) << kind.name;
  EXPECT_EQ(log.all.ledger.kinds().size(), 8u);
}

TEST(Nmea0183Palmer, TheSeapathsHeaveIsGivenUpwards) {
  // The antenna's height rises with the ship: height and heave of one second go together.
  const Log log = read_log("s330", true);
  const auto fixes = log.all.all<GnssFix>();
  const auto attitudes = log.all.all<Attitude>();
  ASSERT_EQ(fixes.size(), attitudes.size());
  double n = 0, sx = 0, sy = 0, sxy = 0, sxx = 0, syy = 0;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const double x = fixes[i].height->m, y = *attitudes[i].heave_up_m;
    n += 1, sx += x, sy += y, sxy += x * y, sxx += x * x, syy += y * y;
  }
  const double r = (n * sxy - sx * sy) / std::sqrt((n * sxx - sx * sx) * (n * syy - sy * sy));
  EXPECT_GT(r, 0.5);
}

TEST(Nmea0183Palmer, GllWithoutTimeAndWaterVelocityAreFacts) {
  const Log gp02 = read_log("gp02", false);
  EXPECT_EQ(gp02.all.all<GnssFix>().size(), 1667u);
  EXPECT_EQ(gp02.all.first<GnssFix>()->device_time, std::nullopt);
  EXPECT_EQ(gp02.all.all<ClockReading>().size(), 1667u);
  const Log adcp = read_log("adcp", false);
  EXPECT_EQ(adcp.all.all<DvlVelocity>().size(), 5000u);
  const Log mbdp = read_log("mbdp", true);
  const auto depths = mbdp.all.all<BottomDepth>();
  ASSERT_EQ(depths.size(), 5000u);
  EXPECT_NEAR(depths[0].depth_m, 4674.70 + 8.62, 1e-9);
  EXPECT_EQ(depths[0].below, BottomDepth::Below::surface);
}

TEST(Nmea0183Palmer, TextOfOtherInstrumentsIsUnknownNotRefused) {
  for (const char* instrument : {"knud", "svp1"}) {
    const Log log = read_log(instrument, true);
    EXPECT_EQ(log.all.ledger.bytes(ByteClass::unknown), log.bytes) << instrument;
    ASSERT_EQ(log.all.ledger.kinds().size(), 1u);
    EXPECT_EQ(log.all.ledger.kinds()[0].name, "text");
  }
}

}  // namespace
}  // namespace leadline::decode
