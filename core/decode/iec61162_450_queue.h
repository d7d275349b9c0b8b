#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/decode/iec61162_450_tag.h"
#include "core/decode/nmea0183_framing.h"
#include "core/flow/decoder.h"

namespace leadline::decode::udpbc {

/// Reports on their way out, in the order of the bytes: one that is not known yet holds up those behind it.
class ReportQueue {
 public:
  using Ticket = std::uint64_t;
  static constexpr std::size_t kMost = 256;

  [[nodiscard]] bool full() const { return end_ - begin_ == kMost; }
  /// Not when full.
  Ticket add(std::uint64_t offset);
  void set_length(Ticket ticket, std::uint32_t length) { at(ticket).report.length = length; }
  /// What became of it; offset, length and lost stay as they are.
  void decide(Ticket ticket, const FrameReport& report);
  void set_lost(Ticket ticket, std::uint32_t lost) { at(ticket).report.lost = lost; }
  /// Hands on what is decided and has its length.
  void hand_on(DecoderOutput& out);

 private:
  struct Waiting {
    FrameReport report;
    bool decided = false;
  };
  Waiting& at(Ticket ticket) { return ring_[ticket % kMost]; }

  std::array<Waiting, kMost> ring_;
  Ticket begin_ = 0, end_ = 0;
};

/// One group of lines that is not whole yet: their sentences wait here.
struct Group {
  static constexpr std::size_t kMostLines = 16;
  struct Line {
    bool here = false;
    ReportQueue::Ticket ticket = 0;
    std::uint32_t size = 0;
    std::array<char, nmea0183::kLongestSentence> text;
    [[nodiscard]] std::string_view sentence() const { return {text.data(), size}; }
  };

  bool open = false;
  SenderName sender;
  std::uint32_t id = 0, total = 0, received = 0;
  Text<15> source;
  std::optional<Time> time;
  std::optional<Arrival> begun;
  std::uint64_t turn = 0;
  std::array<Line, kMostLines> lines;

  /// Is it the one, open or not, that a line of this tag belongs to?
  [[nodiscard]] bool is(const SenderName& from, const Tag& tag) const;
};

}  // namespace leadline::decode::udpbc
