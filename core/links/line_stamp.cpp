#include "core/links/line_stamp.h"

#include <cstdint>

namespace leadline::links {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::int64_t kLastSecond = 9'000'000'000;  // year 2255; int64 nanoseconds end in 2262

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// The 1 to 9 decimals at `at` as nanoseconds; `at` moves behind them. -1 when there are none or more.
std::int64_t decimals(std::string_view text, std::size_t& at) {
  std::int64_t ns = 0;
  int count = 0;
  for (; at < text.size() && is_digit(text[at]); ++at)
    if (++count <= 9) ns = ns * 10 + (text[at] - '0');
  if (count < 1 || count > 9) return -1;
  for (; count < 9; ++count) ns *= 10;
  return ns;
}

/// Two digits at `at`; a value no calendar field allows when they are none.
int two_digits(const char* at) {
  return is_digit(at[0]) && is_digit(at[1]) ? (at[0] - '0') * 10 + (at[1] - '0') : 99;
}

/// The fixed positions nearly every line has; anything unusual is left to parse_iso8601.
std::optional<LineStamp> usual_iso_stamp(std::string_view line) {
  constexpr std::size_t kSeconds = 19;  // length of YYYY-MM-DDThh:mm:ss
  if (line.size() <= kSeconds) return std::nullopt;
  const char* const p = line.data();
  if (p[4] != '-' || p[7] != '-' || p[10] != 'T' || p[13] != ':' || p[16] != ':') return std::nullopt;
  const int century = two_digits(p), year = two_digits(p + 2);
  if (!is_digit(p[0]) || !is_digit(p[2]) || !is_digit(p[3])) return std::nullopt;
  Civil c{century * 100 + year,
          two_digits(p + 5),
          two_digits(p + 8),
          two_digits(p + 11),
          two_digits(p + 14),
          two_digits(p + 17),
          0};
  std::size_t at = kSeconds;
  if (p[at] == '.') {
    const std::int64_t ns = decimals(line, ++at);
    if (ns < 0) return std::nullopt;
    c.nanosecond = static_cast<std::int32_t>(ns);
  }
  if (at < line.size() && line[at] == 'Z') ++at;
  if (at >= line.size()) return std::nullopt;
  const auto time = from_civil(c);
  if (!time) return std::nullopt;
  if (is_blank(line[at])) return LineStamp{*time, at + 1};
  if (line[at] == '\r' || line[at] == '\n') return LineStamp{*time, at};
  return std::nullopt;
}

}  // namespace

std::optional<LineStamp> unix_stamp(std::string_view line) {
  if (line.empty() || line[0] != '(') return std::nullopt;
  std::size_t at = 1;
  std::int64_t second = 0;
  for (; at < line.size() && at <= 10 && is_digit(line[at]); ++at) second = second * 10 + (line[at] - '0');
  if (at == 1 || second > kLastSecond || at >= line.size() || line[at] != '.') return std::nullopt;
  const std::int64_t ns = decimals(line, ++at);
  if (ns < 0 || at + 1 >= line.size() || line[at] != ')' || !is_blank(line[at + 1])) return std::nullopt;
  return LineStamp{Time{second * kNsPerSecond + ns}, at + 2};
}

std::optional<LineStamp> iso_stamp(std::string_view line) {
  if (const auto stamp = usual_iso_stamp(line)) return stamp;
  constexpr std::size_t kLongest = 40;
  const std::size_t end = line.substr(0, kLongest).find_first_of(" \t\r\n");
  if (end == std::string_view::npos || line.substr(0, end).find('T') == std::string_view::npos)
    return std::nullopt;
  const auto time = parse_iso8601(line.substr(0, end));
  if (!time) return std::nullopt;
  return LineStamp{*time, is_blank(line[end]) ? end + 1 : end};
}

bool is_comment(std::string_view line) {
  if (!line.empty() && line[0] == '#') return true;
  return line.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

std::size_t byte_order_mark(std::string_view text) { return text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0; }

}  // namespace leadline::links
