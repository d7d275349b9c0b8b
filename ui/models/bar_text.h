#pragma once

// What the bars around the chart say, already in words. Plain values, UTF-8.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/messages/bookkeeping.h"
#include "core/messages/navigation.h"

namespace leadline::ui {

enum class Operation : std::uint8_t { none, live, replay, simulation, calibration };

struct TopBarText {
  Operation operation = Operation::live;
  std::string dive;          ///< "Dive 07 · survey box 3"
  std::string file;          ///< "dive-07.leadline · read only"
  std::optional<Mode> mode;  ///< empty: nothing has said one yet
  std::string mode_words;    ///< "USBL and DVL", "DVL only, σ grows"
  std::string mode_since;    ///< "since 13:02:40 Z"
  std::string outputs;       ///< "Recording 1.84 GB", "Outputs off"
  std::string outputs_2;     ///< "96 h left · all rows acknowledged", "nothing is sent"
  /// Of the recording: caution below 4 h, alarm when it does not record.
  std::optional<Alarm::Priority> outputs_alert;
  std::string date;  ///< "2026-09-14"
  std::string time;  ///< "14:02:37 Z"
  bool operator==(const TopBarText&) const = default;
};

enum class AlertMark : std::uint8_t { unacknowledged, silenced, acknowledged, rectified };

/// The alert of highest priority, newest first, and how many there are.
struct AlertBarText {
  struct Alert {
    Alarm::Priority priority = Alarm::Priority::warning;
    AlertMark mark = AlertMark::unacknowledged;
    std::string text;   ///< "USBL: 3 of the last 8 fixes refused"
    std::string cause;  ///< "residuals 35 to 38 m, gate 15.2 m"
    std::string state;  ///< "14:02:26 Z · 11 s · unacknowledged"
    bool operator==(const Alert&) const = default;
  };
  std::optional<Alert> alert;   ///< empty: no alerts
  std::array<int, 3> counts{};  ///< alarms with emergencies, warnings, cautions
  bool replay = false;          ///< recorded: silent, nothing to acknowledge
  bool operator==(const AlertBarText&) const = default;
};

struct StatusBarText {
  std::string cursor;              ///< "36°54.48270′ N  129°54.16108′ E"; empty: not over the chart
  std::string from;                ///< "MDV-1": what range is measured from
  std::string range;               ///< "299 m  223.6° T"
  std::string depth, depth_layer;  ///< "1561 m", "bathymetry"
  std::string datum;               ///< "WGS 84 · UTM 52N"
  std::string tool, tool_key;      ///< "Measure", "M"
  std::string links;               ///< "6 of 6", "closed in replay"
  std::string screen;              ///< "60 Hz  newest wins"
  std::string user;                ///< "watch 2"
  bool operator==(const StatusBarText&) const = default;
};

}  // namespace leadline::ui
