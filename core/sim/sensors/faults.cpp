#include "core/sim/sensors/faults.h"

#include <algorithm>

#include "core/geo/geodesy.h"

namespace leadline::sim {
namespace {

/// Adds what a jump says to whatever the measurement holds of it.
struct Shift {
  const FaultOptions& by;

  void operator()(GnssMeasurement& m) const {
    m.position = geo::displaced(m.position, by.north_m, by.east_m);
    m.height_m -= by.down_m;
  }
  void operator()(UsblMeasurement& m) const {
    m.position = geo::displaced(m.position, by.north_m, by.east_m);
    m.ne_m += Eigen::Vector2d(by.north_m, by.east_m);
    m.depth_m += by.down_m;
  }
  void operator()(DvlMeasurement& m) const { m.v_s += Eigen::Vector3d(by.x_mps, by.y_mps, by.z_mps); }
  void operator()(AttitudeMeasurement& m) const { turn(m.attitude.heading); }
  void operator()(CompassMeasurement& m) const { turn(m.heading); }
  void operator()(ImuSample&) const {}
  void operator()(DepthMeasurement& m) const { m.depth_m += by.down_m; }
  void operator()(AltitudeMeasurement& m) const {
    if (m.above_bottom_m) m.above_bottom_m = std::max(0.0, *m.above_bottom_m - by.down_m);
  }

 private:
  void turn(Angle& heading) const { heading = (heading + Angle::deg(by.heading_deg)).wrapped_2pi(); }
};

struct Flip {
  void operator()(DvlMeasurement& m) const {
    m.v_s = -m.v_s;
    if (m.water_s) m.water_s = Eigen::Vector3d(-*m.water_s);
  }
  void operator()(AttitudeMeasurement& m) const {
    m.attitude.roll = -m.attitude.roll, m.attitude.pitch = -m.attitude.pitch;
    m.rate_z_rps = -m.rate_z_rps;
  }
  void operator()(ImuSample& m) const { m.gyro = -m.gyro, m.accel = -m.accel; }
  template <class Other>
  void operator()(Other&) const {}
};

bool is_fix(const Measurement& m) {
  if (const auto* gnss = std::get_if<GnssMeasurement>(&m)) return gnss->fix;
  if (const auto* usbl = std::get_if<UsblMeasurement>(&m)) return usbl->reply;
  return false;
}

}  // namespace

Faults::Faults(const std::vector<FaultOptions>& faults) {
  for (const auto& options : faults) faults_.push_back({options, 0});
}

bool Faults::is_due(const Fault& fault, double t_s) {
  constexpr double kTime_s = 1e-9;
  const FaultOptions& o = fault.options;
  if (t_s < o.from_s - kTime_s || (o.until_s && t_s >= *o.until_s - kTime_s)) return false;
  return o.kind != "false-fixes" || fault.done < o.count;
}

Faults::Outcome Faults::apply(double t_s, Measurement& measurement) {
  Outcome outcome;
  if (faults_.empty()) return outcome;
  bool frozen = false;
  for (auto& fault : faults_) {
    if (!is_due(fault, t_s)) continue;
    const FaultOptions& o = fault.options;
    if (o.kind == "dropout") outcome.silent = true;
    if (o.kind == "corrupt") outcome.corrupt = true;
    if (o.kind == "garbage") outcome.garbage = o.bytes;
    if (o.kind == "freeze") frozen = true;
    if (o.kind == "sign-flip") std::visit(Flip{}, measurement);
    if (o.kind == "jump") std::visit(Shift{o}, measurement);
    if (o.kind == "false-fixes" && is_fix(measurement)) {
      std::visit(Shift{o}, measurement);
      ++fault.done;
    }
  }
  if (frozen && last_good_)
    measurement = *last_good_;
  else
    last_good_ = measurement;
  return outcome;
}

}  // namespace leadline::sim
