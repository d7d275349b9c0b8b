#include "core/sim/simulation.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>

#include "core/sim/sensors/faults.h"
#include "core/sim/telegrams/evologics_writer.h"
#include "core/sim/telegrams/navquest_writer.h"
#include "core/sim/telegrams/nmea_writer.h"
#include "core/sim/telegrams/nortek_writer.h"
#include "core/sim/telegrams/pd0_writer.h"
#include "core/sim/telegrams/pd4_writer.h"
#include "core/sim/telegrams/pd6_writer.h"
#include "core/sim/telegrams/pni_writer.h"
#include "core/sim/telegrams/pressure_writer.h"
#include "core/sim/telegrams/table_writer.h"
#include "core/sim/telegrams/udpbc_writer.h"
#include "core/sim/telegrams/waterlinked_writer.h"
#include "core/sim/telegrams/xsens_writer.h"

namespace leadline::sim {
namespace {

constexpr double kTime_s = 1e-9;

Eigen::Matrix3d matrix_of(const MountOptions& m) {
  return Rotation<BodyFrame, Instrument>::zyx(
             {Angle::deg(m.roll_deg), Angle::deg(m.pitch_deg), Angle::deg(m.yaw_deg)})
      .matrix();
}

/// Instants at a rate: first + n / rate, to the nearest nanosecond.
class Beat {
 public:
  Beat(double first_s, double rate_hz) : first_ns_(duration(first_s).count()), rate_hz_(rate_hz) {}
  [[nodiscard]] std::int64_t next_ns() const {
    return first_ns_ + std::llround(static_cast<double>(count_) / rate_hz_ * 1e9);
  }
  [[nodiscard]] double next_s() const { return static_cast<double>(next_ns()) * 1e-9; }
  void go_on() { ++count_; }

 private:
  std::int64_t first_ns_;
  double rate_hz_;
  std::int64_t count_ = 0;
};

using Model = std::variant<Gnss, Usbl, Dvl, Ahrs, Compass, Imu, DepthSensor, EchoSounder>;

struct MakeModel {
  const SensorSetup& sensor;
  const geo::MagneticModel* magnetic;
  Time start;
  Random random;

  Model operator()(const GnssOptions& o) const { return Gnss(o, random); }
  Model operator()(const UsblOptions& o) const { return Usbl(o, random); }
  Model operator()(const DvlOptions& o) const { return Dvl(o, matrix_of(sensor.mount), random); }
  Model operator()(const AhrsOptions& o) const { return Ahrs(o, random); }
  Model operator()(const CompassOptions& o) const { return Compass(o, magnetic, start, random); }
  Model operator()(const ImuOptions& o) const { return Imu(o, true_pose(sensor).C_bs, random); }
  Model operator()(const DepthOptions& o) const { return DepthSensor(o, random); }
  Model operator()(const AltitudeOptions& o) const { return EchoSounder(o, random); }
};

/// One sensor at work.
struct Sensor {
  Sensor(const SensorSetup& s, std::size_t number, std::uint64_t seed, const geo::MagneticModel* magnetic,
         Time start)
      : setup(&s),
        format(format_of(s)),
        sentences(sentences_of(s)),
        udpbc(sfi_of(s, number)),
        pose(true_pose(s)),
        model(std::visit(MakeModel{s, magnetic, start, Random(seed, s.options.name)}, s.errors)),
        faults(s.faults),
        line(seed, s.options.name + ".line"),
        beat(s.options.first_s, s.options.rate_hz) {
    if (inertial()) {
      covered_s = beat.next_s();
      beat.go_on();
    }
  }

  [[nodiscard]] bool inertial() const { return std::holds_alternative<Imu>(model); }

  const SensorSetup* setup;
  std::string format;
  std::vector<std::string> sentences;
  encode::Udpbc udpbc;
  Pose pose;
  Model model;
  Faults faults;
  Random line;
  Beat beat;
  Arrival last;
  InertialIncrement increment;
  double covered_s = 0.0;
  std::uint16_t packets = 0;
};

struct Heard {
  Arrival arrival;
  std::uint64_t seq;
  std::size_t sensor;
  std::string bytes;
  bool damaged;
};
struct Later {
  bool operator()(const Heard& a, const Heard& b) const {
    return a.arrival != b.arrival ? a.arrival > b.arrival : a.seq > b.seq;
  }
};

}  // namespace

Pose true_pose(const SensorSetup& s) {
  MountOptions m = s.mount;
  m.roll_deg += s.mount_error.roll_deg;
  m.pitch_deg += s.mount_error.pitch_deg;
  m.yaw_deg += s.mount_error.yaw_deg;
  return {matrix_of(m), {m.x_m + s.mount_error.x_m, m.y_m + s.mount_error.y_m, m.z_m + s.mount_error.z_m}};
}

struct Simulation::World {
  World(const Scenario& s, std::uint64_t seed, const geo::MagneticModel* magnetic)
      : scenario(s), water(s.water), start(s.start()), truth_beat(0.0, s.options.truth_hz) {
    const auto make = [&](const std::optional<Route>& route) {
      return route ? std::optional<Motion>(std::in_place, *route, water, s.origin(), s.options.step_s)
                   : std::nullopt;
    };
    vehicle = make(s.vehicle), ship = make(s.ship), target = make(s.target);
    for (const auto& sensor : scenario.sensors)
      instruments.emplace_back(sensor, instruments.size() + 1, seed, magnetic, start);
  }

  [[nodiscard]] std::optional<Motion>& motion(const std::string& body) {
    return body == "ship" ? ship : body == "target" ? target : vehicle;
  }

  void run(SimulationOutput& out) {
    const double end_s = scenario.options.duration_s;
    for (std::int64_t k = 0;; ++k) {
      const double from_s = static_cast<double>(k) * scenario.options.step_s;
      if (from_s > end_s + kTime_s || !out.go_on()) break;
      if (k > 0)
        for (auto* body : {&vehicle, &ship, &target})
          if (*body) (*body)->step();
      const double to_s = static_cast<double>(k + 1) * scenario.options.step_s;
      tell_step(from_s, to_s, end_s, out);
    }
    while (!heard.empty() && out.go_on()) hand_on(out);
  }

  /// Everything that happens from one point of the grid until just before the next.
  void tell_step(double from_s, double to_s, double end_s, SimulationOutput& out) {
    for (;;) {
      Sensor* next = nullptr;
      double at_s = truth_beat.next_s();
      for (auto& instrument : instruments)
        if (instrument.beat.next_s() < at_s - kTime_s) next = &instrument, at_s = instrument.beat.next_s();
      if (at_s >= to_s - kTime_s || at_s > end_s + kTime_s) break;
      while (!heard.empty() && heard.top().arrival.host() < start + duration(at_s)) hand_on(out);
      if (next)
        measure(*next, from_s, out);
      else
        tell_truth(at_s, out);
    }
    for (auto& instrument : instruments)
      if (instrument.inertial()) cover(instrument, from_s, to_s);
  }

  void cover(Sensor& instrument, double from_s, double to_s) {
    const auto& body = motion(instrument.setup->options.body);
    const double begin_s = std::max(instrument.covered_s, from_s);
    if (begin_s >= to_s) return;
    instrument.increment.cover(*body, instrument.pose.lever_b, begin_s, to_s);
    instrument.covered_s = to_s;
  }

  void tell_truth(double at_s, SimulationOutput& out) {
    const Time t = start + Duration(truth_beat.next_ns());
    if (vehicle) out.truth(Body::vehicle, t, vehicle->at(at_s));
    if (ship) out.truth(Body::ship, t, ship->at(at_s));
    if (target) out.truth(Body::target, t, target->at(at_s));
    truth_beat.go_on();
  }

  void measure(Sensor& instrument, double from_s, SimulationOutput& out) {
    const SensorOptions& o = instrument.setup->options;
    const std::int64_t t_ns = instrument.beat.next_ns();
    const double t_s = instrument.beat.next_s();
    instrument.beat.go_on();
    if (instrument.inertial()) cover(instrument, from_s, t_s);
    Measurement measurement = sense(instrument, t_s);
    const auto outcome = instrument.faults.apply(t_s, measurement);
    const Time t = start + Duration(t_ns);
    const Time device = t + duration(o.clock_offset_s + 1e-6 * o.clock_drift_ppm * t_s);
    const double delay_s = o.latency_s + o.jitter_s * std::abs(instrument.line.normal());
    if (outcome.silent) return;
    const auto sensor = static_cast<std::size_t>(&instrument - instruments.data());
    out.measured(sensor, t, device, measurement);
    write(instrument, device, measurement);
    instrument.last = std::max(instrument.last, arrival_at(t + duration(delay_s)));
    if (outcome.garbage > 0) say(sensor, garbage(instrument, outcome.garbage), true);
    for (std::size_t i = 0; i < telegrams.size(); ++i) {
      std::string bytes(telegrams[i]);
      if (outcome.corrupt) corrupt(instrument, bytes);
      say(sensor, std::move(bytes), outcome.corrupt);
    }
  }

  [[nodiscard]] Measurement sense(Sensor& instrument, double t_s) {
    const auto& body = motion(instrument.setup->options.body);
    if (auto* imu = std::get_if<Imu>(&instrument.model))
      return imu->measure(std::exchange(instrument.increment, {}));
    const Truth truth = body->at(t_s);
    const View view(truth, instrument.pose);
    if (auto* usbl = std::get_if<Usbl>(&instrument.model)) {
      const auto& other = motion(std::get<UsblOptions>(instrument.setup->errors).of);
      return usbl->measure(view, other->at(t_s));
    }
    if (auto* dvl = std::get_if<Dvl>(&instrument.model)) return dvl->measure(view, water);
    if (auto* gnss = std::get_if<Gnss>(&instrument.model)) return gnss->measure(view);
    if (auto* ahrs = std::get_if<Ahrs>(&instrument.model)) return ahrs->measure(view);
    if (auto* compass = std::get_if<Compass>(&instrument.model)) return compass->measure(view);
    if (auto* depth = std::get_if<DepthSensor>(&instrument.model)) return depth->measure(view);
    return std::get<EchoSounder>(instrument.model).measure(view);
  }

  void write(Sensor& instrument, Time device, const Measurement& measurement) {
    telegrams.clear();
    const auto write_dvl = [&](auto writer) {
      writer(std::get<DvlOptions>(instrument.setup->errors), device, std::get<DvlMeasurement>(measurement),
             telegrams);
    };
    if (instrument.format == "trdi-pd0")
      write_dvl(write_pd0);
    else if (instrument.format == "trdi-pd4")
      write_dvl(write_pd4);
    else if (instrument.format == "trdi-pd6")
      write_dvl(write_pd6);
    else if (instrument.format == "waterlinked-serial")
      write_dvl(write_waterlinked_serial);
    else if (instrument.format == "waterlinked-json")
      write_dvl(write_waterlinked_json);
    else if (instrument.format == "nortek-dvl")
      write_dvl(write_nortek);
    else if (instrument.format == "evologics-usbl")
      write_evologics(device, std::get<UsblMeasurement>(measurement), telegrams);
    else if (instrument.format == "pni-tcm")
      write_pni(std::get<CompassMeasurement>(measurement), telegrams);
    else if (const auto* imu = std::get_if<ImuSample>(&measurement);
             imu && instrument.format == "xsens-mtdata2")
      write_xsens(instrument.packets++, device, *imu, telegrams);
    else if (instrument.format == "xsens-mtdata2")
      write_xsens(instrument.packets++, device, std::get<AttitudeMeasurement>(measurement), telegrams);
    else if (instrument.format == "navquest")
      write_dvl(write_navquest);
    else if (instrument.format == "valeport")
      write_valeport(std::get<DepthMeasurement>(measurement), telegrams);
    else if (instrument.format == "paroscientific")
      write_paroscientific(std::get<DepthMeasurement>(measurement), telegrams);
    else if (instrument.format == "table")
      write_row(*instrument.setup, device, measurement, telegrams);
    else if (instrument.format == "iec61162-450")
      write_udpbc(*instrument.setup, instrument.sentences, device, measurement, instrument.udpbc, telegrams);
    else
      write_nmea(*instrument.setup, instrument.sentences, device, measurement, telegrams);
  }

  static bool is_binary(const std::string& format) {
    return format == "trdi-pd0" || format == "trdi-pd4" || format == "nortek-dvl" || format == "pni-tcm" ||
           format == "xsens-mtdata2";
  }

  static std::string garbage(Sensor& instrument, std::int64_t count) {
    std::string bytes;
    for (; count > 0; --count) bytes.push_back(static_cast<char>(instrument.line.byte()));
    if (!is_binary(instrument.format)) bytes += "\r\n";  // so that it spoils nothing but itself
    return bytes;
  }

  /// Turns one bit of what the checksum guards.
  static void corrupt(Sensor& instrument, std::string& bytes) {
    const std::size_t guarded = bytes.size() - (is_binary(instrument.format) ? 2 : 5);
    const std::size_t at =
        1 + static_cast<std::size_t>(instrument.line.uniform() * static_cast<double>(guarded - 1));
    bytes[at] = static_cast<char>(bytes[at] ^ 0x01);
  }

  void say(std::size_t sensor, std::string bytes, bool damaged) {
    heard.push({instruments[sensor].last, seq++, sensor, std::move(bytes), damaged});
  }
  void hand_on(SimulationOutput& out) {
    const Heard& next = heard.top();
    out.telegram(next.sensor, next.arrival, next.bytes, next.damaged);
    heard.pop();
  }

  Scenario scenario;
  Water water;
  Time start;
  std::optional<Motion> vehicle, ship, target;
  std::vector<Sensor> instruments;
  Beat truth_beat;
  Telegrams telegrams;
  std::priority_queue<Heard, std::vector<Heard>, Later> heard;
  std::uint64_t seq = 0;
};

Simulation::Simulation(const Scenario& scenario, std::uint64_t seed, const geo::MagneticModel* magnetic)
    : world_(std::make_unique<World>(scenario, seed, magnetic)) {}
Simulation::~Simulation() = default;

Truth Simulation::at_start() const {
  const auto& body = world_->motion(world_->scenario.options.body);
  LL_EXPECT(body.has_value());
  return body->at(0.0);
}

void Simulation::run(SimulationOutput& out) { world_->run(out); }

}  // namespace leadline::sim
