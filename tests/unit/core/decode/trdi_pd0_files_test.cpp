// Real PD0 files: counts, clocks and tracks against the figures in their SOURCE.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "tests/unit/core/decode/trdi_pd0_samples.h"

namespace leadline::test {
namespace {

Decoded decode_file(const std::string& name) { return decode_pd0(read_bytes(data_path(name))); }

struct RealFile {
  const char* name;
  std::size_t ensembles, waves, refused;
  const char* reason;
};
class Pd0RealFile : public testing::TestWithParam<RealFile> {};

TEST_P(Pd0RealFile, CountsAreThoseOfItsSourceAndEveryByteIsAccountedFor) {
  const Bytes bytes = read_bytes(data_path(GetParam().name));
  const Decoded d = decode_pd0(bytes);
  const PieceCount count = account(d);
  EXPECT_EQ(count.bytes, bytes.size());
  EXPECT_EQ(count.ensembles, GetParam().ensembles);
  EXPECT_EQ(count.waves, GetParam().waves);
  EXPECT_EQ(count.skipped, 0u);
  EXPECT_EQ(count.refused, GetParam().refused);
  for (const auto& f : d.frames)
    if (f.byte_class == ByteClass::refused && !f.block) {
      EXPECT_EQ(f.reason, GetParam().reason);
    }
}

INSTANTIATE_TEST_SUITE_P(Files, Pd0RealFile,
                         testing::Values(RealFile{"dvl_pd0_adcp/RDI_withBT.000", 1721, 0, 1, "truncated"},
                                         RealFile{"dvl_pd0_adcp/RiverPro_test01.PD0", 273, 0, 0, ""},
                                         RealFile{"dvl_pd0_adcp/winriver01.PD0", 262, 0, 0, ""},
                                         RealFile{"dvl_pd0_adcp/winriver02.PD0", 75, 0, 0, ""},
                                         RealFile{"dvl_pd0_adcp/RDI_test01.000", 22, 0, 1, "truncated"},
                                         RealFile{"dvl_pd0_adcp/RDI_7f79.000", 60, 122, 1, "truncated"},
                                         RealFile{"dvl_pd0_adcp/sentinelv_b5.pd0", 50, 0, 1, "truncated"},
                                         RealFile{"dvl_pd0_remus600/adcp_auv_3.pd0", 3, 0, 0, ""},
                                         RealFile{"dvl_pd0_remus600/adcp_auv_51.pd0", 51, 0, 0, ""},
                                         RealFile{"dvl_pd0_remus600/glider/LA100204.PD0", 107, 0, 0, ""},
                                         RealFile{"dvl_pd0_remus600/glider/LA281913.PD0", 19, 0, 0, ""},
                                         RealFile{"dvl_pd0_remus600/glider/LB180210_3_corrupted.PD0", 2, 0, 1,
                                                  "checksum"},
                                         RealFile{"dvl_pd0_remus600/glider/LB180210_50.PD0", 50, 0, 0, ""},
                                         RealFile{"dvl_pd0_remus600/glider/ND072023.PD0", 54, 0, 0, ""},
                                         RealFile{"dvl_pd0_remus600/glider/NE051400.PD0", 193, 0, 0, ""}),
                         [](const auto& file) {
                           std::string name = file.param.name;
                           name = name.substr(name.rfind('/') + 1);
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

std::size_t valid_count(const std::vector<DvlVelocity>& velocities) {
  return static_cast<std::size_t>(
      std::count_if(velocities.begin(), velocities.end(), [](const DvlVelocity& v) { return v.valid; }));
}

TEST(Pd0Files, RdiWithBtIsInEarthAxesAndHas901ValidVelocities) {
  const auto velocities = decode_file("dvl_pd0_adcp/RDI_withBT.000").all<DvlVelocity>();
  EXPECT_EQ(velocities.size(), 1721u);
  EXPECT_EQ(valid_count(velocities), 901u);
  for (const auto& v : velocities) ASSERT_TRUE(v.frame == DvlFrame::earth && v.tilt_applied && v.applied);
}

struct BlockCount {
  std::size_t decoded = 0, unused = 0, refused = 0;
};
BlockCount count_blocks(const Decoded& d, std::string_view kind) {
  BlockCount count;
  for (const auto& f : d.frames) {
    if (!f.block || f.kind != kind) continue;
    count.decoded += f.byte_class == ByteClass::decoded;
    count.unused += f.byte_class == ByteClass::unused;
    count.refused += f.byte_class == ByteClass::refused;
  }
  return count;
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}
/// GNSS minus device, s: the median and the root mean square distance from it.
std::pair<double, double> clock_offset(const Decoded& d) {
  std::vector<double> offsets;
  for (const auto& c : d.all<ClockReading>())
    if (c.reference_ns) offsets.push_back(static_cast<double>(*c.reference_ns - c.device_ns) * 1e-9);
  const double middle = median(offsets);
  double squares = 0.0;
  for (const double o : offsets) squares += (o - middle) * (o - middle);
  return {middle, std::sqrt(squares / static_cast<double>(offsets.size()))};
}

TEST(Pd0Files, Winriver01IsShipFrameLevelledByTheDeviceWithGpsAndALocalClock) {
  const Decoded d = decode_file("dvl_pd0_adcp/winriver01.PD0");
  for (const auto& v : d.all<DvlVelocity>())
    ASSERT_TRUE(v.frame == DvlFrame::ship && v.tilt_applied && !v.applied);
  EXPECT_EQ(d.all<GnssFix>().size(), 34u);
  EXPECT_EQ(count_blocks(d, "NMEA GGA").decoded, 34u);
  EXPECT_EQ(count_blocks(d, "NMEA text").unused, 34u) << "each repeats a binary one";
  const auto [offset, scatter] = clock_offset(d);
  EXPECT_NEAR(offset, 14426.35, 0.01);
  EXPECT_LT(scatter, 0.02);
  RecordProperty("clock_offset_s", std::to_string(offset) + " +- " + std::to_string(scatter));
}

TEST(Pd0Files, Winriver02Has611GoodBlocksOf2111) {
  const Decoded d = decode_file("dvl_pd0_adcp/winriver02.PD0");
  const BlockCount binary = count_blocks(d, "NMEA GGA"), older = count_blocks(d, "NMEA text");
  EXPECT_EQ(binary.decoded + binary.unused, 611u);
  EXPECT_EQ(binary.refused, 1500u);
  EXPECT_EQ(older.decoded + older.unused, 50u);
  EXPECT_EQ(older.refused, 25u);
  for (const auto& f : d.frames)
    if (f.byte_class == ByteClass::refused) {
      ASSERT_EQ(f.reason, f.kind == "NMEA GGA" ? "nmea body" : "nmea text");
    }
}

TEST(Pd0Files, RiverProHasGpsOnItsOwnClock) {
  const Decoded d = decode_file("dvl_pd0_adcp/RiverPro_test01.PD0");
  EXPECT_EQ(count_blocks(d, "NMEA GGA").decoded, 922u);
  EXPECT_EQ(count_blocks(d, "NMEA VTG").decoded, 922u);
  EXPECT_EQ(count_blocks(d, "NMEA DBT").decoded, 184u);
  EXPECT_EQ(count_blocks(d, "NMEA text").unused, 718u) << "a second receiver without a fix";
  EXPECT_EQ(d.all<GnssFix>().size(), 922u);
  const auto [offset, scatter] = clock_offset(d);
  EXPECT_NEAR(offset, 1.79, 0.03);
  EXPECT_LT(scatter, 0.1);
  RecordProperty("clock_offset_s", std::to_string(offset) + " +- " + std::to_string(scatter));
}

/// Turn (deg, clockwise) and scale that best lay the dead-reckoned track of a file over its GNSS track.
std::pair<double, double> track_fit(const Decoded& d) {
  using Complex = std::complex<double>;  // north + i east: a factor turns clockwise
  std::vector<std::pair<Time, Complex>> track;
  std::optional<Angle> heading;
  Complex here, velocity;
  for (const auto& f : d.facts) {
    if (const auto* h = std::get_if<Heading>(&f.message)) heading = h->heading;
    const auto* v = std::get_if<DvlVelocity>(&f.message);
    if (!v || !v->valid || v->reference != DvlReference::bottom || !heading) continue;
    const Complex now = Complex(v->x_mps, v->y_mps) * std::polar(1.0, heading->rad());
    if (!track.empty()) here += 0.5 * (velocity + now) * seconds(*f.device_time - track.back().first);
    velocity = now;
    track.emplace_back(*f.device_time, here);
  }
  std::vector<Complex> reckoned, fixed;
  const Geodetic origin = d.all<GnssFix>().front().position;
  const double radius_m = 6'371'000.0;
  for (const auto& f : d.facts) {
    const auto* fix = std::get_if<GnssFix>(&f.message);
    if (!fix || *f.device_time < track.front().first || *f.device_time > track.back().first) continue;
    const auto after = std::upper_bound(track.begin() + 1, track.end() - 1, *f.device_time,
                                        [](Time t, const auto& point) { return t < point.first; });
    const double share =
        seconds(*f.device_time - (after - 1)->first) / seconds(after->first - (after - 1)->first);
    reckoned.push_back((after - 1)->second + share * (after->second - (after - 1)->second));
    fixed.emplace_back((fix->position.lat - origin.lat).rad() * radius_m,
                       (fix->position.lon - origin.lon).rad() * radius_m * cos(origin.lat));
  }
  Complex mean_r, mean_f, cross;
  double power = 0.0;
  const double n = static_cast<double>(fixed.size());
  for (std::size_t i = 0; i < fixed.size(); ++i) mean_r += reckoned[i] / n, mean_f += fixed[i] / n;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    cross += (fixed[i] - mean_f) * std::conj(reckoned[i] - mean_r);
    power += std::norm(reckoned[i] - mean_r);
  }
  return {std::arg(cross / power) * kDegPerRad, std::abs(cross / power)};
}

TEST(Pd0Files, BeamVelocitiesOfRiverProFollowItsGps) {
  const auto [turn_deg, scale] = track_fit(decode_file("dvl_pd0_adcp/RiverPro_test01.PD0"));
  EXPECT_NEAR(turn_deg, 4.4, 1.0);
  EXPECT_NEAR(scale, 0.999, 0.01);
  RecordProperty("fit", std::to_string(turn_deg) + " deg, " + std::to_string(scale));
}

TEST(Pd0Files, ShipVelocitiesOfWinriver01FollowItsGpsButForTheKnownTurn) {
  const auto [turn_deg, scale] = track_fit(decode_file("dvl_pd0_adcp/winriver01.PD0"));
  EXPECT_NEAR(turn_deg, -23.3, 1.0);
  EXPECT_NEAR(scale, 1.035, 0.01);
  RecordProperty("fit", std::to_string(turn_deg) + " deg, " + std::to_string(scale));
}

}  // namespace
}  // namespace leadline::test
