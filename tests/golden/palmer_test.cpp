// R/V Palmer: four instruments with four clocks on one timeline
// (tests/data/nmea_openrvdas_nbp1406/SOURCE.md).

#include <gtest/gtest.h>

#include "sessions/export/summary.h"
#include "tests/support/files.h"
#include "tests/support/recording.h"

namespace leadline {
namespace {

constexpr SourceId kSeapath = 0, kGyro = 1, kSecondGps = 2;

test::Replayed palmer(const std::vector<std::string>& engines, const std::string& variant = "error-state") {
  const auto file = [](const char* name) {
    return test::data_path("nmea_openrvdas_nbp1406/NBP1406_" + std::string(name) + "-2014-08-01");
  };
  const DecoderSettings bare{.checksum_required = false};
  nav::Options options;
  options.fusion.variant = variant;
  return test::replay({{.name = "s330", .decoder = "nmea0183", .path = file("s330")},
                       {.name = "gyr1", .decoder = "nmea0183", .path = file("gyr1")},
                       {.name = "gp02", .decoder = "nmea0183", .path = file("gp02"), .settings = bare},
                       {.name = "adcp", .decoder = "nmea0183", .path = file("adcp"), .settings = bare}},
                      options, Body::ship, engines);
}

const test::Replayed& fused() {
  static const auto once = palmer({"fusion", "dead-reckoning"});
  return once;
}

/// Linear between the two samples around t; empty outside.
template <class Sample, class Value>
std::optional<Value> between(const std::vector<Sample>& samples, Time t,
                             Value (*value)(const Sample& a, const Sample& b, double f)) {
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i - 1].t <= t && t <= samples[i].t && samples[i].t > samples[i - 1].t)
      return value(samples[i - 1], samples[i],
                   seconds(t - samples[i - 1].t) / seconds(samples[i].t - samples[i - 1].t));
  return std::nullopt;
}

TEST(Palmer, SecondGpsLiesFortyMetresDeadAsternOfTheSeapath) {
  using Fix = test::Replayed::At<GnssFix>;
  std::vector<Fix> seapath, second;
  for (const auto& fix : fused().all<GnssFix>()) (fix.source == kSeapath ? seapath : second).push_back(fix);
  double north = 0, east = 0, squares = 0;
  int n = 0;
  for (const auto& fix : second) {
    ASSERT_EQ(fix.source, kSecondGps);
    const auto reference = between<Fix, Geodetic>(seapath, fix.t, [](const Fix& a, const Fix& b, double f) {
      const auto step = geo::difference(a.value.position, b.value.position);
      return geo::displaced(a.value.position, f * step.north_m, f * step.east_m);
    });
    if (!reference) continue;
    const auto off = geo::difference(*reference, fix.value.position);
    north += off.north_m, east += off.east_m;
    squares += off.north_m * off.north_m + off.east_m * off.east_m;
    ++n;
  }
  ASSERT_GT(n, 600);
  std::printf("gp02 minus s330: %+.1f m north, %+.1f m east, RMS %.1f m over %d fixes\n", north / n, east / n,
              std::sqrt(squares / n), n);
  EXPECT_NEAR(north / n, 31.0, 2.0);
  EXPECT_NEAR(east / n, 26.0, 2.0);
  EXPECT_NEAR(std::sqrt(squares / n), 41.0, 2.0);
}

TEST(Palmer, SecondGpsIsSaidAndNotFused) {
  for (const auto& verdict : fused().verdicts(0))
    if (verdict.source == kSecondGps) {
      EXPECT_FALSE(verdict.value.accepted.has_value());
    }
  std::vector<std::string> said;
  for (const auto& health : fused().all<Health>())
    if (health.source == kSecondGps) said.emplace_back(health.value.text.view());
  ASSERT_EQ(said.size(), 2u);
  for (const auto& text : said) EXPECT_NE(text.find("dead astern"), std::string::npos) << text;
  EXPECT_NE(said[0].find("gp02 is not used"), std::string::npos) << said[0];
  double north_m = 0.0, east_m = 0.0, rms_m = 0.0;
  ASSERT_EQ(std::sscanf(said[1].c_str(),
                        "gp02 against the position while both were there: %lf m north, %lf m east, RMS %lf",
                        &north_m, &east_m, &rms_m),
            3)
      << said[1];
  EXPECT_NEAR(north_m, 31.0, 2.0);
  EXPECT_NEAR(east_m, 26.0, 2.0);
  EXPECT_NEAR(rms_m, 41.0, 2.0);
}

TEST(Palmer, GyroAgreesWithTheSeapath) {
  using Sample = test::Replayed::At<Heading>;
  std::vector<Sample> seapath, gyro;
  for (const auto& heading : fused().all<Heading>()) {
    if (heading.source == kSeapath && (seapath.empty() || heading.t > seapath.back().t))
      seapath.push_back(heading);
    if (heading.source == kGyro) gyro.push_back(heading);
  }
  double sum = 0, squares = 0;
  int n = 0;
  for (const auto& sample : seapath) {
    const auto at = between<Sample, Angle>(gyro, sample.t, [](const Sample& a, const Sample& b, double f) {
      return a.value.heading + (b.value.heading - a.value.heading).wrapped_pi() * f;
    });
    if (!at) continue;
    const double off_deg = (*at - sample.value.heading).wrapped_pi().deg();
    sum += off_deg, squares += off_deg * off_deg;
    ++n;
  }
  ASSERT_GT(n, 600);
  const double mean = sum / n, sd = std::sqrt(squares / n - mean * mean);
  std::printf("gyro minus Seapath heading: mean %+.3f deg, sd %.3f deg over %d\n", mean, sd, n);
  EXPECT_NEAR(mean, 0.0, 0.05);
  EXPECT_NEAR(sd, 0.33, 0.05);
}

TEST(Palmer, ClockOffsetsAreThoseOfTheTelegramHeardSoonest) {
  sessions::Summary summary({"fusion"}, {}, "ship", {true, true, true, true});
  for (const auto& envelope : fused().envelopes)
    if (std::holds_alternative<ClockReading>(envelope.message)) summary.take(envelope);
  std::printf("clock offsets: s330 %.4f s, gp02 %.4f s\n", *summary.clock_offset_s(kSeapath),
              *summary.clock_offset_s(kSecondGps));
  EXPECT_NEAR(*summary.clock_offset_s(kSeapath), 0.115, 0.01);
  EXPECT_NEAR(*summary.clock_offset_s(kSecondGps), 0.300, 0.01);
  EXPECT_FALSE(summary.clock_offset_s(kGyro));
}

TEST(Palmer, OneFixASecondStaysInsideTheGateOfEveryVariant) {
  for (const char* variant : {"error-state", "windowed-ci", "plain-ci"}) {
    int accepted = 0, rejected = 0;
    for (const auto& verdict : palmer({"fusion"}, variant).verdicts(0))
      if (verdict.value.accepted) ++(*verdict.value.accepted ? accepted : rejected);
    EXPECT_EQ(accepted, 625) << variant;  // GGA, RMC: one position an epoch
    EXPECT_EQ(rejected, 0) << variant;
  }
}

TEST(Palmer, ReplayedTwiceGivesTheSameBits) {
  const auto again = palmer({"fusion", "dead-reckoning"});
  ASSERT_EQ(again.envelopes.size(), fused().envelopes.size());
  for (std::size_t i = 0; i < again.envelopes.size(); ++i) {
    const auto &a = again.envelopes[i], &b = fused().envelopes[i];
    ASSERT_TRUE(a.seq == b.seq && a.valid == b.valid && a.source == b.source && a.message == b.message) << i;
  }
}

TEST(Palmer, WithoutBottomTrackTheStateIsCAndSigmaGrowsOnceTheFixesEnd) {
  const auto track = fused().solutions(0);
  ASSERT_GT(track.size(), 1000u);
  double last_sd = 0.0;
  for (const auto& row : track) {
    const double sd = std::sqrt(row.value.var_north_m2);
    if (row.value.position_source == PositionSource::gnss && row.value.mode == Mode::C) {
      EXPECT_LT(sd, 3.0);
    }
    if (row.value.mode == Mode::E0) {
      EXPECT_GE(sd, last_sd);
      last_sd = sd;
    }
  }
  EXPECT_GT(last_sd, 1000.0);  // an unknown current for an hour and a half
}

}  // namespace
}  // namespace leadline
