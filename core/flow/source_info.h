#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/messages/message.h"
#include "core/types/rotation.h"

namespace leadline {

enum class Body : std::uint8_t { vehicle, ship, target };
[[nodiscard]] constexpr const char* name_of(Body body) {
  return body == Body::vehicle ? "vehicle" : body == Body::ship ? "ship" : "target";
}

/// What the wiring knows of a source: everything that decides what its facts mean.
struct SourceInfo {
  SourceId id = kNoSource;
  std::string name;
  Body body = Body::vehicle;

  EulerAngles mount;                 ///< v_b = Rz Ry Rx v_s
  EulerAngles calibration;           ///< added to the mount's angles
  double scale = 1.0;                ///< reference distance over DVL distance
  Vec3<BodyFrame> lever;             ///< of the instrument, from the body's reference point, m
  std::optional<Angle> declination;  ///< instead of the world magnetic model

  std::int64_t time_offset_ns = 0;  ///< added to the device's clock
  bool gps_time = false;            ///< the device's clock runs on GPS time
  std::int64_t latency_ns = 0;      ///< validity = arrival - latency where the device gives no time
};

/// When a fact was true: the device's own clock, corrected, where it gives one; else its arrival less the
/// latency.
[[nodiscard]] inline Time validity(const SourceInfo& source, std::optional<Time> device, Arrival arrival) {
  if (!device) return arrival.host() - Duration(source.latency_ns);
  return (source.gps_time ? utc_from_gps(*device) : *device) + Duration(source.time_offset_ns);
}

}  // namespace leadline
