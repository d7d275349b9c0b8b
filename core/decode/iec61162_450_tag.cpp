#include "core/decode/iec61162_450_tag.h"

#include "core/decode/nmea0183_sentence.h"
#include "core/decode/number.h"

namespace leadline::decode::udpbc {
namespace {

constexpr std::size_t kLongestName = 15;
constexpr std::uint32_t kMostLines = 99;

/// 1 to 15 digits: what a time in milliseconds needs until the year 33658.
std::optional<std::int64_t> parse_time(std::string_view text) {
  if (text.empty() || text.size() > 15) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + (c - '0');
  }
  return value;
}

std::optional<Time> time_of(std::string_view text) {
  constexpr std::int64_t kLeastMilliseconds = 100'000'000'000;
  constexpr std::int64_t kMostMilliseconds = 9'000'000'000'000;  // year 2255
  const auto value = parse_time(text);
  if (!value || *value > kMostMilliseconds) return std::nullopt;
  return Time{*value < kLeastMilliseconds ? *value * 1'000'000'000 : *value * 1'000'000};
}

std::optional<Tag::Group> group_of(std::string_view text) {
  const auto first = text.find('-');
  const auto second = first == std::string_view::npos ? first : text.find('-', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  const auto line = parse_digits(text.substr(0, first));
  const auto total = parse_digits(text.substr(first + 1, second - first - 1));
  const auto id = parse_digits(text.substr(second + 1));
  if (!line || !total || !id || *line < 1 || *line > *total || *total > kMostLines) return std::nullopt;
  return Tag::Group{*line, *total, *id};
}

bool take_value(std::string_view key, std::string_view value, Tag& tag) {
  if (key == "s") return tag.source = value, !value.empty() && value.size() <= kLongestName;
  if (key == "n") {
    const auto n = parse_digits(value);
    if (n && *n <= 999) tag.count = static_cast<std::uint16_t>(*n);
    return tag.count.has_value();
  }
  if (key == "g") return tag.group = group_of(value), tag.group.has_value();
  if (key == "c") return tag.time = time_of(value), tag.time.has_value();
  if (key == "d")
    tag.destination = value;
  else if (key == "t" || key == "i")
    tag.text = value;
  else if (key == "r")
    tag.relative = value;
  else if (key == "a")
    tag.authentication = value;
  else if (tag.other_count < tag.others.size())
    tag.others[tag.other_count++] = {key, value};
  return true;
}

}  // namespace

std::string_view take_tags(std::string_view& line, Tag& tag) {
  constexpr std::string_view kDamaged = "TAG", kChecksum = "TAG checksum";
  while (!line.empty() && line.front() == '\\') {
    const std::size_t close = line.find('\\', 1);
    if (close == std::string_view::npos) return kDamaged;
    const nmea0183::Body body = nmea0183::split_checksum(line.substr(1, close - 1));
    if (body.checksum != ChecksumState::ok) return kChecksum;
    line.remove_prefix(close + 1);
    for (std::string_view rest = body.text; !rest.empty();) {
      const std::size_t comma = rest.find(',');
      const std::string_view field = rest.substr(0, comma);
      rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
      const std::size_t colon = field.find(':');
      if (colon == std::string_view::npos ||
          !take_value(field.substr(0, colon), field.substr(colon + 1), tag))
        return kDamaged;
    }
  }
  return {};
}

}  // namespace leadline::decode::udpbc
