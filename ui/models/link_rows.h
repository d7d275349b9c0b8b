#pragma once

// The links of the console: what the program that runs them hands over, and the rows that are shown of it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/messages/message.h"
#include "ui/models/tile_text.h"

namespace leadline::ui {

struct Snapshot;

/// What is known of one link at a moment.
struct LinkState {
  std::string address;            ///< "udp://:4001", "serial:///dev/ttyS0?baud=9600"
  std::vector<SourceId> sources;  ///< that it feeds
  bool open = false;
  std::string last_error;  ///< one sentence; stays when it is open again
  std::uint64_t heard_bytes = 0, heard_frames = 0;
  std::uint64_t kernel_drops = 0;  ///< datagrams the kernel had no room for
};

struct LinkRow {
  enum class State : std::uint8_t { open, closed, failed };
  std::vector<SourceId> sources;
  std::vector<std::string> names;  ///< of the sources
  std::string address;
  State state = State::closed;  ///< failed: not open, and it says why
  std::string last_error;
  std::uint64_t bytes = 0, frames = 0;
  double rate_hz = 0.0;  ///< of all its sources together
  std::uint64_t refused = 0;
  std::string last_refusal;         ///< of the source that was heard last of those that had any
  std::optional<double> latency_s;  ///< the worst of its sources'
  std::uint64_t kernel_drops = 0;
  std::optional<double> age_s;          ///< since any of its sources was heard; empty: never
  ValueState heard = ValueState::lost;  ///< how old that is for the pace of who spoke last
  bool operator==(const LinkRow&) const = default;
};

/// One row a link, in the order given. A source that the snapshot does not have counts nothing.
[[nodiscard]] std::vector<LinkRow> link_rows(const std::vector<LinkState>& links, const Snapshot& snapshot);

inline constexpr std::array kLinkColumns{"source", "link",    "state",   "bytes", "telegrams",
                                         "rate",   "refused", "latency", "drops", "age"};
using LinkCells = std::array<std::string, kLinkColumns.size()>;
/// A row in words, a cell a column; empty: not known.
[[nodiscard]] LinkCells link_cells(const LinkRow& row);
/// What does not fit into the cells: "last error: ... · last refusal: checksum". Empty: nothing to say.
[[nodiscard]] std::string link_trouble(const LinkRow& row);
/// "dvl, ahrs"
[[nodiscard]] std::string link_names(const LinkRow& row);
/// "5 of 6 open"
[[nodiscard]] std::string links_open(const std::vector<LinkRow>& rows);

}  // namespace leadline::ui
