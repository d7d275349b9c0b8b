#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <deque>
#include <map>
#include <memory>

#include "core/decode/pressure_depth.h"
#include "core/decode/registry.h"
#include "core/flow/source_info.h"
#include "core/geo/geodesy.h"
#include "core/geo/utm.h"
#include "core/sim/simulation.h"
#include "core/sim/telegrams/table_writer.h"

namespace leadline::sim {

/// The decoder the generated configuration gives a sensor.
inline std::unique_ptr<Decoder> decoder_for(const SensorSetup& sensor) {
  DecoderSettings settings;
  if (const auto* usbl = std::get_if<UsblOptions>(&sensor.errors)) settings.address = usbl->transponder;
  decode::TableOptions table;
  table.columns = table_columns_of(sensor);
  return decode::make_decoder(format_of(sensor), settings, table).value();
}

/// Decodes every telegram and compares each fact with the measurement it was written from, to half of the
/// telegram's last digit.
class RoundTrip final : public SimulationOutput, private DecoderOutput {
 public:
  explicit RoundTrip(const Scenario& scenario) : scenario_(scenario) {
    for (const auto& sensor : scenario_.sensors) ears_.push_back({&sensor, decoder_for(sensor), {}, {}});
  }

  struct Worst {
    double error = 0.0, resolution = 0.0;
    long count = 0;
  };
  std::map<std::string, Worst> worst;  ///< by sensor and quantity
  long frames = 0, facts = 0, refused = 0, refused_of_damaged = 0, damaged_frames = 0;

  void truth(Body, Time, const Truth&) override {}
  void measured(std::size_t sensor, Time t, Time device, const Measurement& m) override {
    ears_[sensor].measured.push_back({t, device, m});
  }
  void telegram(std::size_t sensor, Arrival arrival, std::string_view bytes, bool damaged) override {
    Ear& ear = ears_[sensor];
    const Time heard = arrival.host() - duration(ear.sensor->options.latency_s) + Duration(1000);
    while (ear.measured.size() > 1 && ear.measured[1].t <= heard) ear.measured.pop_front();
    now_ = &ear;
    damaged_ = damaged;
    ++frames;
    damaged_frames += damaged;
    ear.decoder->feed({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, arrival, *this);
    ear.spoilt = damaged && (format() == "trdi-pd0" || format() == "trdi-pd4" || format() == "nortek-dvl" ||
                             format() == "pni-tcm" || format() == "xsens-mtdata2");
  }

 private:
  struct Past {
    Time t, device;
    Measurement m;
  };
  struct Ear {
    const SensorSetup* sensor;
    std::unique_ptr<Decoder> decoder;
    std::deque<Past> measured;
    bool spoilt = false;  ///< rubbish lies before this frame: a binary framing tells of it only now
  };

  void frame(const FrameReport& report) override {
    const bool lost = report.byte_class == ByteClass::refused || report.byte_class == ByteClass::skipped ||
                      report.byte_class == ByteClass::unknown;
    if (!lost) return;
    const bool made = damaged_ || now_->spoilt;
    (made ? refused_of_damaged : refused) += 1;
    if (!made) ADD_FAILURE() << now_->sensor->options.name << " " << report.kind << ": " << report.reason;
  }

  void fact(std::optional<Time> device, const Message& message) override {
    ASSERT_FALSE(damaged_) << "a damaged telegram was believed";
    ASSERT_FALSE(now_->measured.empty());
    ++facts;
    if (device) {
      const double resolution_s = format() == "table" ? 0.0 : 0.005;
      expect("time", seconds(*device - past().device), resolution_s + 1e-9);
    }
    std::visit([&](const auto& fact) { compare(fact); }, message);
  }

  [[nodiscard]] const Past& past() const { return now_->measured.front(); }
  template <class M>
  [[nodiscard]] const M& measurement() const {
    return std::get<M>(past().m);
  }
  template <class O>
  [[nodiscard]] const O& errors() const {
    return std::get<O>(now_->sensor->errors);
  }
  [[nodiscard]] std::string format() const { return format_of(*now_->sensor); }
  [[nodiscard]] bool table() const { return format() == "table"; }
  /// Numbers arrive as they were, but for the last bits of an angle.
  [[nodiscard]] bool exact() const { return table() || format() == "xsens-mtdata2"; }
  static double half(std::int64_t decimals) { return 0.5 * std::pow(10.0, -static_cast<double>(decimals)); }

  void expect(const std::string& quantity, double error, double resolution) {
    Worst& w = worst[now_->sensor->options.name + " " + quantity];
    w.error = std::max(w.error, std::abs(error));
    w.resolution = resolution;
    ++w.count;
    ASSERT_LE(std::abs(error), resolution * (1.0 + 1e-6)) << now_->sensor->options.name << " " << quantity;
  }
  void expect_angle(const std::string& quantity, Angle got, Angle wanted, double resolution_deg) {
    expect(quantity, (got - wanted).wrapped_pi().deg(), resolution_deg + 1e-10);
  }
  void expect_place(Geodetic got, Geodetic wanted, double resolution_m) {
    const auto off = geo::difference(wanted, got);
    expect("position, m", std::max(std::abs(off.north_m), std::abs(off.east_m)), resolution_m);
  }

  template <class Other>
  void compare(const Other&) {
    ADD_FAILURE() << now_->sensor->options.name << ": a fact of a kind nobody measured";
  }
  void compare(const Health&) {}  // words about the source
  void compare(const Pressure& f) {
    if (const auto* dvl = std::get_if<DvlMeasurement>(&past().m))  // 0.1 bar a metre
      return expect("pressure, m", f.gauge_pa * 1e-4 - dvl->depth_m, 1e-5);
    const double depth_m = decode::depth_of_pressure_m(f.gauge_pa, Angle::deg(45.0));
    expect("pressure, m", depth_m - measurement<DepthMeasurement>().depth_m, 0.0005 + 1e-9);
  }
  void compare(const ClockReading& f) {
    expect("clock", seconds(Time{f.device_ns} - past().device), 0.005 + 1e-9);
  }
  void compare(const GnssFix& f) {
    const auto& m = measurement<GnssMeasurement>();
    ASSERT_TRUE(m.fix);
    const double minutes_m = 1853.0 * half(errors<GnssOptions>().position_decimals);
    expect_place(f.position, m.position, table() ? 3e-9 : minutes_m * 1.01 + 2e-9);
    if (f.height) expect("height, m", f.height->m - m.height_m, table() ? 0.0 : 0.0005 + 1e-9);
    if (f.hdop) expect("hdop", *f.hdop - m.hdop, 0.005 + 1e-9);
    if (f.satellites) expect("satellites", *f.satellites - m.satellites, 0.0);
    if (f.sd_north_m) expect("sigma, m", *f.sd_north_m - m.sd_axis_m, table() ? 0.0 : 0.0005 + 1e-9);
  }
  void compare(const Course& f) {
    const auto& m = measurement<GnssMeasurement>();
    expect("speed, m/s", f.speed_mps - m.speed_mps, table() ? 1e-12 : 0.0005 * 1852 / 3600 + 1e-9);
    if (f.course && m.course) expect_angle("course, deg", *f.course, *m.course, table() ? 1e-9 : 0.005);
  }
  void compare(const Heading& f) {
    if (const auto* m = std::get_if<CompassMeasurement>(&past().m)) {
      EXPECT_EQ(f.reference, HeadingReference::magnetic_north);
      expect_angle("heading, deg", f.heading, m->heading,
                   table()                 ? 0.0
                   : format() == "pni-tcm" ? 2e-5
                                           : half(errors<CompassOptions>().heading_decimals));
      return;
    }
    EXPECT_EQ(f.reference, HeadingReference::true_north);
    if (const auto* m = std::get_if<DvlMeasurement>(&past().m))
      return expect_angle("heading, deg", f.heading, m->attitude.heading, table() ? 0.0 : 0.005);
    expect_angle("heading, deg", f.heading, measurement<AttitudeMeasurement>().attitude.heading,
                 exact() ? 0.0 : half(errors<AhrsOptions>().heading_decimals));
  }
  void compare(const Attitude& f) {
    const auto* dvl = std::get_if<DvlMeasurement>(&past().m);
    const auto& wanted = dvl ? dvl->attitude : measurement<AttitudeMeasurement>().attitude;
    const double resolution = exact() ? 0.0 : dvl ? 0.005 : half(errors<AhrsOptions>().tilt_decimals);
    expect_angle("roll, deg", f.roll, wanted.roll, resolution);
    expect_angle("pitch, deg", f.pitch, wanted.pitch, resolution);
    if (f.heave_up_m)
      expect("heave, m", *f.heave_up_m - measurement<AttitudeMeasurement>().heave_up_m, 0.005 + 1e-9);
  }
  void compare(const Rates& f) {
    if (const auto* imu = std::get_if<ImuSample>(&past().m))
      return expect("rate, rad/s", f.rate_z_rps - imu->gyro.z, 0.0);
    expect("rate, rad/s", f.rate_z_rps - measurement<AttitudeMeasurement>().rate_z_rps,
           exact() ? 0.0 : 0.005 / 60.0 * kRadPerDeg + 1e-12);
  }
  void compare(const ImuSample& f) {
    const auto& m = measurement<ImuSample>();
    EXPECT_EQ(f, m);
    expect("accel, m/s2", (f.accel.eigen() - m.accel.eigen()).norm(), 0.0);
  }
  void compare(const DvlVelocity& f) {
    const auto& m = measurement<DvlMeasurement>();
    const auto& o = errors<DvlOptions>();
    const bool bottom = f.reference == DvlReference::bottom;
    const std::string name = bottom ? "bottom velocity, m/s" : "water velocity, m/s";
    if (!f.valid) {
      EXPECT_TRUE(!bottom || !m.bottom) << "lock was lost on the way";
      return;
    }
    EXPECT_TRUE(bottom ? m.bottom : m.water_s.has_value());
    Eigen::Vector3d wanted = bottom ? m.v_s : *m.water_s;
    const bool fine = bottom && o.high_resolution && format() == "trdi-pd0";
    double resolution = table() ? 0.0 : fine ? 0.5e-5 : 0.5e-3;
    const bool trdi = format().substr(0, 4) == "trdi";
    if (format() == "nmea0183") {
      EXPECT_EQ(f.frame, DvlFrame::ship);
      EXPECT_TRUE(f.tilt_applied);
      const Angle yaw = Angle::rad(std::atan2(m.C_bs(1, 0), m.C_bs(0, 0)));
      wanted = Rotation<Ned, Instrument>::zyx({m.attitude.roll, m.attitude.pitch, yaw}).matrix() * wanted;
      wanted.z() = 0.0;
      resolution = 0.0005 * 1852 / 3600;
    } else if (format() == "trdi-pd6" && o.coordinates == "ship") {
      EXPECT_EQ(f.frame, DvlFrame::ship);
      EXPECT_TRUE(f.tilt_applied);
      const Angle yaw = Angle::rad(std::atan2(m.C_bs(1, 0), m.C_bs(0, 0)));
      wanted = Rotation<Ned, Instrument>::zyx({m.attitude.roll, m.attitude.pitch, yaw}).matrix() * wanted;
    } else if (trdi && o.coordinates == "ship") {
      EXPECT_EQ(f.frame, DvlFrame::ship);
      EXPECT_FALSE(f.tilt_applied);
      wanted = m.C_bs * wanted;
    } else if (trdi && o.coordinates == "earth") {
      EXPECT_EQ(f.frame, DvlFrame::earth);
      wanted = Rotation<Ned, Instrument>::zyx(m.attitude).matrix() * wanted;
    } else {
      if (format() == "navquest") resolution = 0.5e-4;
      if (format() == "nortek-dvl") resolution = 1e-6;
      EXPECT_EQ(f.frame, DvlFrame::instrument);
      // Two beams make a component: their halves of a millimetre add up, three when one beam is made up.
      if (format() == "trdi-pd0" && o.coordinates == "beam")
        resolution *= 2.0 / std::sin(o.beam_angle_deg * kRadPerDeg);
    }
    const Eigen::Vector3d error = Eigen::Vector3d(f.x_mps, f.y_mps, f.z_mps) - wanted;
    expect(name, error.cwiseAbs().maxCoeff(), resolution + 1e-12);
  }
  void compare(const BeamRanges& f) {
    const auto& m = measurement<DvlMeasurement>();
    const std::size_t looks[] = {1, 0, 2, 3};
    const bool own_order = format().substr(0, 4) != "trdi";
    const double vertical = format().substr(0, 5) == "water" ? cos(f.beam_angle) : 1.0;
    const std::size_t nortek[] = {2, 0, 3, 1};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t beam = format() == "nortek-dvl" ? nortek[i] : own_order ? i : looks[i];
      expect("range, m", f.range_m[i] * vertical - m.range_m[beam], 0.005 + 1e-9);
    }
  }
  void compare(const AltitudeAboveBottom& f) {
    if (const auto* m = std::get_if<AltitudeMeasurement>(&past().m))
      return expect("altitude, m", f.above_bottom_m - m->above_bottom_m.value(), 0.0);
    const auto& m = measurement<DvlMeasurement>();
    double sum = 0, beams = 0;
    for (std::size_t i = 0; i < 4; i += 2)
      if (m.beam[i] && m.beam[i + 1]) sum += m.range_m[i] + m.range_m[i + 1], beams += 2;
    expect("altitude, m", f.above_bottom_m - sum / beams, 0.005 + 1e-9);
  }
  void compare(const BottomDepth& f) {
    expect("bottom, m", f.depth_m - measurement<AltitudeMeasurement>().above_bottom_m.value(), 0.005 + 1e-9);
  }
  void compare(const DepthMeasured& f) {
    if (const auto* m = std::get_if<DvlMeasurement>(&past().m))
      return expect("depth, m", f.depth.m - m->depth_m, table() ? 0.0 : 0.05 + 1e-9);
    expect("depth, m", f.depth.m - measurement<DepthMeasurement>().depth_m,
           format() == "valeport"         ? 0.0005 + 1e-9
           : format() == "paroscientific" ? 1e-5
                                          : 0.0);
  }
  void compare(const SoundSpeed& f) {
    expect("sound speed, m/s", f.speed_mps - measurement<DvlMeasurement>().sound_speed_mps, 0.5);
  }
  void compare(const UsblRelative& f) {
    const auto& m = measurement<UsblMeasurement>();
    const Eigen::Vector2d wanted = f.axes == UsblAxes::head_up ? m.ahead_m() : m.ne_m;
    expect("offset, m", (Eigen::Vector2d(f.x_m, f.y_m) - wanted).cwiseAbs().maxCoeff(), 0.005 + 1e-9);
    expect_usbl(f.transponder, f.down_m, f.sd_m);
  }
  void compare(const UsblGeographic& f) {
    expect_place(f.position, measurement<UsblMeasurement>().position, 1e-3);
    expect_usbl(f.transponder, f.depth ? std::optional(f.depth->m) : std::nullopt, f.sd_m);
  }
  void compare(const UsblGrid& f) {
    const auto& m = measurement<UsblMeasurement>();
    const auto utm = geo::to_utm(m.position).value();
    expect("easting, m", f.easting_m - utm.easting_m, 0.005 + 1e-6);
    expect("northing, m", f.northing_m - utm.northing_m, 0.005 + 1e-6);
    expect_usbl(f.transponder, f.depth ? std::optional(f.depth->m) : std::nullopt, f.sd_m);
  }
  void expect_usbl(const Text<8>& name, std::optional<double> down_m, std::optional<double> sd_m) {
    const auto& m = measurement<UsblMeasurement>();
    EXPECT_EQ(name.view(), m.transponder);
    ASSERT_TRUE(down_m.has_value());
    expect("depth, m", *down_m - m.depth_m, 0.005 + 1e-9);
    EXPECT_EQ(sd_m.has_value(), errors<UsblOptions>().sigma_told);
    if (sd_m) expect("sigma, m", *sd_m - m.sd_m, 0.005 + 1e-9);
  }

  Scenario scenario_;
  std::vector<Ear> ears_;
  Ear* now_ = nullptr;
  bool damaged_ = false;
};

}  // namespace leadline::sim
