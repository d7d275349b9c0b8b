#include "core/links/sniff_instruments.h"

#include <algorithm>
#include <string_view>

namespace leadline::links {
namespace {

using Bytes = std::span<const std::uint8_t>;

std::size_t big16(Bytes b, std::size_t at) { return static_cast<std::size_t>(b[at] << 8 | b[at + 1]); }
std::size_t little16(Bytes b, std::size_t at) { return static_cast<std::size_t>(b[at] | b[at + 1] << 8); }
std::string_view text_of(Bytes b) { return {reinterpret_cast<const char*>(b.data()), b.size()}; }

/// An AD2CP header whose own checksum holds.
bool is_nortek_header(Bytes b) {
  constexpr std::size_t kHeader = 10;
  if (b.size() < kHeader || b[0] != 0xA5 || b[1] != kHeader || b[3] != 0x10) return false;
  std::size_t sum = 0xB58C;
  for (std::size_t i = 0; i < 8; i += 2) sum += little16(b, i);
  return (sum & 0xFFFF) == little16(b, 8);
}

/// Sentences of no other maker than Nortek's.
bool speaks_only_pnor(std::string_view text) {
  std::size_t sentences = 0;
  for (std::size_t at = text.find('$'); at != std::string_view::npos; at = text.find('$', at + 1)) {
    const std::string_view address = text.substr(at + 1, 6);
    if (address != "PNORBT" && address != "PNORWT") return false;
    ++sentences;
  }
  return sentences > 0;
}

/// Length of the PNI frame that begins here, its checksum verified; 0: none does.
std::size_t pni_frame(Bytes b) {
  constexpr std::size_t kShortest = 5, kLongest = 512;
  if (b.size() < kShortest) return 0;
  const std::size_t count = big16(b, 0);
  if (count < kShortest || count > kLongest || count > b.size()) return 0;
  unsigned crc = 0;
  for (const std::uint8_t byte : b.first(count - 2)) {
    crc ^= static_cast<unsigned>(byte) << 8;
    for (int bit = 0; bit < 8; ++bit) crc = ((crc & 0x8000) != 0 ? crc << 1 ^ 0x1021 : crc << 1) & 0xFFFF;
  }
  return crc == big16(b, count - 2) ? count : 0;
}

}  // namespace

bool holds_nortek(Bytes head) {
  for (std::size_t at = 0; at + 10 <= head.size(); ++at)
    if (head[at] == 0xA5 && is_nortek_header(head.subspan(at))) return true;
  return speaks_only_pnor(text_of(head));
}

bool holds_xsens(Bytes head) {
  for (std::size_t at = 0; at + 5 <= head.size(); ++at) {
    if (head[at] != 0xFA || head[at + 1] != 0xFF || head[at + 2] != 0x36) continue;
    const bool extended = head[at + 3] == 0xFF;
    if (extended && at + 6 > head.size()) continue;
    const std::size_t begin = at + (extended ? 6 : 4);
    const std::size_t end = begin + (extended ? big16(head, at + 4) : head[at + 3]) + 1;
    if (end > head.size() || end - at > 8192) continue;
    unsigned sum = 0;
    for (const std::uint8_t byte : head.subspan(at + 1, end - at - 1)) sum += byte;
    if ((sum & 0xFF) == 0) return true;
  }
  return false;
}

bool holds_evologics(Bytes head) {
  constexpr std::string_view kPrefix = "+++AT:";
  const std::string_view text = text_of(head);
  int found = 0;
  for (std::size_t at = text.find(kPrefix); at != std::string_view::npos; at = text.find(kPrefix, at + 1)) {
    std::size_t length = 0, i = at + kPrefix.size();
    for (; i < text.size() && i < at + 12 && text[i] >= '0' && text[i] <= '9'; ++i)
      length = length * 10 + static_cast<std::size_t>(text[i] - '0');
    if (i == at + kPrefix.size() || i >= text.size() || text[i] != ':') continue;
    const std::size_t end = i + 1 + length;
    if (!(end <= text.size() && (text.substr(end, 2) == "\r\n" || text.substr(end - 2, 2) == "\r\n")))
      continue;
    if (at == 0 || ++found == 2) return true;  // one in the middle of a text may be a quotation
  }
  return false;
}

bool is_pni(Bytes head) {
  const std::size_t first = pni_frame(head);
  return first != 0 && (first == head.size() || pni_frame(head.subspan(first)) != 0);
}

}  // namespace leadline::links
