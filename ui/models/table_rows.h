#pragma once

// The rows of the tables beside the chart, already in words. Plain values, UTF-8.

#include <optional>
#include <string>
#include <vector>

#include "core/messages/bookkeeping.h"
#include "ui/models/tile_text.h"

namespace leadline::ui {

struct SourceRow {
  std::string name;                      ///< "DVL"
  std::string rate, age, latency;        ///< "5.0 Hz", "0.2 s", "41 ms"; empty: not known
  std::string quality;                   ///< "4 beams", "σ 0.3°", "3 of 8 refused"
  ValueState state = ValueState::live;   ///< of the source as a whole; pending and disagree do not occur
  std::optional<Alarm::Priority> alert;  ///< what its icon says; empty: a check mark, or a cross where lost
  std::string tool_tip;                  ///< frames, refused, last refusal
  bool operator==(const SourceRow&) const = default;
};

struct SourcesText {
  std::string fact;    ///< "6 of 6 live", "6 of 6 recorded"
  std::string absent;  ///< why there are no rows; empty: there are some
  std::vector<SourceRow> rows;
  bool operator==(const SourcesText&) const = default;
};

/// From one body to another.
struct RangeRow {
  std::string from, to;                    ///< "Ship", "MDV-1"
  std::string horizontal, bearing, slant;  ///< "420 m", "308.0° T", "1570 m"; empty: not known
  ValueState state = ValueState::live;     ///< of its oldest parent
  std::string tool_tip;                    ///< sigmas
  bool operator==(const RangeRow&) const = default;
};

struct RangesText {
  std::string fact;
  std::string absent;
  std::vector<RangeRow> rows;
  bool operator==(const RangesText&) const = default;
};

}  // namespace leadline::ui
