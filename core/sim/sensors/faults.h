#pragma once

#include <optional>
#include <vector>

#include "core/sim/sensors/measurement.h"
#include "core/sim/sensors/sensor_options.h"

namespace leadline::sim {

/// What goes wrong with one instrument, by time.
class Faults {
 public:
  explicit Faults(const std::vector<FaultOptions>& faults);

  struct Outcome {
    bool silent = false;       ///< no telegram
    bool corrupt = false;      ///< one bit of the telegram is turned
    std::int64_t garbage = 0;  ///< bytes of rubbish before it
  };
  /// Spoils a measurement made at t_s, times in order.
  [[nodiscard]] Outcome apply(double t_s, Measurement& measurement);

 private:
  struct Fault {
    FaultOptions options;
    std::int64_t done = 0;  ///< false fixes made so far
  };
  [[nodiscard]] static bool is_due(const Fault& fault, double t_s);

  std::vector<Fault> faults_;
  std::optional<Measurement> last_good_;
};

}  // namespace leadline::sim
