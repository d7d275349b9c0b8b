#include "ui/models/link_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "ui/bridge/snapshot.h"
#include "ui/models/figures.h"
#include "ui/models/freshness.h"

namespace leadline::ui {
namespace {

/// In three figures: "12.3 k", "4.10 M".
std::string short_text(double value) {
  const char* prefix = "";
  for (const char* const larger : {"k", "M", "G", "T"}) {
    if (value < 999.5) break;
    value /= 1000.0;
    prefix = larger;
  }
  return fmt::format("{:.{}f} {}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0, prefix);
}

/// "812 B", "12.3 kB"
std::string size_text(std::uint64_t bytes) {
  return bytes < 1000 ? fmt::format("{} B", bytes)
                      : fmt::format("{}B", short_text(static_cast<double>(bytes)));
}

/// "1 234 567"; beyond `most` "12.3 M".
std::string count_text(std::uint64_t count, std::uint64_t most = ~std::uint64_t{0}) {
  if (count > most) return short_text(static_cast<double>(count));
  const std::string digits = std::to_string(count);
  std::string grouped;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) grouped.push_back(' ');
    grouped.push_back(digits[i]);
  }
  return grouped;
}

LinkRow row_of(const LinkState& link, const Snapshot& snapshot) {
  LinkRow row;
  row.sources = link.sources;
  row.address = link.address;
  row.state = link.open                 ? LinkRow::State::open
              : link.last_error.empty() ? LinkRow::State::closed
                                        : LinkRow::State::failed;
  row.last_error = link.last_error;
  row.bytes = link.heard_bytes, row.frames = link.heard_frames;
  row.kernel_drops = link.kernel_drops;
  const SourceState *newest = nullptr, *refused = nullptr;
  for (const SourceId id : link.sources) {
    if (id >= snapshot.sources.size()) continue;
    const SourceState& source = snapshot.sources[id];
    row.names.push_back(source.name);
    row.rate_hz += source.rate_hz;
    row.refused += source.refused;
    if (source.latency_s && (!row.latency_s || *source.latency_s > *row.latency_s))
      row.latency_s = source.latency_s;
    if (source.last && (newest == nullptr || *source.last > *newest->last)) newest = &source;
    if (source.refused > 0 && (refused == nullptr || source.last > refused->last)) refused = &source;
  }
  if (refused != nullptr) row.last_refusal = refused->last_refusal;
  if (newest != nullptr) {
    const Duration age = snapshot.now - *newest->last;
    row.age_s = std::max(seconds(age), 0.0);
    row.heard = freshness(age, newest->period_s);
  }
  return row;
}

}  // namespace

std::vector<LinkRow> link_rows(const std::vector<LinkState>& links, const Snapshot& snapshot) {
  std::vector<LinkRow> rows;
  rows.reserve(links.size());
  for (const LinkState& link : links) rows.push_back(row_of(link, snapshot));
  return rows;
}

std::string link_names(const LinkRow& row) { return fmt::format("{}", fmt::join(row.names, ", ")); }

LinkCells link_cells(const LinkRow& row) {
  const char* const words[]{"open", "closed", "failed"};
  std::string state = words[static_cast<std::size_t>(row.state)];
  if (row.state == LinkRow::State::failed) state += " · " + row.last_error;
  return {link_names(row),
          row.address,
          state,
          size_text(row.bytes),
          count_text(row.frames, 9'999'999),
          row.rate_hz > 0.0 ? rate_text(row.rate_hz) : "",
          count_text(row.refused, 99'999),
          row.latency_s ? latency_text(*row.latency_s) : "",
          count_text(row.kernel_drops, 9'999),
          row.age_s ? age_text(duration(*row.age_s)) : ""};
}

std::string link_trouble(const LinkRow& row) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : " · ") + what; };
  if (!row.last_error.empty()) add("last error: " + row.last_error);
  if (row.refused > 0) add("last refusal: " + row.last_refusal);
  if (row.kernel_drops > 0) add(count_text(row.kernel_drops) + " dropped by the kernel, which had no room");
  return text;
}

std::string links_open(const std::vector<LinkRow>& rows) {
  const auto open =
      std::ranges::count_if(rows, [](const LinkRow& row) { return row.state == LinkRow::State::open; });
  return fmt::format("{} of {} open", open, rows.size());
}

}  // namespace leadline::ui
