#pragma once

// What the screen knows at one moment: newest values only, each with its age, source and sigma. Plain values.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/messages/message.h"

namespace leadline::ui {

enum class Body : std::uint8_t { ship, vehicle, target };

/// Which instrument a figure comes from, when it last spoke and how often it does.
struct Feed {
  std::string source;     ///< "dvl"; "usbl + dvl" where several make one figure
  Time valid;             ///< of its newest sample
  double period_s = 0.0;  ///< its nominal interval; 0: not known yet
  std::string was;        ///< the source before this one; empty: this one speaks for 10 s or more
  Time changed;           ///< when it took over from `was`
  bool operator==(const Feed&) const = default;
};

/// One body: its newest solution and what each of its figures is fed by. A figure without feed is not shown.
struct BodyState {
  std::string name;
  std::string engine;    ///< that made the solution; "ship" for the ship's own track
  double rate_hz = 0.0;  ///< of the solution, over the last seconds; 0: not known
  Time valid;            ///< of the solution
  Solution solution;
  std::optional<Feed> position, heading, velocity, depth, attitude;
  struct Altitude {
    double above_bottom_m = 0.0;
    Feed feed;
    bool operator==(const Altitude&) const = default;
  };
  std::optional<Altitude> altitude;
  bool operator==(const BodyState&) const = default;
};

/// The target as last seen.
struct TargetState {
  std::string name;
  Geodetic position;
  std::optional<Depth> depth;
  double var_north_m2 = 0.0, cov_north_east_m2 = 0.0, var_east_m2 = 0.0;
  Feed feed;
  bool operator==(const TargetState&) const = default;
};

/// One position fix as the shown engine judged it.
struct FixMark {
  Time valid;
  Geodetic position;
  Geodetic solution;             ///< where the engine was; equal to position where it was nowhere yet
  std::optional<bool> accepted;  ///< empty: not used by that engine
  std::optional<double> residual_m, gate_m;
  SourceId source = kNoSource;
  bool operator==(const FixMark&) const = default;
};

/// One position of an engine's track.
struct TrackPoint {
  Time valid;
  Geodetic position;
  float drms_m = 0.0F;  ///< sqrt(var north + var east)
  bool operator==(const TrackPoint&) const = default;
};

/// The way of one engine's body, oldest first; valid never goes back.
struct Track {
  EngineId engine = 0;
  std::string name;  ///< the engine's; "ship" for the ship's own
  Body body = Body::vehicle;
  std::vector<TrackPoint> points;
};

struct ModeMark {
  Time valid;
  Mode mode = Mode::E0;
  std::string reason;
  bool operator==(const ModeMark&) const = default;
};

/// What the timeline marks: an alarm, an operator's or the recorder's event, a gap.
struct EventMark {
  enum class Kind : std::uint8_t { event, caution, warning, alarm, gap };
  Time valid;
  Time until;  ///< a gap's end; otherwise valid
  Kind kind = Kind::event;
  std::string text;
  bool operator==(const EventMark&) const = default;
};

/// Everything that has a place in time, of one run; it only grows. The snapshot's `now` says how much is
/// shown.
struct History {
  std::vector<Track> tracks;
  std::vector<FixMark> fixes;
  std::vector<ModeMark> modes;
  std::vector<EventMark> events;
  Time first, last;       ///< of the run
  bool complete = false;  ///< false: still being read
};

struct SourceState {
  std::string name, decoder;
  Body body = Body::vehicle;
  double rate_hz = 0.0;             ///< frames over the last seconds; 0: silent
  double period_s = 0.0;            ///< nominal
  std::optional<Time> last;         ///< its newest frame
  std::optional<double> latency_s;  ///< arrival minus validity of its newest fact
  std::uint64_t frames = 0, refused = 0;
  std::string last_refusal;     ///< its reason; empty: none yet
  std::optional<double> sigma;  ///< one quality figure, with its unit, of its newest fact
  std::string sigma_unit;
  int beams = 0, satellites = 0;            ///< that its newest fact was made of; 0: it does not say
  int fixes_judged = 0, fixes_refused = 0;  ///< of its last eight fixes
  bool operator==(const SourceState&) const = default;
};

/// The availability state in force; empty mode: no engine has said one.
struct AvailabilityState {
  std::optional<Mode> mode;
  std::string reason;
  Time since;  ///< Time{}: not known
  bool operator==(const AvailabilityState&) const = default;
};

struct AlertState {
  Alarm::Priority priority = Alarm::Priority::caution;
  Time raised;
  std::string text, source;
  bool operator==(const AlertState&) const = default;
};

/// From the ship's transceiver to where it last saw the vehicle.
struct UsblBeam {
  Geodetic transponder;
  Feed feed;
  bool operator==(const UsblBeam&) const = default;
};

struct Snapshot {
  Time now;  ///< the play head in replay; the newest arrival when live
  bool replay = false;
  std::string dive, file;  ///< what it is called, where it is kept
  std::optional<BodyState> ship, vehicle;
  std::vector<TargetState> targets;
  std::vector<BodyState> others;  ///< the same body by the other engines
  AvailabilityState availability;
  std::vector<SourceState> sources;
  std::vector<AlertState> alerts;  ///< newest first
  std::optional<UsblBeam> beam;
};

}  // namespace leadline::ui
