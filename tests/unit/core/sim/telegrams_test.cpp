// Every form a sensor can speak, through the decoder that reads it.

#include <gtest/gtest.h>

#include "core/sim/telegrams/sentence.h"
#include "tests/unit/core/sim/round_trip.h"
#include "tests/unit/core/sim/simulated.h"

namespace leadline::sim {
namespace {

/// A minute of rough water with one sensor.
Scenario minute(SensorSetup sensor) {
  Scenario scenario = shipped("mine-disposal");
  scenario.options.duration_s = 60.0;
  scenario.options.step_s = 0.05;
  scenario.vehicle->body.depth_m = sensor.options.kind == "gnss" ? 0.2 : 20.0;
  if (sensor.options.kind == "gnss") scenario.vehicle->legs.clear(), scenario.vehicle->body.heave_m = 0.05;
  sensor.options.name = "it";
  if (sensor.options.kind == "usbl") sensor.options.body = "ship";
  scenario.sensors = {sensor};
  return scenario;
}

RoundTrip heard(const SensorSetup& sensor) {
  const Scenario scenario = minute(sensor);
  RoundTrip round_trip(scenario);
  Simulation(scenario, 5, nullptr).run(round_trip);
  EXPECT_EQ(round_trip.refused, 0);
  return round_trip;
}

SensorSetup sensor_of(const std::string& kind, ErrorModel errors, const std::string& format = "",
                      std::vector<std::string> sentences = {}) {
  SensorSetup sensor;
  sensor.options.kind = kind, sensor.options.format = format, sensor.options.sentences = std::move(sentences);
  sensor.options.rate_hz = 7.0, sensor.options.first_s = 0.0123456, sensor.options.latency_s = 0.03;
  sensor.errors = std::move(errors);
  EXPECT_TRUE(check_sensor(sensor).empty() || kind == "usbl");
  return sensor;
}

TEST(Telegrams, GnssSentencesSayWhatWasMeasured) {
  const GnssOptions errors{.drms_m = 3, .height_noise_m = 2, .speed_noise_mps = 0.3, .position_decimals = 5};
  for (const std::string sentence : {"GGA", "GNS", "RMC", "GLL"}) {
    const auto trip = heard(sensor_of("gnss", errors, "", {sentence}));
    EXPECT_GT(trip.worst.at("it position, m").count, 400) << sentence;
    EXPECT_GT(trip.worst.at("it position, m").error, 0.005) << "the resolution is felt";
  }
  EXPECT_GT(heard(sensor_of("gnss", errors, "", {"VTG"})).worst.at("it speed, m/s").count, 400);
  EXPECT_GT(heard(sensor_of("gnss", errors, "", {"ZDA"})).worst.at("it clock").count, 400);
  EXPECT_GT(heard(sensor_of("gnss", errors, "", {"GST", "GGA"})).worst.at("it sigma, m").count, 400);
}

TEST(Telegrams, DatagramsOfIec61162450SayWhatWasMeasured) {
  const GnssOptions errors{.drms_m = 3, .height_noise_m = 2, .speed_noise_mps = 0.3, .position_decimals = 5};
  const auto gnss = heard(sensor_of("gnss", errors, "iec61162-450"));
  EXPECT_EQ(gnss.worst.at("it position, m").count, 420) << "GGA and RMC are one group, one fix an epoch";
  EXPECT_GT(gnss.worst.at("it position, m").error, 0.005) << "the resolution is felt";
  EXPECT_EQ(gnss.worst.at("it speed, m/s").count, 420);
  EXPECT_EQ(gnss.frames, 420) << "a datagram a measurement";
  const auto ahrs = heard(sensor_of("ahrs", AhrsOptions{}, "iec61162-450", {"HDT", "ROT"}));
  EXPECT_EQ(ahrs.worst.at("it heading, deg").count, 420);
}

TEST(Telegrams, AGnssWithoutAFixSaysSo) {
  GnssOptions errors;
  errors.deepest_m = -50.0;
  for (const std::string sentence : {"GGA", "GNS", "RMC", "GLL", "VTG"}) {
    const auto trip = heard(sensor_of("gnss", errors, "", {sentence}));
    EXPECT_EQ(trip.frames, 420) << sentence;
    EXPECT_EQ(trip.worst.count("it position, m"), 0u) << sentence;
  }
}

TEST(Telegrams, UsblSentencesSayWhatWasMeasured) {
  UsblOptions errors{
      .transponder = "7", .drms_m = 3, .depth_noise_m = 1, .outlier_share = 0.1, .sigma_told = true};
  for (const std::string sentence : {"PSIMSSB-H", "PSIMSSB-N", "PSIMSSB-E"})
    EXPECT_GT(heard(sensor_of("usbl", errors, "", {sentence})).worst.at("it offset, m").count, 400)
        << sentence;
  EXPECT_GT(heard(sensor_of("usbl", errors, "", {"PSIMSSB-R"})).worst.at("it position, m").count, 400);
  EXPECT_GT(heard(sensor_of("usbl", errors, "", {"PSIMSSB-U"})).worst.at("it easting, m").count, 400);
  errors.sigma_told = false;
  EXPECT_GT(heard(sensor_of("usbl", errors, "", {"PTSAG"})).worst.at("it position, m").count, 400);
  EXPECT_GT(heard(sensor_of("usbl", errors, "", {"PTSAX"})).worst.at("it offset, m").count, 400);
}

TEST(Telegrams, Pd0SaysWhatWasMeasuredInAllItsCoordinates) {
  DvlOptions errors{.noise_mps = 0.02,
                    .beam_loss_share = 0.1,
                    .range_noise_percent = 1,
                    .water_track = true,
                    .water_noise_mps = 0.02,
                    .tilt_noise_deg = 0.3,
                    .depth_told = true};
  for (const std::string coordinates : {"beam", "instrument", "ship", "earth"})
    for (const bool fine : {false, true}) {
      errors.coordinates = coordinates, errors.high_resolution = fine;
      SensorSetup sensor = sensor_of("dvl", errors);
      sensor.mount = {.pitch_deg = 2.0, .yaw_deg = 45.0};
      const auto trip = heard(sensor);
      const auto& bottom = trip.worst.at("it bottom velocity, m/s");
      EXPECT_GT(bottom.count, 350) << coordinates;
      EXPECT_LT(bottom.count, 420) << coordinates << ": some lock is lost with two beams";
      EXPECT_GT(bottom.error, 0.5 * bottom.resolution) << coordinates;
      EXPECT_EQ(trip.worst.at("it water velocity, m/s").count, 420) << coordinates;
    }
}

TEST(Telegrams, Pd4Pd5AndPd6SayWhatWasMeasuredInAllTheirCoordinates) {
  DvlOptions errors{.noise_mps = 0.02,
                    .beam_loss_share = 0.1,
                    .range_noise_percent = 1,
                    .water_track = true,
                    .water_noise_mps = 0.02,
                    .tilt_noise_deg = 0.3};
  for (const std::string format : {"trdi-pd4", "trdi-pd6"})
    for (const std::string coordinates : {"instrument", "ship", "earth"})
      for (const bool told : {false, true}) {
        errors.coordinates = coordinates, errors.attitude_told = errors.depth_told = told;
        SensorSetup sensor = sensor_of("dvl", errors, format);
        sensor.mount = {.pitch_deg = 2.0, .yaw_deg = 45.0};
        const auto trip = heard(sensor);
        const std::string which = format + " " + coordinates;
        const auto& bottom = trip.worst.at("it bottom velocity, m/s");
        EXPECT_GT(bottom.count, 350) << which;
        EXPECT_LT(bottom.count, 420) << which << ": some lock is lost with two beams";
        EXPECT_GT(bottom.error, 0.5 * bottom.resolution) << which;
        EXPECT_EQ(trip.worst.at("it water velocity, m/s").count, 420) << which;
        EXPECT_GT(trip.worst.at("it altitude, m").count, 350) << which;
        EXPECT_EQ(trip.worst.count("it heading, deg"), told ? 1u : 0u) << which;
        EXPECT_EQ(trip.worst.count("it depth, m"), told ? 1u : 0u) << which;
        EXPECT_EQ(trip.worst.at("it clock").count, 420) << which;
      }
}

TEST(Telegrams, Pd4AndPd6CannotSayBeamVelocities) {
  for (const std::string format : {"trdi-pd4", "trdi-pd6"}) {
    SensorSetup sensor = sensor_of("dvl", DvlOptions{}, format);
    sensor.errors = DvlOptions{.coordinates = "beam"};
    EXPECT_EQ(check_sensor(sensor).size(), 1u) << format;
  }
}

TEST(Telegrams, TextDvlsSayWhatWasMeasured) {
  DvlOptions errors{.noise_mps = 0.02,
                    .beam_loss_share = 0.1,
                    .range_noise_percent = 1,
                    .water_track = true,
                    .water_noise_mps = 0.02,
                    .tilt_noise_deg = 0.3};
  for (const std::string format : {"waterlinked-serial", "waterlinked-json", "navquest"})
    for (const bool told : {false, true}) {
      errors.attitude_told = told;
      SensorSetup sensor = sensor_of("dvl", errors, format);
      sensor.mount = {.pitch_deg = 2.0, .yaw_deg = 45.0};
      const auto trip = heard(sensor);
      const bool navquest = format == "navquest";
      const auto& bottom = trip.worst.at("it bottom velocity, m/s");
      EXPECT_GT(bottom.count, 350) << format;
      EXPECT_LT(bottom.count, 420) << format << ": some lock is lost with two beams";
      EXPECT_GT(bottom.error, 0.5 * bottom.resolution) << format;
      const auto& water = trip.worst.at("it water velocity, m/s");
      EXPECT_EQ(water.count, navquest ? 420 - bottom.count : 420) << format << ": one line, one of them";
      EXPECT_GT(trip.worst.at("it altitude, m").count, 320) << format;
      EXPECT_GT(trip.worst.at("it range, m").count, 4 * 400) << format;
      EXPECT_EQ(trip.worst.count("it roll, deg"), told ? 1u : 0u) << format;
      EXPECT_EQ(trip.worst.count("it heading, deg"), told && navquest ? 1u : 0u) << format;
      EXPECT_EQ(trip.worst.count("it clock"), navquest ? 0u : 1u) << format;
      sensor.errors = DvlOptions{.coordinates = "earth"};
      EXPECT_EQ(check_sensor(sensor).size(), 1u) << format;
    }
}

TEST(Telegrams, PressureSensorsSayWhatWasMeasured) {
  for (const std::string format : {"valeport", "paroscientific"}) {
    const auto trip = heard(sensor_of("depth", DepthOptions{.noise_m = 0.1}, format));
    EXPECT_EQ(trip.worst.at("it depth, m").count, 420) << format;
    EXPECT_EQ(trip.worst.at("it pressure, m").count, 420) << format;
  }
}

TEST(Telegrams, BinaryInstrumentsSayWhatWasMeasured) {
  const DvlOptions errors{
      .noise_mps = 0.02, .beam_loss_share = 0.1, .range_noise_percent = 1, .water_track = true};
  const auto dvl = heard(sensor_of("dvl", errors, "nortek-dvl"));
  EXPECT_GT(dvl.worst.at("it bottom velocity, m/s").count, 350);
  EXPECT_LT(dvl.worst.at("it bottom velocity, m/s").count, 420) << "some lock is lost with two beams";
  EXPECT_EQ(dvl.worst.at("it water velocity, m/s").count, 420);
  EXPECT_EQ(dvl.worst.at("it pressure, m").count, 840) << "both records tell it";
  EXPECT_GT(dvl.worst.at("it altitude, m").count, 350);
  const CompassOptions compass{.declination_deg = -7.5, .noise_deg = 1};
  EXPECT_EQ(heard(sensor_of("compass", compass, "pni-tcm")).worst.at("it heading, deg").count, 420);
  const auto ahrs =
      heard(sensor_of("ahrs", AhrsOptions{.heading_noise_deg = 1, .tilt_noise_deg = 1, .rate_noise_dps = 1},
                      "xsens-mtdata2"));
  for (const char* what : {"it heading, deg", "it roll, deg", "it pitch, deg", "it rate, rad/s", "it clock"})
    EXPECT_EQ(ahrs.worst.at(what).count, 420) << what;
  const ImuOptions imu{.gyro_noise_deg_sqrt_h = 0.1, .accel_noise_ug_sqrt_hz = 10};
  EXPECT_EQ(heard(sensor_of("imu", imu, "xsens-mtdata2")).worst.at("it accel, m/s2").count, 419);
  SensorSetup increments = sensor_of("imu", imu, "xsens-mtdata2");
  increments.errors = ImuOptions{.increments = true};
  EXPECT_EQ(check_sensor(increments).size(), 1u);
  const UsblOptions usbl{.transponder = "7", .drms_m = 3, .depth_noise_m = 1};
  EXPECT_GT(heard(sensor_of("usbl", usbl, "evologics-usbl")).worst.at("it offset, m").count, 400);
}

TEST(Telegrams, WithoutAChecksumCannotBeSimulatedCorrupt) {
  const FaultOptions corrupt{.kind = "corrupt"};
  for (const std::string format : {"waterlinked-json", "navquest"})
    EXPECT_TRUE(check_fault(sensor_of("dvl", DvlOptions{}, format), corrupt)) << format;
  EXPECT_TRUE(check_fault(sensor_of("depth", DepthOptions{}, "paroscientific"), corrupt));
  SensorSetup dvl = sensor_of("dvl", DvlOptions{}, "waterlinked-serial");
  EXPECT_FALSE(check_fault(dvl, corrupt));
  dvl.faults = {{.kind = "corrupt", .from_s = 10.0, .until_s = 20.0}};
  EXPECT_EQ(heard(dvl).worst.at("it bottom velocity, m/s").count, 350);
}

TEST(Telegrams, ADvlSpeaksVbwAndTables) {
  const DvlOptions errors{.noise_mps = 0.02, .water_track = true};
  EXPECT_EQ(heard(sensor_of("dvl", errors, "nmea0183")).worst.at("it bottom velocity, m/s").count, 420);
  const auto trip = heard(sensor_of("dvl", errors, "table"));
  EXPECT_EQ(trip.worst.at("it bottom velocity, m/s").count, 420);
  EXPECT_EQ(trip.worst.at("it bottom velocity, m/s").error, 0.0) << "a table loses nothing";
}

TEST(Telegrams, HeadingsAndTiltsSayWhatWasMeasured) {
  const AhrsOptions errors{.heading_noise_deg = 1,
                           .tilt_noise_deg = 1,
                           .rate_noise_dps = 1,
                           .heave_noise_m = 0.1,
                           .sigmas_told = true};
  for (const std::string sentence : {"PASHR", "PRDID", "PSXN"}) {
    const auto trip = heard(sensor_of("ahrs", errors, "", {sentence}));
    EXPECT_EQ(trip.worst.at("it heading, deg").count, 420) << sentence;
    EXPECT_EQ(trip.worst.at("it roll, deg").count, 420) << sentence;
  }
  EXPECT_EQ(heard(sensor_of("ahrs", errors, "", {"HDT"})).worst.at("it heading, deg").count, 420);
  EXPECT_EQ(heard(sensor_of("ahrs", errors, "", {"THS"})).worst.at("it heading, deg").count, 420);
  EXPECT_EQ(heard(sensor_of("ahrs", errors, "", {"ROT"})).worst.at("it rate, rad/s").count, 420);
  EXPECT_EQ(heard(sensor_of("ahrs", errors, "", {"XDR"})).worst.at("it pitch, deg").count, 420);
  EXPECT_EQ(heard(sensor_of("ahrs", errors, "table")).worst.at("it rate, rad/s").count, 420);
}

TEST(Telegrams, CompassesSoundersDepthsAndImusSayWhatWasMeasured) {
  const CompassOptions compass{
      .declination_deg = -7.5, .deviation_b_deg = 3, .noise_deg = 1, .variation_told = true};
  for (const std::string sentence : {"HDG", "HDM"})
    EXPECT_EQ(heard(sensor_of("compass", compass, "", {sentence})).worst.at("it heading, deg").count, 420);
  EXPECT_EQ(heard(sensor_of("compass", compass, "table")).worst.at("it heading, deg").count, 420);
  for (const std::string sentence : {"DPT", "DBT"})
    EXPECT_EQ(heard(sensor_of("altitude", AltitudeOptions{.noise_m = 0.3}, "", {sentence}))
                  .worst.at("it bottom, m")
                  .count,
              420);
  EXPECT_EQ(heard(sensor_of("altitude", AltitudeOptions{}, "table")).worst.at("it altitude, m").count, 420);
  EXPECT_EQ(heard(sensor_of("depth", DepthOptions{.noise_m = 0.3})).worst.at("it depth, m").count, 420);
  for (const bool increments : {false, true}) {
    const ImuOptions imu{
        .increments = increments, .gyro_noise_deg_sqrt_h = 0.1, .accel_noise_ug_sqrt_hz = 10};
    EXPECT_EQ(heard(sensor_of("imu", imu)).worst.at("it accel, m/s2").count,
              419);  // none without an interval
  }
}

TEST(Telegrams, AreWrittenAsTheStandardSays) {
  Telegrams out;
  {
    Sentence s(out, "GP", "GGA");
    s.time_of_day(*parse_iso8601("2026-11-22T12:35:19.4996Z"), 2);
    s.position(Geodetic{Angle::deg(-59.9999999999), Angle::deg(179.9999999999)}, 5)
        .heading(Angle::deg(359.996), 2);
  }
  EXPECT_EQ(out[0].substr(0, out[0].find('*')), "$GPGGA,123519.50,6000.00000,S,18000.00000,E,0.00");
  EXPECT_EQ(out[0].substr(out[0].size() - 2), "\r\n");
  {
    Sentence s(out, "HC", "HDG");
    s.number(101.1, 1).number(2.0, 1).text("E").number(7.1, 1).text("W");
  }
  EXPECT_EQ(out[1], "$HCHDG,101.1,2.0,E,7.1,W*55\r\n");  // a published sample with its checksum
}

TEST(Telegrams, OfADamagedScenarioAreRefusedAndNothingElseIs) {
  SensorSetup ahrs = sensor_of("ahrs", AhrsOptions{}, "", {"HDT"});
  ahrs.faults = {{.kind = "corrupt", .from_s = 10.0, .until_s = 20.0},
                 {.kind = "garbage", .from_s = 30.0, .until_s = 40.0, .bytes = 40}};
  const auto trip = heard(ahrs);
  EXPECT_EQ(trip.damaged_frames, 140);
  EXPECT_GE(trip.refused_of_damaged, 140);
  EXPECT_EQ(trip.worst.at("it heading, deg").count, 350);

  SensorSetup dvl = sensor_of("dvl", DvlOptions{});
  dvl.faults = {{.kind = "garbage", .from_s = 30.0, .until_s = 40.0, .bytes = 40}};
  EXPECT_EQ(heard(dvl).worst.at("it bottom velocity, m/s").count, 420) << "ensembles are found in rubbish";
  for (const std::string format :
       {"trdi-pd4", "trdi-pd6", "nortek-dvl", "waterlinked-serial", "waterlinked-json", "navquest"}) {
    dvl.options.format = format;
    EXPECT_EQ(heard(dvl).worst.at("it bottom velocity, m/s").count, 420) << format;
  }
}

}  // namespace
}  // namespace leadline::sim
