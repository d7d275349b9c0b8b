#pragma once

// Facts measured by instruments, one struct a kind. SI and radians; a value that a telegram did not give is
// empty, never 0. Each sd_ is one sigma as the telegram states it; where it is empty the engine takes its
// own.

#include <array>
#include <cstdint>
#include <optional>

#include "core/types/angle.h"
#include "core/types/position.h"
#include "core/types/text.h"
#include "core/types/vec3.h"

namespace leadline {

/// IEC 61162-1 GGA quality. Only those an engine may use become a GnssFix: manual, simulated and
/// estimated positions do not.
enum class GnssQuality : std::uint8_t { unknown, autonomous, differential, precise, rtk_fixed, rtk_float };

/// One position of a GNSS antenna.
struct GnssFix {
  Geodetic position;
  std::optional<EllipsoidHeight> height;
  GnssQuality quality = GnssQuality::unknown;
  std::optional<std::uint8_t> satellites;
  std::optional<double> hdop;
  std::optional<double> sd_north_m, sd_east_m, sd_down_m;
  bool operator==(const GnssFix&) const = default;
};

/// Velocity over ground of a GNSS antenna. Course is empty at rest.
struct Course {
  double speed_mps = 0.0;
  std::optional<Angle> course;  ///< clockwise from true north, [0, 2 pi)
  std::optional<double> vel_down_mps;
  std::optional<double> sd_mps;
  bool operator==(const Course&) const = default;
};

enum class HeadingReference : std::uint8_t { true_north, magnetic_north };

/// Clockwise from the reference, [0, 2 pi). A magnetic heading has its deviation applied.
struct Heading {
  Angle heading;
  HeadingReference reference = HeadingReference::true_north;
  std::optional<Angle> variation;  ///< the telegram's own, east positive: true = magnetic + variation
  std::optional<Angle> sd;
  bool operator==(const Heading&) const = default;
};

/// Roll positive starboard down, pitch positive bow up; of the instrument, before its mount.
struct Attitude {
  Angle roll, pitch;
  std::optional<double> heave_up_m;
  std::optional<Angle> sd_roll, sd_pitch;
  bool operator==(const Attitude&) const = default;
};

/// Turn rate about the down axis, clockwise (bow to starboard) positive.
struct Rates {
  double rate_z_rps = 0.0;
  bool operator==(const Rates&) const = default;
};

/// One inertial sample in instrument axes; it holds over the interval that ends at its time.
struct ImuSample {
  bool increments = false;       ///< false: rad/s and m/s2; true: rad and m/s over the interval
  Vec3<Instrument> gyro, accel;  ///< accel is specific force
  bool operator==(const ImuSample&) const = default;
};

enum class DvlReference : std::uint8_t { bottom, water };
/// The axes a DvlVelocity is given in.
enum class DvlFrame : std::uint8_t {
  instrument,  ///< forward-starboard-down of the instrument; the mount's roll, pitch and yaw apply
  ship,        ///< forward-starboard-down of the hull: the device has applied its own alignment
  earth,       ///< north-east-down: the device has applied `applied` (its heading and tilts)
};

/// Velocity of the vehicle over the bottom or through the water (not the device's sign of the moving bottom).
struct DvlVelocity {
  DvlReference reference = DvlReference::bottom;
  DvlFrame frame = DvlFrame::instrument;
  bool tilt_applied = false;                     ///< level already: never tilt it again
  double x_mps = 0.0, y_mps = 0.0, z_mps = 0.0;  ///< forward, starboard, down; earth: north, east, down
  bool valid = false;                            ///< false: a ping without lock; the components say nothing
  std::optional<double> sd_mps, error_mps;
  struct Applied {
    Angle heading, roll, pitch;
    HeadingReference reference = HeadingReference::true_north;
    bool operator==(const Applied&) const = default;
  };
  std::optional<Applied> applied;  ///< the attitude the device used, to undo it before a better one is used
  bool operator==(const DvlVelocity&) const = default;
};

/// Ranges of the beams to the bottom, 0 = no detection; whether along the beam or vertical is the device's.
struct BeamRanges {
  std::array<double, 4> range_m{};
  Angle beam_angle;
  bool operator==(const BeamRanges&) const = default;
};

/// Above the bottom, of the instrument.
struct AltitudeAboveBottom {
  double above_bottom_m = 0.0;
  bool operator==(const AltitudeAboveBottom&) const = default;
};

/// Depth of the instrument below the surface.
struct DepthMeasured {
  Depth depth;
  std::optional<double> sd_m;
  bool operator==(const DepthMeasured&) const = default;
};

/// Depth of the bottom below the surface or the keel (echo sounders).
struct BottomDepth {
  enum class Below : std::uint8_t { transducer, surface, keel };
  double depth_m = 0.0;
  Below below = Below::transducer;
  bool operator==(const BottomDepth&) const = default;
};

/// Relative to one standard atmosphere.
struct Pressure {
  double gauge_pa = 0.0;
  bool operator==(const Pressure&) const = default;
};

struct SoundSpeed {
  double speed_mps = 0.0;
  bool operator==(const SoundSpeed&) const = default;
};

/// Axes of a USBL position relative to its transducer.
enum class UsblAxes : std::uint8_t {
  head_up,  ///< forward, starboard, down of the transceiver's hull
  north_up  ///< north, east, down
};

/// A transponder as seen from a USBL transceiver.
struct UsblRelative {
  Text<8> transponder;
  UsblAxes axes = UsblAxes::head_up;
  double x_m = 0.0, y_m = 0.0;   ///< forward, starboard or north, east
  std::optional<double> down_m;  ///< below the transceiver or the surface, as the device gives it
  std::optional<double> sd_m;    ///< expected 1-sigma radius
  bool operator==(const UsblRelative&) const = default;
};

/// A transponder in latitude and longitude.
struct UsblGeographic {
  Text<8> transponder;
  Geodetic position;
  std::optional<Depth> depth;
  std::optional<double> sd_m;
  bool operator==(const UsblGeographic&) const = default;
};

/// A transponder in UTM coordinates of the zone the ship is in.
struct UsblGrid {
  Text<8> transponder;
  double easting_m = 0.0, northing_m = 0.0;
  std::optional<Depth> depth;
  std::optional<double> sd_m;
  bool operator==(const UsblGrid&) const = default;
};

/// What a device's clock said in a telegram that gives date and time: the source's clock is judged by it,
/// and a plain byte stream gets its time line from it.
struct ClockReading {
  Text<12> telegram;
  std::int64_t device_ns = 0;                ///< UTC as the device has it, ns since 1970
  std::optional<std::int64_t> reference_ns;  ///< UTC of a GNSS heard inside the same telegram at that instant
  bool operator==(const ClockReading&) const = default;
};

}  // namespace leadline
