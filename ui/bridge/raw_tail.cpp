#include "ui/bridge/raw_tail.h"

#include <algorithm>
#include <iterator>

namespace leadline::ui {
namespace {

constexpr std::size_t kLongestJoined = 1024;
/// Pieces of one telegram follow one another faster, the telegrams of an instrument slower.
constexpr Duration kPause = std::chrono::milliseconds(100);

bool printable(std::uint8_t byte) { return byte >= 0x20 && byte <= 0x7E; }

/// Three quarters of it can be read: a sentence with a few bytes torn is a sentence still.
bool is_text(std::span<const std::uint8_t> bytes) {
  const auto readable = std::ranges::count_if(
      bytes, [](std::uint8_t b) { return printable(b) || b == '\r' || b == '\n' || b == '\t'; });
  return 4 * static_cast<std::size_t>(readable) >= 3 * bytes.size();
}

void write_hex(std::uint8_t byte, std::string& text) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  text += kDigits[byte >> 4];
  text += kDigits[byte & 15];
}

std::string hex_of(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve(3 * bytes.size());
  for (const std::uint8_t byte : bytes) {
    if (!text.empty()) text += ' ';
    write_hex(byte, text);
  }
  return text;
}

/// Without the end of line.
std::string text_of(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty() && (bytes.back() == '\r' || bytes.back() == '\n'))
    bytes = bytes.first(bytes.size() - 1);
  std::string text;
  text.reserve(bytes.size());
  for (const std::uint8_t byte : bytes) {
    if (printable(byte)) {
      text += static_cast<char>(byte);
      continue;
    }
    text += "‹";
    write_hex(byte, text);
    text += "›";
  }
  return text;
}

/// How long the first line is: up to LF, or a CR that no LF follows.
std::size_t line_length(std::span<const std::uint8_t> bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (bytes[i] == '\n' || (bytes[i] == '\r' && i + 1 < bytes.size() && bytes[i + 1] != '\n')) return i + 1;
  return bytes.size();
}

std::vector<RawLine> newest(std::vector<RawLine> lines, bool refused_only) {
  if (refused_only) std::erase_if(lines, [](const RawLine& line) { return line.refusal.empty(); });
  if (lines.size() > RawTail::kTelegrams)
    lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(RawTail::kTelegrams));
  return lines;
}

}  // namespace

RawTail::RawTail(std::size_t sources) : said_(sources) {}

void RawTail::take(const Envelope& envelope) {
  if (envelope.source >= said_.size()) return;
  if (const auto* frame = std::get_if<RawFrame>(&envelope.message)) {
    const std::lock_guard lock(mutex_);
    hear(said_[envelope.source], envelope, *frame);
  } else if (const auto* rejected = std::get_if<Rejected>(&envelope.message)) {
    const std::lock_guard lock(mutex_);
    refuse(said_[envelope.source], envelope, *rejected);
  }
}

void RawTail::hear(Said& said, const Envelope& envelope, const RawFrame& frame) {
  if (frame.bytes.empty()) return;
  said.raw = envelope.seq;
  said.frame = {said.heard, said.heard + frame.bytes.size()};
  said.whole = !frame.sender.empty();
  // Of a frame longer than everything that is kept: its end.
  const std::size_t kept = std::min(frame.bytes.size(), kBytes);
  const std::uint64_t from = said.frame.until - kept;
  const auto bytes = frame.bytes.last(kept);
  const auto at = static_cast<std::size_t>(from % kBytes);
  const std::size_t straight = std::min(kept, kBytes - at);

  const bool goes_on = said.telegrams.size() > 0 && !said.whole && [&] {
    const Telegram& open = said.telegrams.back();
    return open.sender.empty() && said.bytes[static_cast<std::size_t>((said.heard - 1) % kBytes)] != '\n' &&
           envelope.arrival - open.last <= kPause && from == open.at.until && open.at.from >= said.cleared &&
           said.frame.until - open.at.from <= kLongestJoined;
  }();
  std::copy_n(bytes.begin(), straight, said.bytes.begin() + static_cast<std::ptrdiff_t>(at));
  std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(straight), bytes.end(), said.bytes.begin());
  said.heard = said.frame.until;
  if (goes_on) {
    said.telegrams.back().at.until = said.heard;
    said.telegrams.back().last = envelope.arrival;
  } else {
    said.telegrams.push({{from, said.heard}, envelope.arrival, envelope.arrival, frame.sender});
  }
}

void RawTail::refuse(Said& said, const Envelope& envelope, const Rejected& rejected) {
  if (said.telegrams.size() == 0 || envelope.raw != said.raw) return;  // of bytes that were not heard here
  const std::uint64_t length = said.frame.until - said.frame.from;
  Stretch at{said.unfed + rejected.offset, said.unfed + rejected.offset + rejected.length};
  // A frame that was refused before any decoder saw it is told with the offset 0.
  const bool unfed = rejected.offset == 0 && rejected.length == length && said.frame.from > said.unfed;
  if (unfed) said.unfed += length;
  // Otherwise a decoder counts its source's bytes as they are counted here; one that counts each sender's for
  // itself is told by stretches that cannot be: then it is the frame that made it speak.
  const std::uint64_t earliest = said.whole ? said.frame.from : said.telegrams[0].at.from;
  if (unfed || rejected.length == 0 || at.from < earliest || at.until > said.frame.until) at = said.frame;
  said.refusals.push({at, rejected.reason});
}

void RawTail::clear(SourceId source) {
  const std::lock_guard lock(mutex_);
  if (source < said_.size()) said_[source].cleared = said_[source].heard;
}

std::string RawTail::refusal_of(const Said& said, const Stretch& at) {
  for (std::size_t i = said.refusals.size(); i-- > 0;) {
    const Refusal& refusal = said.refusals[i];
    if (refusal.at.from < at.until && at.from < refusal.at.until) return std::string(refusal.reason.view());
  }
  return {};
}

void RawTail::split(const Said& said, const Telegram& telegram, std::vector<RawLine>& lines) {
  std::vector<std::uint8_t> copy(static_cast<std::size_t>(telegram.at.until - telegram.at.from));
  for (std::size_t i = 0; i < copy.size(); ++i)
    copy[i] = said.bytes[static_cast<std::size_t>((telegram.at.from + i) % kBytes)];
  std::span<const std::uint8_t> rest(copy);
  const bool binary = !is_text(rest);
  for (std::uint64_t from = telegram.at.from; !rest.empty();) {
    const std::size_t length = binary ? rest.size() : line_length(rest);
    RawLine line;
    line.arrival = telegram.first;
    line.text = binary ? hex_of(rest) : text_of(rest.first(length));
    line.refusal = refusal_of(said, {from, from + length});
    line.sender = std::string(telegram.sender.view());
    line.bytes = static_cast<std::uint32_t>(length);
    line.binary = binary;
    if (!line.text.empty() || !line.refusal.empty()) lines.push_back(std::move(line));
    from += length;
    rest = rest.subspan(length);
  }
}

std::vector<RawLine> RawTail::all_lines(SourceId source) const {
  std::unique_lock lock(mutex_);
  if (source >= said_.size()) return {};
  const Said said = said_[source];
  lock.unlock();
  std::vector<RawLine> lines;
  for (std::size_t i = 0; i < said.telegrams.size(); ++i) {
    const Telegram& telegram = said.telegrams[i];
    if (telegram.at.from + kBytes >= said.heard && telegram.at.from >= said.cleared)
      split(said, telegram, lines);
  }
  return lines;
}

std::vector<RawLine> RawTail::lines(SourceId source, bool refused_only) const {
  return newest(all_lines(source), refused_only);
}

std::vector<RawLine> RawTail::lines(std::span<const SourceId> sources, bool refused_only) const {
  std::vector<RawLine> lines;
  for (const SourceId source : sources) {
    std::vector<RawLine> more = all_lines(source), merged;
    merged.reserve(lines.size() + more.size());
    const auto twin = [&](const RawLine& line) {
      return std::ranges::find_if(lines, [&](const RawLine& other) {
        return other.arrival == line.arrival && other.sender == line.sender && other.text == line.text;
      });
    };
    std::erase_if(more, [&](RawLine& line) {
      const auto same = twin(line);
      if (same == lines.end()) return false;
      if (same->refusal.empty()) same->refusal = std::move(line.refusal);
      return true;
    });
    std::ranges::merge(std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end()),
                       std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()),
                       std::back_inserter(merged),
                       [](const RawLine& a, const RawLine& b) { return a.arrival < b.arrival; });
    lines = std::move(merged);
  }
  return newest(std::move(lines), refused_only);
}

}  // namespace leadline::ui
