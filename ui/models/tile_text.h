#pragma once

// What a figure says on its tile, already in words: the widgets draw it, the models write it. Plain values.

#include <optional>
#include <string>

#include "core/messages/bookkeeping.h"

namespace leadline::ui {

/// How far a value may be trusted. Where several hold the greatest wins.
enum class ValueState : std::uint8_t {
  live,
  ageing,    ///< older than two periods and 1 s
  pending,   ///< commanded, not answered
  disagree,  ///< what was commanded and what is reported differ
  alert,     ///< beyond its limit
  stale,     ///< older than five periods and 3 s
  lost,      ///< older than twenty periods and 60 s: no value
};

/// One figure. Texts are UTF-8 and carry neither "σ" nor "STALE", "LOST", "SIM": the tile writes those.
struct TileText {
  std::string label;    ///< "Depth"
  std::string value;    ///< "1512.4"; empty: unknown. Minus is U+2212; a sign has a slot of its own
  std::string value_2;  ///< second line of a position: "129°54.30000′ E"; empty on other tiles
  std::string unit;     ///< "m", "° T"
  std::string sigma;    ///< "0.3", "0.6 m" when it writes its own unit; empty: none shown
  std::string source;   ///< "press"; empty on small tiles
  std::string age;      ///< "0.2 s", "14 s", "2:41"
  std::string note;  ///< last line: "COG 074.8° T", "last 1512.4 m at 13:59:56 Z", "vehicle reports 1508.0 m"
  ValueState state = ValueState::live;
  Alarm::Priority priority = Alarm::Priority::alarm;  ///< of an alert
  std::string limit;                                  ///< of an alert: "LOW, limit 5.0"
  std::string was_source;  ///< "GNSS": the source changed less than 10 s ago; empty: it did not
  bool replay = false, simulated = false, manual = false;
  std::string tool_tip;  ///< empty: the tile composes one
  bool operator==(const TileText&) const = default;
};

/// What the compass rose points at. Degrees true; nothing is drawn for what is empty.
struct RoseAngles {
  std::optional<double> heading_deg, course_deg, current_to_deg, set_heading_deg;
  ValueState state = ValueState::live;  ///< of the heading
  bool replay = false, simulated = false;
  bool operator==(const RoseAngles&) const = default;
};

/// The own data of one body. A figure without feed is absent, its place stays empty.
struct OwnDataText {
  std::string subject;  ///< "MDV-1"
  std::string fact;     ///< "engine fusion   10 Hz"
  std::string absent;   ///< why there are no figures: "no vehicle in this file"; empty: there are some
  std::optional<TileText> position, heading, speed, depth, altitude, roll, pitch, current;
  std::optional<RoseAngles> rose;
  bool operator==(const OwnDataText&) const = default;
};

}  // namespace leadline::ui
