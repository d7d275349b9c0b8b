#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/flow/source_info.h"
#include "core/geo/magnetic.h"
#include "core/sim/scenario.h"
#include "core/sim/sensors/measurement.h"

namespace leadline::sim {

/// Where a simulation puts what it makes, times in order within each function.
class SimulationOutput {
 public:
  virtual ~SimulationOutput() = default;
  /// Each body at truth_hz.
  virtual void truth(Body body, Time t, const Truth& truth) = 0;
  /// What a sensor (by its place in the scenario) measured at t, before anything is written; device: its own
  /// clock then. Faults that change values are in it.
  virtual void measured(std::size_t /*sensor*/, Time /*t*/, Time /*device*/, const Measurement& /*m*/) {}
  /// One frame as it is heard. damaged: made to be refused or skipped.
  virtual void telegram(std::size_t sensor, Arrival arrival, std::string_view bytes, bool damaged) = 0;
  /// Asked at every step; false ends the simulation there.
  virtual bool go_on() { return true; }
};

/// Truth, sensors and telegrams of a scenario. A pure function of scenario and seed: the same bytes again
/// with the same C library. magnetic may be null when every compass has a declination of its own.
class Simulation {
 public:
  Simulation(const Scenario& scenario, std::uint64_t seed, const geo::MagneticModel* magnetic);
  ~Simulation();

  /// The truth at the start of the body whose solution is wanted.
  [[nodiscard]] Truth at_start() const;
  /// From the start to the end, both included.
  void run(SimulationOutput& out);

 private:
  struct World;
  std::unique_ptr<World> world_;
};

/// The instrument's true pose: mount and mount_error added.
[[nodiscard]] Pose true_pose(const SensorSetup& sensor);

}  // namespace leadline::sim
