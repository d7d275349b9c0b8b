#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/flow/source_info.h"
#include "core/nav/plausibility/findings.h"
#include "core/nav/plausibility/sampled_tracks.h"
#include "core/types/angle.h"

namespace leadline::nav {

/// Instruments of one body that should say the same, compared over the last minute, once a second each:
/// - headings against turn rates, gyros, other headings and the course over ground (above 1 m/s; only its
/// turns
///   count, so drift is free): their changes over 4 s, the larger at least 3 deg rms, nine tenths explained.
///   57 times (within a quarter): radians and degrees; -1 against a rate: its sign. Two headings that stay
///   within 10 deg of 90 or 180 deg apart while the body moves: one is turned.
///   Radians read as degrees also where a heading in 0 to 6.3 deg, 30 deg or more from another, is 57 times
///   itself within 10 deg of it.
/// - roll and pitch against a second inclinometer or the accelerometers, alike over 1 s; alone: a median turn
///   above 30 deg/s.
/// - depths against pressure, USBL depth, other depths and the DVL's summed-up descent: 3.281 or 0.305 times,
///   within 7 %, of their values (below 5 m) or of their changes (5 m or more); altitudes against a second
///   altimeter likewise, and against a change of depth of 5 m, where 3.281 times only and 98 % explained.
class UnitCheck {
 public:
  UnitCheck(std::span<const SourceInfo> sources, Findings& findings);

  void take(const Envelope& envelope);
  /// A position fix's depth, of the body it is a fix of.
  void usbl_depth(SourceId source, double depth_m);
  /// The vertical velocity of a DVL, down.
  void descent(SourceId source, Time t, double down_mps);
  /// The newest heading when those of the last minute lie within 0 to 6.3 deg, as radians read as degrees do.
  [[nodiscard]] std::optional<Angle> reads_as_radians(SourceId source) const;
  /// Once a second.
  void sample(Arrival now, EngineOutput& out);

 private:
  enum Kind : std::uint8_t {
    heading,
    course,
    rate,
    gyro,
    roll,
    pitch,
    accel_roll,
    accel_pitch,
    depth,
    pressure,
    usbl,
    sunk,
    altitude,
    kKinds
  };
  struct Live {
    double value = 0.0, last = 0.0;
    bool fresh = false, known = false;
    std::uint8_t quiet = 0;  ///< seconds since it was heard
    Time at;
  };
  struct Instrument {
    std::array<Live, kKinds> live;
    std::array<SampledTrack, kKinds> tracks;
    std::uint8_t misfits = 0;
  };
  struct Other {
    SourceId source;
    Kind kind;
  };

  void hear(SourceId source, Kind kind, double value);
  void turn(SourceId source, Kind kind, double angle_rad);
  void integrate(SourceId source, Kind kind, Time t, double per_second);
  [[nodiscard]] const SampledTrack& track(Other o) const { return instruments_[o.source].tracks[o.kind]; }
  /// Calls with every used track of these kinds on the body, but this one.
  template <class Visit>
  void others(Other self, std::initializer_list<Kind> kinds, const Visit& visit) const;
  void check_heading(SourceId source, Arrival now, EngineOutput& out);
  void check_tilts(SourceId source, Arrival now, EngineOutput& out);
  void check_depth(SourceId source, Arrival now, EngineOutput& out);
  void check_altitude(SourceId source, Arrival now, EngineOutput& out);

  std::span<const SourceInfo> sources_;
  Findings& findings_;
  std::vector<Instrument> instruments_;
  std::array<bool, 3> moved_{};  ///< by body, since the last look
  std::array<std::uint8_t, 3> moving_s_{};
  std::uint32_t seconds_ = 0;
};

}  // namespace leadline::nav
