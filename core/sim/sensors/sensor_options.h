#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/flow/source_options.h"
#include "core/sim/sensors/ahrs.h"
#include "core/sim/sensors/compass.h"
#include "core/sim/sensors/dvl.h"
#include "core/sim/sensors/gnss.h"
#include "core/sim/sensors/imu.h"
#include "core/sim/sensors/sounder.h"
#include "core/sim/sensors/usbl.h"

namespace leadline::sim {

/// What every [[sensor]] has: who carries it, how it speaks, when it is heard.
struct SensorOptions {
  std::string name, kind;
  std::string body = "vehicle";
  std::string format;
  std::vector<std::string> sentences;
  std::string talker;
  std::string link;
  double rate_hz = 1.0, first_s = 0.0;
  double latency_s = 0.0, jitter_s = 0.0;
  double clock_offset_s = 0.0, clock_drift_ppm = 0.0;
  bool clock_known = true;
};
[[nodiscard]] std::span<const Key<SensorOptions>> sensor_keys();

/// One [[sensor.fault]]: what goes wrong, from when until when.
struct FaultOptions {
  std::string kind;
  double from_s = 0.0;
  std::optional<double> until_s;
  std::int64_t count = 0;
  double north_m = 0.0, east_m = 0.0, down_m = 0.0;
  double x_mps = 0.0, y_mps = 0.0, z_mps = 0.0;
  double heading_deg = 0.0;
  std::int64_t bytes = 16;
};
[[nodiscard]] std::span<const Key<FaultOptions>> fault_keys();

using ErrorModel = std::variant<GnssOptions, UsblOptions, DvlOptions, AhrsOptions, CompassOptions, ImuOptions,
                                DepthOptions, AltitudeOptions>;

/// One instrument of a scenario. mount is what the configuration says; mount_error what it does not know,
/// added to the mount's angles and place.
struct SensorSetup {
  SensorOptions options;
  MountOptions mount, mount_error;
  ErrorModel errors;
  std::vector<FaultOptions> faults;
};

/// The error model of a kind ("gnss", "usbl", "dvl", ...); empty: there is no such kind.
[[nodiscard]] std::optional<ErrorModel> error_model(const std::string& kind);
[[nodiscard]] std::vector<BoundKey> error_keys(ErrorModel& errors);

/// What a sensor cannot be told, by key; empty: all is well.
struct SensorProblem {
  std::string key, text;
};
[[nodiscard]] std::vector<SensorProblem> check_sensor(const SensorSetup& sensor);
[[nodiscard]] std::optional<SensorProblem> check_fault(const SensorSetup& sensor, const FaultOptions& fault);

/// The format a sensor speaks: as given, else as its kind usually does.
[[nodiscard]] std::string format_of(const SensorSetup& sensor);
/// The sentences a sensor speaks: as given, else its kind's usual ones.
[[nodiscard]] std::vector<std::string> sentences_of(const SensorSetup& sensor);

}  // namespace leadline::sim
