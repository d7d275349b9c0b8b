#include "core/flow/ledger.h"

#include <numeric>

namespace leadline {
namespace {

template <class Entry>
Entry& entry_named(std::vector<Entry>& entries, std::string_view name) {
  for (auto& entry :
       entries)  // a source has a dozen kinds at most, and they are literals: mostly one compare
    if (entry.name.data() == name.data() && entry.name.size() == name.size()) return entry;
  for (auto& entry : entries)
    if (entry.name == name) return entry;
  return entries.emplace_back(Entry{.name = name});
}

constexpr std::size_t index(ByteClass c) { return static_cast<std::size_t>(c); }

}  // namespace

void Ledger::refuse(std::string_view reason) { ++entry_named(refusals_, reason).count; }

void Ledger::count(const FrameReport& report, Arrival arrival) {
  bytes_[index(report.byte_class)] += report.length;
  lost_ += report.lost;
  if (report.byte_class == ByteClass::refused) refuse(report.reason);
  if (report.kind.empty()) return;
  if (!report.block) {
    ++frames_;
    ++frames_by_class_[index(report.byte_class)];
    ++checksums_[static_cast<std::size_t>(report.checksum)];
  }
  if (report.byte_class != ByteClass::decoded && report.byte_class != ByteClass::unused &&
      report.byte_class != ByteClass::unknown)
    return;
  Kind& kind = entry_named(kinds_, report.kind);
  if (kind.count++ == 0) kind.first = arrival, kind.byte_class = report.byte_class;
  kind.last = arrival;
}

void Ledger::count(const Chunk& chunk) {
  bytes_[index(ByteClass::stamp)] += chunk.stamp_bytes;
  if (!chunk.settled) return;
  bytes_[index(*chunk.settled)] += chunk.bytes.size();
  if (*chunk.settled == ByteClass::refused) refuse(chunk.reason);
}

std::uint64_t Ledger::bytes_total() const {
  return std::accumulate(bytes_.begin(), bytes_.end(), std::uint64_t{0});
}

}  // namespace leadline
