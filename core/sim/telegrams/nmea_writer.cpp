#include "core/sim/telegrams/nmea_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/geo/utm.h"
#include "core/sim/telegrams/sentence.h"

namespace leadline::sim {
namespace {

constexpr double kKnotsPerMps = 3600.0 / 1852.0;
constexpr int kTimeDecimals = 3;

/// Writes one sentence of a sensor's; one call operator a kind of measurement.
struct Writer {
  const SensorSetup& sensor;
  Time device;
  std::string_view name;
  Telegrams& out;

  [[nodiscard]] std::string_view talker(std::string_view usual) const {
    return sensor.options.talker.empty() ? usual : std::string_view(sensor.options.talker);
  }
  template <class Options>
  [[nodiscard]] const Options& errors() const {
    return std::get<Options>(sensor.errors);
  }

  void operator()(const GnssMeasurement& m) const {
    const int decimals = static_cast<int>(errors<GnssOptions>().position_decimals);
    const auto position = m.fix ? std::optional(m.position) : std::nullopt;
    const Civil date = to_civil(rounded(device, kTimeDecimals));
    const auto when_fixed = [&](double value) { return m.fix ? std::optional(value) : std::nullopt; };
    Sentence s(out, talker("GP"), name);
    if (name == "GGA" || name == "GNS") {
      s.time_of_day(device, kTimeDecimals).position(position, decimals);
      if (name == "GGA")
        s.whole(m.fix ? m.quality : 0, 1);
      else
        s.text(!m.fix           ? "N"
               : m.quality == 1 ? "A"
               : m.quality == 2 ? "D"
               : m.quality == 3 ? "P"
               : m.quality == 4 ? "R"
                                : "F");
      s.whole(m.fix ? m.satellites : 0, 2).number(when_fixed(m.hdop), 2).number(when_fixed(m.height_m), 3);
      if (name == "GGA")
        s.text("M").number(when_fixed(0.0), 1).text("M").text("").text("");
      else
        s.number(when_fixed(0.0), 1).text("").text("");
    } else if (name == "RMC") {
      s.time_of_day(device, kTimeDecimals).text(m.fix ? "A" : "V").position(position, decimals);
      s.number(when_fixed(m.speed_mps * kKnotsPerMps), 3).heading(m.fix ? m.course : std::nullopt, 2);
      s.text(fmt::format("{:02d}{:02d}{:02d}", date.day, date.month, date.year % 100)).text("").text("");
      s.text(m.fix ? "A" : "N");
    } else if (name == "GLL") {
      s.position(position, decimals).time_of_day(device, kTimeDecimals);
      s.text(m.fix ? "A" : "V").text(m.fix ? "A" : "N");
    } else if (name == "VTG") {
      s.heading(m.fix ? m.course : std::nullopt, 2).text("T").text("").text("M");
      s.number(when_fixed(m.speed_mps * kKnotsPerMps), 3).text("N");
      s.number(when_fixed(m.speed_mps * 3.6), 3).text("K").text(m.fix ? "A" : "N");
    } else if (name == "ZDA") {
      s.time_of_day(device, kTimeDecimals).whole(date.day, 2).whole(date.month, 2).whole(date.year, 4);
      s.text("00").text("00");
    } else {  // GST
      s.time_of_day(device, kTimeDecimals).text("").text("").text("").text("");
      s.number(m.sd_axis_m, 3).number(m.sd_axis_m, 3).number(m.sd_height_m, 3);
    }
  }

  void operator()(const UsblMeasurement& m) const {
    if (!m.reply) return;
    if (name == "PTSAG" || name == "PTSAX")
      ixblue(m);
    else
      simrad(m, name.back());
  }

  void simrad(const UsblMeasurement& m, char form) const {
    const bool radians = form == 'R', grid = form == 'U';
    Eigen::Vector2d xy = m.ne_m;
    if (form == 'H') xy = {m.ahead_m().y(), m.ahead_m().x()};  // starboard, then forward
    if (form == 'E') xy = {m.ne_m.y(), m.ne_m.x()};
    if (radians) xy = {m.position.lat.rad(), m.position.lon.rad()};
    if (grid) {
      const auto utm = geo::to_utm(m.position);
      if (!utm) return;
      xy = {utm.value().northing_m, utm.value().easting_m};
    }
    const std::string_view coordinates = radians ? "R" : grid ? "U" : "C";
    const std::string_view orientation = form == 'H' ? "H" : form == 'E' ? "E" : "N";
    const int decimals = radians ? 10 : 2;
    const bool sd = errors<UsblOptions>().sigma_told;
    Sentence s(out, "", "PSIMSSB");
    s.time_of_day(device, 2)
        .text(m.transponder)
        .text("A")
        .text("")
        .text(coordinates)
        .text(orientation)
        .text("M");
    s.number(xy.x(), decimals).number(xy.y(), decimals).number(m.depth_m, 2);
    s.number(sd ? std::optional(m.sd_m) : std::nullopt, 2).text("N").text("").text("");
  }

  void ixblue(const UsblMeasurement& m) const {
    const Civil date = to_civil(rounded(device, kTimeDecimals));
    Sentence s(out, "", name);
    s.text("#00001").time_of_day(device, kTimeDecimals).whole(date.day, 2).whole(date.month, 2);
    s.whole(date.year, 4).text(m.transponder);
    if (name == "PTSAG")
      s.position(m.position, 6);
    else
      s.number(m.ahead_m().x(), 2).number(m.ahead_m().y(), 2);
    s.text("F").number(m.depth_m, 2).text("1").number(9999.0, 2);
  }

  void operator()(const DvlMeasurement& m) const {
    // Level axes of the hull: tilted back by the device's own inclinometers, turned by its mount.
    const Angle yaw = Angle::rad(std::atan2(m.C_bs(1, 0), m.C_bs(0, 0)));
    const auto level = Rotation<Ned, Instrument>::zyx({m.attitude.roll, m.attitude.pitch, yaw}).matrix();
    const auto block = [&](Sentence& s, const std::optional<Eigen::Vector3d>& v) {
      const Eigen::Vector3d v_l = v ? Eigen::Vector3d(level * *v) : Eigen::Vector3d::Zero();
      s.number(v ? std::optional(v_l.x() * kKnotsPerMps) : std::nullopt, 3);
      s.number(v ? std::optional(v_l.y() * kKnotsPerMps) : std::nullopt, 3).text(v ? "A" : "V");
    };
    Sentence s(out, talker("VD"), "VBW");
    block(s, m.water_s);
    block(s, m.bottom ? std::optional(m.v_s) : std::nullopt);
  }

  void operator()(const AttitudeMeasurement& m) const {
    const auto& o = errors<AhrsOptions>();
    const int h = static_cast<int>(o.heading_decimals), t = static_cast<int>(o.tilt_decimals);
    const double roll = m.attitude.roll.deg(), pitch = m.attitude.pitch.deg();
    const auto sigma = [&](double rad) {
      return o.sigmas_told ? std::optional(rad * kDegPerRad) : std::nullopt;
    };
    if (name == "PASHR") {
      Sentence s(out, "", "PASHR");
      s.time_of_day(device, kTimeDecimals)
          .heading(m.attitude.heading, h)
          .text("T")
          .number(roll, t)
          .number(pitch, t);
      s.number(m.heave_up_m, 2).number(sigma(m.sd_tilt_rad), 3).number(sigma(m.sd_tilt_rad), 3);
      s.number(sigma(m.sd_heading_rad), 3).text("1").text("1");
    } else if (name == "PRDID") {
      Sentence(out, "", "PRDID").number(pitch, t).number(roll, t).heading(m.attitude.heading, h);
    } else if (name == "PSXN") {
      Sentence s(out, "", "PSXN");
      s.text("23").number(roll, t).number(pitch, t).heading(m.attitude.heading, h).number(-m.heave_up_m, 2);
    } else if (name == "XDR") {
      Sentence s(out, talker("HE"), "XDR");
      s.text("A").number(pitch, t).text("D").text("PTCH").text("A").number(roll, t).text("D").text("ROLL");
    } else if (name == "ROT") {
      Sentence(out, talker("HE"), "ROT").number(m.rate_z_rps * kDegPerRad * 60.0, 2).text("A");
    } else {
      Sentence(out, talker("HE"), name).heading(m.attitude.heading, h).text(name == "THS" ? "A" : "T");
    }
  }

  void operator()(const CompassMeasurement& m) const {
    const int h = static_cast<int>(errors<CompassOptions>().heading_decimals);
    Sentence s(out, talker("HC"), name);
    s.heading(m.heading, h);
    if (name == "HDM")
      s.text("M");
    else
      s.text("").text("").directed(m.variation, 2, 'E', 'W');
  }

  void operator()(const AltitudeMeasurement& m) const {
    Sentence s(out, talker("SD"), name);
    if (name == "DPT")
      s.number(m.above_bottom_m, 2).number(0.0, 1);
    else
      s.text("").text("f").number(m.above_bottom_m, 2).text("M").text("").text("F");
  }

  void operator()(const ImuSample&) const {}
  void operator()(const DepthMeasurement&) const {}
};

}  // namespace

void write_nmea(const SensorSetup& sensor, std::span<const std::string> sentences, Time device,
                const Measurement& measurement, Telegrams& out) {
  for (const auto& name : sentences) std::visit(Writer{sensor, device, name, out}, measurement);
}

}  // namespace leadline::sim
