#include "core/links/tlog_source.h"

#include <algorithm>
#include <array>

namespace leadline::links {
namespace {

constexpr std::uint8_t kNoDigit = 0xFF;

constexpr std::array<std::uint8_t, 256> hex_digits() {
  std::array<std::uint8_t, 256> values{};
  for (auto& value : values) value = kNoDigit;
  for (std::uint8_t i = 0; i < 10; ++i) values['0' + i] = i;
  for (std::uint8_t i = 0; i < 6; ++i) values['a' + i] = values['A' + i] = static_cast<std::uint8_t>(10 + i);
  return values;
}
constexpr auto kHexDigits = hex_digits();

}  // namespace

TlogSource::TlogSource(FileReader file, std::vector<SourceName> names)
    : StampedLineSource(std::move(file), kNoSource),
      names_(std::move(names)),
      decoded_(FileReader::kLineCeiling / 2) {}

std::optional<LineStamp> TlogSource::stamp_of(std::string_view line) const { return unix_stamp(line); }

void TlogSource::take_payload(std::string_view line, std::string_view payload, Chunk& chunk) {
  const std::size_t start = std::min(payload.find_first_not_of(" \t"), payload.size());
  const std::size_t end = std::min(payload.find_first_of(" \t\r\n", start), payload.size());
  const std::string_view name = payload.substr(start, end - start);
  if (end == payload.size())
    return settle(chunk, line, ByteClass::refused, "truncated");  // torn inside the name
  if (name.empty()) return settle(chunk, line, ByteClass::refused, "stamp");
  const std::size_t blank = payload[end] == ' ' || payload[end] == '\t' ? 1 : 0;
  payload.remove_prefix(end + blank);
  chunk.stamp_bytes = static_cast<std::uint32_t>(line.size() - payload.size());

  const auto known =
      std::find_if(names_.begin(), names_.end(), [&](const SourceName& n) { return n.name == name; });
  chunk.source = known == names_.end() ? kNoSource : known->id;
  chunk.bytes = bytes_of(payload);
  if (known == names_.end()) {
    chunk.settled = ByteClass::unknown;
    count_unknown(name);
  } else if (!payload.empty() && payload.front() == '#') {
    take_hex(line, payload, chunk);
  }
}

void TlogSource::take_hex(std::string_view line, std::string_view payload, Chunk& chunk) {
  const bool terminated = payload.back() == '\n';
  std::string_view digits = payload.substr(1);
  digits = digits.substr(0, digits.find_last_not_of(" \t\r\n") + 1);
  std::size_t count = 0;
  std::uint8_t wrong = 0;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    const std::uint8_t high = kHexDigits[static_cast<std::uint8_t>(digits[i])];
    const std::uint8_t low = kHexDigits[static_cast<std::uint8_t>(digits[i + 1])];
    wrong |= (high | low) & 0xF0;
    decoded_[count++] = static_cast<std::uint8_t>(high << 4 | (low & 0x0F));
  }
  if (wrong != 0) return settle(chunk, line, ByteClass::refused, "hex");
  if (digits.size() % 2 != 0)
    return settle(chunk, line, ByteClass::refused, terminated ? "hex" : "truncated");
  chunk.bytes = {decoded_.data(), count};
  chunk.stamp_bytes = static_cast<std::uint32_t>(line.size() - count);
}

void TlogSource::count_unknown(std::string_view name) {
  constexpr std::size_t kMostNames = 256, kLongestName = 64;
  name = name.substr(0, kLongestName);
  auto entry = unknown_sources_.find(name);
  if (entry == unknown_sources_.end()) {
    const bool full = unknown_sources_.size() >= kMostNames - 1;
    entry = unknown_sources_.try_emplace(full ? "(others)" : std::string(name), 0).first;
  }
  ++entry->second;
}

}  // namespace leadline::links
