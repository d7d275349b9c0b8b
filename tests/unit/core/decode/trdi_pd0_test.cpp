#include "core/decode/trdi_pd0.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/core/decode/trdi_pd0_samples.h"

namespace leadline::test {
namespace {

constexpr double kTiny = 1e-9;

DvlVelocity bottom_velocity(const Bytes& ensemble, const DecoderSettings& settings = {}) {
  const Decoded d = decode_pd0(sealed(ensemble), 0, settings);
  const auto all = d.all<DvlVelocity>();
  EXPECT_EQ(all.size(), 1u);
  return all.empty() ? DvlVelocity{} : all[0];
}

// --- the sample ensemble ---

TEST(Pd0, BottomTrackVelocityIsMinusTheDevices) {
  const DvlVelocity v = bottom_velocity(pd0_sample());
  EXPECT_TRUE(v.valid);
  EXPECT_EQ(v.reference, DvlReference::bottom);
  EXPECT_NEAR(v.x_mps, 0.850, kTiny);
  EXPECT_NEAR(v.y_mps, 0.120, kTiny);
  EXPECT_NEAR(v.z_mps, 0.030, kTiny) << "down: the bottom comes nearer";
  EXPECT_NEAR(*v.error_mps, 0.004, kTiny);
  EXPECT_EQ(v.frame, DvlFrame::ship);
  EXPECT_TRUE(v.tilt_applied);
  EXPECT_FALSE(v.applied);
}

TEST(Pd0, TheSampleGivesItsFactsInOrder) {
  const Decoded d = decode_pd0(pd0_sample());
  const Time time = *parse_iso8601("2026-11-22T12:35:19.500Z");
  std::vector<std::size_t> kinds;
  for (const auto& f : d.facts) {
    kinds.push_back(f.message.index());
    EXPECT_EQ(f.device_time, time);
  }
  const Message order[] = {ClockReading{},  Heading{},  Attitude{},   SoundSpeed{},
                           DepthMeasured{}, Pressure{}, BeamRanges{}, AltitudeAboveBottom{},
                           DvlVelocity{}};
  ASSERT_EQ(kinds.size(), std::size(order));
  for (std::size_t i = 0; i < kinds.size(); ++i) EXPECT_EQ(kinds[i], order[i].index()) << i;
  EXPECT_EQ(d.all<ClockReading>()[0].telegram.view(), "ensemble");
  EXPECT_EQ(d.all<ClockReading>()[0].device_ns, time.ns);
  EXPECT_FALSE(d.all<ClockReading>()[0].reference_ns);
  EXPECT_NEAR(d.all<Heading>()[0].heading.deg(), 96.03, kTiny);
  EXPECT_EQ(d.all<Heading>()[0].reference, HeadingReference::true_north);
  EXPECT_NEAR(d.all<Attitude>()[0].pitch.deg(), -2.30, kTiny);
  EXPECT_NEAR(d.all<Attitude>()[0].roll.deg(), 1.40, kTiny);
  EXPECT_EQ(d.all<SoundSpeed>()[0].speed_mps, 1490.0);
  EXPECT_NEAR(d.all<DepthMeasured>()[0].depth.m, 118.4, kTiny);
  EXPECT_NEAR(d.all<Pressure>()[0].gauge_pa, 1'184'000.0, kTiny);
  const auto ranges = d.all<BeamRanges>()[0].range_m;
  const double expected[] = {11.05, 11.10, 10.95, 11.00};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(ranges[i], expected[i], kTiny);
  EXPECT_NEAR(d.all<BeamRanges>()[0].beam_angle.deg(), 20.0, kTiny);
  EXPECT_NEAR(d.all<AltitudeAboveBottom>()[0].above_bottom_m, 11.025, kTiny);
}

TEST(Pd0, RawFieldsOfTheSample) {
  const Bytes sample = pd0_sample();
  const auto e = decode::read_pd0_ensemble({sample.data(), sample.size() - 2});
  ASSERT_TRUE(e);
  EXPECT_EQ(e->variable.ensemble_number, 70001u);
  EXPECT_EQ(e->fixed.coordinate_transform, 0x17);
  EXPECT_EQ(e->variable.temperature_cdegc, 825);
  EXPECT_EQ(*e->variable.pressure_dapa, 118400);
  EXPECT_EQ(e->bottom->velocity_mmps, (std::array<std::int16_t, 4>{-120, -850, 30, 4}));
}

TEST(Pd0, APingWithoutLockIsAFactToo) {
  const Decoded d = decode_pd0(pd0_sample("pd0_ship_bt_invalid.bin"));
  ASSERT_EQ(d.all<DvlVelocity>().size(), 1u);
  EXPECT_FALSE(d.all<DvlVelocity>()[0].valid);
  EXPECT_FALSE(d.all<DvlVelocity>()[0].error_mps);
  EXPECT_EQ(d.all<AltitudeAboveBottom>().size(), 0u);
  EXPECT_EQ(d.all<BeamRanges>()[0].range_m, (std::array<double, 4>{}));
}

TEST(Pd0, RangesHaveAHighByte) {
  const Decoded d = decode_pd0(pd0_sample("pd0_range_msb.bin"));
  const auto ranges = d.all<BeamRanges>();
  ASSERT_EQ(ranges.size(), 1u);
  for (const double r : ranges[0].range_m) EXPECT_NEAR(r, 700.0, kTiny);
  EXPECT_NEAR(d.all<AltitudeAboveBottom>()[0].above_bottom_m, 700.0, kTiny);
}

TEST(Pd0, PressureIsSigned) {
  Bytes b = pd0_sample();
  put_u16(b, kVariable + 48, -244), put_u16(b, kVariable + 50, -1);
  EXPECT_NEAR(decode_pd0(sealed(b)).all<Pressure>()[0].gauge_pa, -2440.0, kTiny);
  put_u16(b, kVariable + 48, 0), put_u16(b, kVariable + 50, 0);
  EXPECT_EQ(decode_pd0(sealed(b)).all<Pressure>().size(), 0u);
}

TEST(Pd0, AltitudeTakesOnlyBeamsWhoseOppositeSeesTheBottomToo) {
  Bytes b = pd0_sample();
  put_u16(b, kBottom + 16 + 4, 0);  // beam 3
  EXPECT_NEAR(decode_pd0(sealed(b)).all<AltitudeAboveBottom>()[0].above_bottom_m, 11.075, kTiny);
  put_u16(b, kBottom + 16, 0);  // beam 1
  EXPECT_EQ(decode_pd0(sealed(b)).all<AltitudeAboveBottom>().size(), 0u);
}

TEST(Pd0, DepthNeedsASensorThatIsBothChosenAndThere) {
  for (const std::size_t byte : {kSensorSource, kSensorSource + 1}) {
    Bytes b = pd0_sample();
    b[byte] = static_cast<std::uint8_t>(b[byte] & ~0x20u);
    EXPECT_EQ(decode_pd0(sealed(b)).all<DepthMeasured>().size(), 0u);
  }
}

TEST(Pd0, WhatTheDeviceDoesNotKnowIsNoFact) {
  Bytes b = pd0_sample();
  put_u16(b, kVariable + 18, 36000);   // heading
  put_u16(b, kVariable + 20, -32768);  // pitch
  put_u16(b, kVariable + 14, 1399);    // sound speed
  const Decoded d = decode_pd0(sealed(b));
  EXPECT_EQ(d.all<Heading>().size(), 0u);
  EXPECT_EQ(d.all<Attitude>().size(), 0u);
  EXPECT_EQ(d.all<SoundSpeed>().size(), 0u);
}

TEST(Pd0, OneMissingComponentMakesAVelocityInvalidAMissingErrorDoesNot) {
  for (std::size_t i = 0; i < 4; ++i) {
    Bytes b = pd0_sample();
    put_u16(b, kVelocity + 2 * i, -32768);
    EXPECT_EQ(bottom_velocity(b).valid, i == 3) << i;
  }
}

// --- clocks ---

std::optional<Time> time_with(int century, std::array<int, 7> y2k, std::array<int, 7> old) {
  Bytes b = pd0_sample();
  b[kVariable + 57] = static_cast<std::uint8_t>(century);
  for (std::size_t i = 0; i < 7; ++i) b[kVariable + 58 + i] = static_cast<std::uint8_t>(y2k[i]);
  for (std::size_t i = 0; i < 7; ++i) b[kVariable + 4 + i] = static_cast<std::uint8_t>(old[i]);
  const Decoded d = decode_pd0(sealed(b));
  EXPECT_EQ(d.all<ClockReading>().size(), d.facts.front().device_time ? 1u : 0u);
  return d.facts.front().device_time;
}

TEST(Pd0, TheFourDigitClockIsTakenOnlyWhenItIsOne) {
  const std::array<int, 7> none{}, y2k = {8, 6, 25, 10, 0, 0, 50}, old = {14, 12, 19, 17, 17, 55, 94};
  EXPECT_EQ(time_with(20, y2k, old), parse_iso8601("2008-06-25T10:00:00.50Z"));
  EXPECT_EQ(time_with(19, {99, 12, 31, 23, 59, 59, 99}, old), parse_iso8601("1999-12-31T23:59:59.99Z"));
  EXPECT_EQ(time_with(77, y2k, old), parse_iso8601("2014-12-19T17:17:55.94Z"));
  EXPECT_EQ(time_with(20, {8, 13, 25, 10, 0, 0, 50}, old), parse_iso8601("2014-12-19T17:17:55.94Z"));
  EXPECT_EQ(time_with(20, {8, 2, 30, 10, 0, 0, 50}, old), parse_iso8601("2014-12-19T17:17:55.94Z"));
  EXPECT_EQ(time_with(0, none, {93, 12, 19, 17, 17, 55, 94}), parse_iso8601("1993-12-19T17:17:55.94Z"));
  EXPECT_EQ(time_with(0, none, none), std::nullopt);
  EXPECT_EQ(time_with(0, none, {14, 12, 19, 17, 17, 55, 100}), std::nullopt);
  EXPECT_EQ(time_with(0, none, {14, 12, 19, 17, 17, 60, 0}), std::nullopt);
}

// --- frames ---

TEST(Pd0, CoordinateByteSaysTheFrameAndWhetherTiltsWereUsed) {
  const struct {
    int byte;
    DvlFrame frame;
    bool tilt_applied, applied;
  } cases[] = {{0x08, DvlFrame::instrument, false, false},
               {0x0C, DvlFrame::instrument, false, false},
               {0x10, DvlFrame::ship, false, false},
               {0x17, DvlFrame::ship, true, false},
               {0x1F, DvlFrame::earth, true, true}};
  for (const auto& c : cases) {
    Bytes b = pd0_sample();
    b[kCoordinates] = static_cast<std::uint8_t>(c.byte);
    const DvlVelocity v = bottom_velocity(b);
    EXPECT_EQ(v.frame, c.frame) << c.byte;
    EXPECT_EQ(v.tilt_applied, c.tilt_applied) << c.byte;
    EXPECT_EQ(v.applied.has_value(), c.applied) << c.byte;
    EXPECT_NEAR(v.x_mps, 0.850, kTiny);  // of all but beam: component 2 is forward or north
  }
}

TEST(Pd0, AnEarthVelocityCarriesTheAttitudeTheDeviceUsed) {
  Bytes b = pd0_sample();
  b[kCoordinates] = 0x1F;
  DecoderSettings magnetic;
  magnetic.heading_magnetic = true;
  const DvlVelocity v = bottom_velocity(b, magnetic);
  ASSERT_TRUE(v.applied);
  EXPECT_NEAR(v.applied->heading.deg(), 96.03, kTiny);
  EXPECT_NEAR(v.applied->pitch.deg(), -2.30, kTiny);
  EXPECT_NEAR(v.applied->roll.deg(), 1.40, kTiny);
  EXPECT_EQ(v.applied->reference, HeadingReference::magnetic_north);
  EXPECT_EQ(decode_pd0(b, 0, magnetic).frames[0].reason, "checksum") << "the edit was not sealed";
  EXPECT_EQ(decode_pd0(sealed(b), 0, magnetic).all<Heading>()[0].reference, HeadingReference::magnetic_north);
}

TEST(Pd0, HeadOrientationMattersToInstrumentAxesOnly) {
  for (const int coordinates : {0x08, 0x17, 0x1F}) {
    Bytes b = pd0_sample();
    b[kCoordinates] = static_cast<std::uint8_t>(coordinates);
    b[kSysConfig] = static_cast<std::uint8_t>(b[kSysConfig] & 0x7F);
    const DvlVelocity down = bottom_velocity(b);
    b[kSysConfig] = static_cast<std::uint8_t>(b[kSysConfig] | 0x80);
    const DvlVelocity up = bottom_velocity(b);
    const double turned = coordinates == 0x08 ? -1.0 : 1.0;
    EXPECT_NEAR(down.y_mps, 0.120, kTiny);
    EXPECT_NEAR(up.x_mps, down.x_mps, kTiny);
    EXPECT_NEAR(up.y_mps, turned * down.y_mps, kTiny) << coordinates;
    EXPECT_NEAR(up.z_mps, turned * down.z_mps, kTiny) << coordinates;
  }
}

Bytes beam_ensemble(std::array<int, 4> beams_mmps, int coordinates = 0x00) {
  Bytes b = pd0_sample();
  b[kCoordinates] = static_cast<std::uint8_t>(coordinates);
  b[kSysConfig] = 0x4B;  // convex, down-facing
  for (std::size_t i = 0; i < 4; ++i) put_u16(b, kVelocity + 2 * i, beams_mmps[i]);
  return b;
}

TEST(Pd0, BeamVelocitiesBecomeInstrumentAxes) {
  const double s = std::sin(20 * kRadPerDeg), c = std::cos(20 * kRadPerDeg);
  const DvlVelocity forward = bottom_velocity(beam_ensemble({0, 0, 342, -342}));
  EXPECT_EQ(forward.frame, DvlFrame::instrument);
  EXPECT_FALSE(forward.tilt_applied);
  EXPECT_NEAR(forward.x_mps, 0.342 / s, kTiny);
  EXPECT_NEAR(forward.y_mps, 0.0, kTiny);
  const DvlVelocity starboard = bottom_velocity(beam_ensemble({-342, 342, 0, 0}));
  EXPECT_NEAR(starboard.y_mps, 0.342 / s, kTiny);
  const DvlVelocity down = bottom_velocity(beam_ensemble({100, 100, 100, 100}));
  EXPECT_NEAR(down.z_mps, 0.1 / c, kTiny);
  EXPECT_NEAR(*down.error_mps, 0.0, kTiny);
}

TEST(Pd0, ThreeBeamsServeOnlyWhereTheDeviceAllowsThem) {
  EXPECT_FALSE(bottom_velocity(beam_ensemble({-32768, 100, 300, -100}, 0x00)).valid);
  const DvlVelocity three = bottom_velocity(beam_ensemble({-32768, 100, 300, -100}, 0x02));
  const DvlVelocity four = bottom_velocity(beam_ensemble({100, 100, 300, -100}, 0x02));
  EXPECT_TRUE(three.valid);
  EXPECT_FALSE(three.error_mps);
  EXPECT_TRUE(four.error_mps);
  EXPECT_NEAR(three.x_mps, four.x_mps, kTiny);
  EXPECT_NEAR(three.y_mps, four.y_mps, kTiny);
  EXPECT_NEAR(three.z_mps, four.z_mps, kTiny);
  EXPECT_FALSE(bottom_velocity(beam_ensemble({-32768, -32768, 300, -100}, 0x02)).valid);
}

TEST(Pd0, TheBeamAngleIsItsOwnByteElseTheConfigurations) {
  Bytes b = pd0_sample();
  b[kBeamAngle] = 25;
  EXPECT_NEAR(decode_pd0(sealed(b)).all<BeamRanges>()[0].beam_angle.deg(), 25.0, kTiny);
  b[kBeamAngle] = 0;
  b[kSysConfig + 1] = 0x42;
  EXPECT_NEAR(decode_pd0(sealed(b)).all<BeamRanges>()[0].beam_angle.deg(), 30.0, kTiny);
}

TEST(Pd0, TheReferenceLayerIsAVelocityThroughTheWater) {
  Bytes b = pd0_sample();
  const int layer[] = {40, -310, 5, -32768};
  for (std::size_t i = 0; i < 4; ++i) put_u16(b, kLayerVelocity + 2 * i, layer[i]);
  const auto both = decode_pd0(sealed(b)).all<DvlVelocity>();
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1].reference, DvlReference::water);
  EXPECT_NEAR(both[1].x_mps, 0.310, kTiny);
  EXPECT_NEAR(both[1].y_mps, -0.040, kTiny);
  EXPECT_NEAR(both[1].z_mps, 0.005, kTiny);
  EXPECT_FALSE(both[1].error_mps);
  put_u16(b, kLayerFar, 0);
  EXPECT_EQ(decode_pd0(sealed(b)).all<DvlVelocity>().size(), 1u) << "no layer: its zeros say nothing";
}

Bytes high_resolution(std::array<int, 4> cmmps) {
  Bytes type = {0x03, 0x58};
  for (const int v : cmmps) append_u16(type, v & 0xFFFF), append_u16(type, v >> 16);
  return type;
}

TEST(Pd0, HighResolutionRefinesWhatItAgreesWith) {
  auto types = types_of(pd0_sample());
  types.push_back(high_resolution({-12037, -84966, 2999, 390}));
  const DvlVelocity fine = bottom_velocity(compose(types));
  EXPECT_NEAR(fine.x_mps, 0.84966, kTiny);
  EXPECT_NEAR(fine.y_mps, 0.12037, kTiny);
  EXPECT_NEAR(fine.z_mps, 0.02999, kTiny);
  types.back() = high_resolution({-3'276'800, 84966, 0, 390});
  EXPECT_NEAR(bottom_velocity(compose(types)).x_mps, 0.850, kTiny) << "it contradicts the bottom track";
}

}  // namespace
}  // namespace leadline::test
