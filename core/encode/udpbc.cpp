#include "core/encode/udpbc.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/types/expect.h"

namespace leadline::encode {
namespace {

constexpr std::string_view kHeader("UdPbC\0", 6);
constexpr std::uint16_t kCounts = 1000, kLastGroup = 99;

}  // namespace

void Udpbc::wrap(const Telegrams& sentences, Telegrams& datagrams) {
  const bool grouped = sentences.size() > 1;
  if (grouped) group_ = static_cast<std::uint16_t>(group_ % kLastGroup + 1);
  std::size_t begin = datagrams.bytes.size();
  for (std::size_t i = 0; i < sentences.size(); ++i) {
    line_.clear();
    auto line = std::back_inserter(line_);
    if (grouped) fmt::format_to(line, "g:{}-{}-{},", i + 1, sentences.size(), group_);
    fmt::format_to(line, "s:{},", source_);
    if (!destination_.empty()) fmt::format_to(line, "d:{},", destination_);
    fmt::format_to(line, "n:{}", count_);
    count_ = static_cast<std::uint16_t>((count_ + 1) % kCounts);
    std::uint8_t sum = 0;
    for (const char c : line_) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));

    const std::size_t size = line_.size() + 5 + sentences[i].size();  // two backslashes, the checksum
    LL_EXPECT(kHeader.size() + size <= kLongestDatagram);
    if (datagrams.bytes.size() > begin && datagrams.bytes.size() - begin + size > kLongestDatagram) {
      datagrams.end();
      begin = datagrams.bytes.size();
    }
    if (datagrams.bytes.size() == begin) datagrams.bytes.append(kHeader);
    fmt::format_to(std::back_inserter(datagrams.bytes), "\\{}*{:02X}\\{}", line_, sum, sentences[i]);
  }
  if (datagrams.bytes.size() > begin) datagrams.end();
}

bool good_sfi(std::string_view text) {
  return text.size() == 6 && text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'A' && text[1] <= 'Z' &&
         std::all_of(text.begin() + 2, text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace leadline::encode
