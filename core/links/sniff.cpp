#include "core/links/sniff.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "core/links/line_stamp.h"
#include "core/links/sniff_instruments.h"

namespace leadline::links {
namespace {

using Bytes = std::span<const std::uint8_t>;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::uint32_t little16(Bytes b, std::size_t at) { return b[at] | static_cast<std::uint32_t>(b[at + 1]) << 8; }
std::uint32_t little32(Bytes b, std::size_t at) { return little16(b, at) | little16(b, at + 2) << 16; }
std::uint32_t big32(Bytes b, std::size_t at) {
  return static_cast<std::uint32_t>(b[at]) << 24 | static_cast<std::uint32_t>(b[at + 1]) << 16 |
         static_cast<std::uint32_t>(b[at + 2]) << 8 | b[at + 3];
}

// --- binary formats -------------------------------------------------------------------------------------

bool is_pcap(Bytes head) {
  if (head.size() < 24) return false;
  const std::uint32_t magic = little32(head, 0);
  return magic == 0xA1B2C3D4 || magic == 0xD4C3B2A1 || magic == 0xA1B23C4D || magic == 0x4D3CB2A1;
}

bool is_pcapng(Bytes head) {
  if (head.size() < 12 || little32(head, 0) != 0x0A0D0D0A) return false;
  const std::uint32_t order = little32(head, 8);
  return order == 0x1A2B3C4D || order == 0x4D3C2B1A;
}

bool is_xtf(Bytes head) {
  if (head.empty() || head[0] != 0x7B) return false;
  for (std::size_t at = 1024; at + 2 <= head.size();
       at += 1024)  // more than six channels: more blocks of header
    if (little16(head, at) == 0xFACE) return true;
  return false;
}

/// Two message headers in a row, or one that the file ends in.
bool is_jsf(Bytes head, std::uint64_t size) {
  constexpr std::size_t kHeader = 16;
  if (head.size() < kHeader || little16(head, 0) != 0x1601) return false;
  const std::uint64_t next = kHeader + std::uint64_t{little32(head, 12)};
  if (next + 2 > head.size()) return next <= size || head.size() == size;
  return little16(head, static_cast<std::size_t>(next)) == 0x1601;
}

/// Length of one record (u64 big-endian microseconds, frame) at `at`; 0 when there is none.
std::size_t mavlink_record(Bytes head, std::size_t at) {
  if (head.size() < at + 11) return 0;
  const std::uint64_t us = std::uint64_t{big32(head, at)} << 32 | big32(head, at + 4);
  constexpr std::uint64_t kFirst = 946'684'800'000'000, kLast = 4'102'444'800'000'000;  // years 2000 to 2100
  if (us < kFirst || us > kLast) return 0;
  const std::size_t payload = head[at + 9];
  if (head[at + 8] == 0xFE) return 8 + 6 + payload + 2;
  if (head[at + 8] == 0xFD) return 8 + 10 + payload + 2 + ((head[at + 10] & 1) != 0 ? 13 : 0);
  return 0;
}

bool is_mavlink(Bytes head) {
  const std::size_t first = mavlink_record(head, 0);
  return first != 0 && (first + 11 > head.size() || mavlink_record(head, first) != 0);
}

/// An ensemble anywhere in the head whose checksum holds. Sums from the front, so that a head full of 7F
/// costs no more than any other.
bool holds_pd0(Bytes head) {
  std::vector<std::uint32_t> sum;  // of the first i bytes
  for (std::size_t at = 0; at + 8 < head.size(); ++at) {
    if (head[at] != 0x7F || head[at + 1] != 0x7F) continue;
    const std::size_t size = little16(head, at + 2), types = head[at + 5], header = 6 + 2 * types;
    if (types == 0 || size < header + 2 || at + size + 2 > head.size()) continue;
    const std::size_t first = little16(head, at + 6);
    if (first < header || first >= size) continue;
    if (sum.empty()) {
      sum.resize(head.size() + 1);
      for (std::size_t i = 0; i < head.size(); ++i) sum[i + 1] = sum[i] + head[i];
    }
    if (((sum[at + size] - sum[at]) & 0xFFFF) == little16(head, at + size)) return true;
  }
  return false;
}

bool is_udpbc(Bytes head) {
  constexpr std::array<std::string_view, 5> kTokens{"UdPbC", "RaUdP", "RrUdP", "RpUdP", "NkPgN"};
  if (head.size() < 6 || head[5] != 0) return false;
  const std::string_view token(reinterpret_cast<const char*>(head.data()), 5);
  return std::find(kTokens.begin(), kTokens.end(), token) != kTokens.end();
}

// --- text -----------------------------------------------------------------------------------------------

/// $ or !, an address of at least three capitals and digits, a comma; behind a TAG block where there is one.
bool looks_like_sentence(std::string_view line) {
  if (!line.empty() && line[0] == '\\') {
    const std::size_t end = line.find('\\', 1);
    if (end == std::string_view::npos) return false;
    line.remove_prefix(end + 1);
  }
  if (line.empty() || (line[0] != '$' && line[0] != '!')) return false;
  std::size_t at = 1;
  while (at < line.size() && (is_digit(line[at]) || (line[at] >= 'A' && line[at] <= 'Z'))) ++at;
  return at >= 4 && at < line.size() && line[at] == ',';
}

/// A sentence with a checksum that holds somewhere in the line.
bool holds_sentence(std::string_view line) {
  const std::size_t start = line.find_first_of("$!");
  if (start == std::string_view::npos) return false;
  const std::size_t star = line.find('*', start);
  if (star == std::string_view::npos || star + 3 > line.size() || !looks_like_sentence(line.substr(start)))
    return false;
  unsigned sum = 0, written = 0;
  for (const char c : line.substr(start + 1, star - start - 1)) sum ^= static_cast<std::uint8_t>(c);
  for (const char c : line.substr(star + 1, 2)) {
    const char lower = static_cast<char>(c | 0x20);
    if (is_digit(c))
      written = written * 16 + static_cast<unsigned>(c - '0');
    else if (lower >= 'a' && lower <= 'f')
      written = written * 16 + static_cast<unsigned>(lower - 'a' + 10);
    else
      return false;
  }
  return written == sum;
}

/// w, c or r, a sign, and a CRC-8 (polynomial 0x07) of all before the '*' that holds.
bool is_waterlinked_serial(std::string_view line) {
  if (line.size() < 6 || line[0] != 'w' || (line[1] != 'r' && line[1] != 'c')) return false;
  const std::size_t star = line.size() - 3;
  if (line[star] != '*') return false;
  unsigned crc = 0;
  for (const char c : line.substr(0, star)) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = ((crc << 1) ^ ((crc & 0x80) != 0 ? 0x07u : 0u)) & 0xFF;
  }
  constexpr std::string_view kHex = "0123456789abcdef";
  return line[star + 1] == kHex[crc >> 4] && line[star + 2] == kHex[crc & 15];
}

bool is_waterlinked_json(std::string_view line) {
  return line[0] == '{' && line.find("\"type\"") != std::string_view::npos &&
         line.find("\"json_v") != std::string_view::npos;
}

bool is_navquest(std::string_view line) { return line.find("$#NQ.RES ") != std::string_view::npos; }

/// '*', an address of four digits that begins with the host's, and a number.
bool is_paroscientific(std::string_view line) {
  return line.size() >= 6 && line.substr(0, 3) == "*00" && is_digit(line[3]) && is_digit(line[4]) &&
         line.find_first_not_of("0123456789.-+", 5) == std::string_view::npos;
}

/// Digits and what stands in numbers, dates and times; "nan" and an empty field too.
bool looks_like_number(std::string_view field) {
  if (field.empty() || field == "nan" || field == "NaN" || field == "NAN") return true;
  bool digit = false;
  for (const char c : field) {
    digit = digit || is_digit(c);
    if (!is_digit(c) && std::string_view("+-.eE:/TZ").find(c) == std::string_view::npos) return false;
  }
  return digit;
}

struct Row {
  std::size_t fields = 0, numbers = 0;
};

Row split(std::string_view line, char separator) {
  Row row;
  for (std::size_t at = 0; at <= line.size();) {
    std::size_t end = std::min(line.find(separator, at), line.size());
    if (separator == ' ') {
      at = std::min(line.find_first_not_of(" \t", at), line.size());
      end = std::min(line.find_first_of(" \t", at), line.size());
      if (at == end) break;
    }
    std::string_view field = line.substr(at, end - at);
    while (!field.empty() && (field.front() == ' ' || field.front() == '\t')) field.remove_prefix(1);
    while (!field.empty() && (field.back() == ' ' || field.back() == '\t')) field.remove_suffix(1);
    ++row.fields;
    row.numbers += looks_like_number(field) ? 1 : 0;
    at = end + 1;
  }
  return row;
}

/// Seven lines in ten have the same two or more fields, most of them numbers.
bool is_table(const std::vector<std::string_view>& lines) {
  for (const char separator : {',', ';', '\t', ' '}) {
    std::vector<Row> rows;
    for (const std::string_view line : lines)
      if (line[0] != '%') rows.push_back(split(line, separator));
    if (rows.empty()) continue;
    std::vector<std::size_t> counts;
    counts.reserve(rows.size());
    for (const Row& row : rows) counts.push_back(row.fields);
    std::nth_element(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2),
                     counts.end());
    const std::size_t usual = counts[counts.size() / 2];
    if (usual < 2) continue;
    const auto good = std::count_if(rows.begin(), rows.end(), [&](const Row& r) {
      return r.fields == usual && 2 * r.numbers > r.fields;
    });
    if (10 * static_cast<std::size_t>(good) >= 7 * rows.size()) return true;
  }
  return false;
}

/// No control bytes but those that text holds, and hardly any bytes above 7F.
bool is_text(Bytes head) {
  std::size_t high = 0;
  for (const std::uint8_t b : head) {
    if (b < 0x20 && b != '\n' && b != '\r' && b != '\t' && b != '\f' && b != 0x1B && b != 0x1A && b != 0x02 &&
        b != 0x03)
      return false;
    high += b >= 0x7F ? 1 : 0;
  }
  return 10 * high <= head.size();
}

/// The lines of the head that are neither blank nor comment, without terminators; a line that the head cuts
/// is left out.
std::vector<std::string_view> content_lines(Bytes head, std::uint64_t size) {
  std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
  text.remove_prefix(byte_order_mark(text));
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    if (newline == std::string_view::npos && head.size() < size && !lines.empty()) break;
    std::string_view line = text.substr(0, newline);
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
    while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!is_comment(line)) lines.push_back(line);
  }
  return lines;
}

bool unix_stamped(std::string_view line) { return unix_stamp(line).has_value(); }
bool iso_stamped(std::string_view line) {
  const auto stamp = iso_stamp(line);
  return stamp && stamp->length < line.size();
}

FileKind sniff_lines(Bytes head, std::uint64_t size) {
  const auto lines = content_lines(head, size);
  const auto half = [&](auto holds) {
    return !lines.empty() &&
           2 * static_cast<std::size_t>(std::count_if(lines.begin(), lines.end(), holds)) >= lines.size();
  };
  const bool text = is_text(head);
  if (half(unix_stamped)) return FileKind::tlog;
  if (half(iso_stamped)) return FileKind::stamped_text;
  if (text && half(is_waterlinked_serial)) return FileKind::waterlinked_serial;
  if (text && half(is_waterlinked_json)) return FileKind::waterlinked_json;
  if (text && half(is_navquest)) return FileKind::navquest;
  if (text && half(is_paroscientific)) return FileKind::paroscientific;
  if (text && half(looks_like_sentence)) return FileKind::nmea;
  if (!text)
    return std::count_if(lines.begin(), lines.end(), holds_sentence) >= 2 ? FileKind::nmea
                                                                          : FileKind::unknown;
  return is_table(lines) ? FileKind::table : FileKind::text;
}

}  // namespace

const char* name_of(FileKind kind) {
  static constexpr std::array<const char*, 24> kNames = {"empty",
                                                         "tlog",
                                                         "stamped text",
                                                         "nmea",
                                                         "iec61162-450",
                                                         "trdi-pd0",
                                                         "waterlinked-serial",
                                                         "waterlinked-json",
                                                         "navquest",
                                                         "paroscientific",
                                                         "session",
                                                         "sqlite",
                                                         "xtf",
                                                         "jsf",
                                                         "pcap",
                                                         "pcapng",
                                                         "mavlink",
                                                         "nortek-dvl",
                                                         "evologics-usbl",
                                                         "xsens-mtdata2",
                                                         "pni-tcm",
                                                         "table",
                                                         "text",
                                                         "unknown"};
  static_assert(kNames.size() == static_cast<std::size_t>(FileKind::unknown) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<std::uint32_t> sqlite_application_id(Bytes head) {
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  constexpr std::size_t kAt = 68, kHeader = 100;  // sqlite.org/fileformat2.html 1.3
  if (head.size() < kHeader || std::memcmp(head.data(), kMagic.data(), kMagic.size()) != 0)
    return std::nullopt;
  return big32(head, kAt);
}

FileKind sniff(Bytes head, std::uint64_t size) {
  if (size == 0 || head.empty()) return FileKind::empty;
  if (const auto id = sqlite_application_id(head))
    return *id == kSessionApplicationId ? FileKind::session : FileKind::sqlite;
  if (is_pcap(head)) return FileKind::pcap;
  if (is_pcapng(head)) return FileKind::pcapng;
  if (is_xtf(head)) return FileKind::xtf;
  if (is_jsf(head, size)) return FileKind::jsf;
  if (is_udpbc(head)) return FileKind::iec61162_450;
  if (is_mavlink(head)) return FileKind::mavlink;
  if (holds_pd0(head)) return FileKind::trdi_pd0;
  if (holds_nortek(head)) return FileKind::nortek_dvl;
  if (holds_evologics(head)) return FileKind::evologics_usbl;
  if (holds_xsens(head)) return FileKind::xsens_mtdata2;
  if (is_pni(head)) return FileKind::pni_tcm;
  return sniff_lines(head, size);
}

}  // namespace leadline::links
