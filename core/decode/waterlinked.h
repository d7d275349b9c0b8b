#pragma once

// What a Water Linked DVL says in either of its languages, and the facts made of it.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// One velocity report; empty: not sent. x forward, y starboard, z down.
struct WaterLinkedVelocity {
  bool water = false;  ///< through the water, not over the bottom
  std::array<std::optional<double>, 3> mps;
  bool valid = false;  ///< as the device says
  std::optional<double> fom_mps, altitude_m;
  std::optional<std::array<double, 9>> covariance_m2ps2;
  std::optional<std::array<double, 4>> range_m;  ///< along the beams, 0: none
  std::optional<double> validity_us, transmission_us;
  std::uint32_t status = 0;
};

/// The attitude of a dead-reckoning report, degrees. Its yaw counts from where the device was started: it is
/// no heading.
struct WaterLinkedAttitude {
  std::optional<double> roll_deg, pitch_deg, time_s;
  std::uint32_t status = 0;
};

/// Turns reports into facts. A velocity that is not valid is a DvlVelocity without lock and nothing else; its
/// sigma is the larger horizontal one of the covariance, else the figure of merit.
/// The device's clock starts anywhere until it has found a time server: it is gone by only while it is within
/// 10 s of the arrival (without arrivals: after 2015) and the device does not say that it is not set;
/// otherwise facts have no time of their own, and one note says so.
class WaterLinkedFacts {
 public:
  /// Each returns why the report is refused ("fields", "range"), empty when its facts were told.
  [[nodiscard]] std::string_view tell(std::string_view telegram, const WaterLinkedVelocity& report,
                                      std::optional<Arrival> arrival, DecoderOutput& out);
  [[nodiscard]] std::string_view tell(const WaterLinkedAttitude& report, std::optional<Arrival> arrival,
                                      DecoderOutput& out);
  void tell_ranges(const std::array<double, 4>& range_m, std::optional<Time> time, DecoderOutput& out);
  /// The device says whether its clock is set.
  void clock_set(bool set) { clock_unset_ = !set; }
  /// When the velocity told last was true, if the device's clock is gone by.
  [[nodiscard]] std::optional<Time> last_time() const { return last_time_; }

 private:
  std::optional<Time> instant(std::optional<double> us, std::optional<Arrival> arrival, DecoderOutput& out);
  void tell_status(std::uint32_t status, DecoderOutput& out);
  std::optional<Time> last_time_;
  bool clock_unset_ = false, clock_noted_ = false, hot_ = false;
};

}  // namespace leadline::decode
