#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/flow/decoder.h"

namespace leadline::decode::udpbc {

/// Who speaks under which source name (SFI): counts what was lost by n, knows what was heard already, and
/// tells of two senders under one name. Remembers the 64 newest speakers and the 128 newest lines.
class SourceBook {
 public:
  struct Verdict {
    bool duplicate = false;
    std::uint32_t lost = 0;  ///< lines just before this one
  };
  /// One sound line. Tells losses (at most every 10 s a speaker) as Health, two senders of a source as Alarm
  /// (once while it lasts).
  Verdict hear(const SenderName& sender, std::string_view source, std::optional<std::uint16_t> count,
               std::string_view sentence, std::optional<Arrival> arrival, DecoderOutput& out);

 private:
  struct Speaker {
    SenderName sender;
    Text<15> source;
    std::optional<std::uint16_t> count;
    std::uint64_t turn = 0;  // of its newest line
    std::optional<Arrival> heard, told, alarmed;
    std::uint64_t lost = 0, lost_untold = 0;
  };
  struct Line {
    std::uint64_t fingerprint = 0;
    std::optional<Arrival> heard;
  };

  Speaker& speaker(const SenderName& sender, std::string_view source);
  bool heard_already(std::string_view source, std::uint16_t count, std::string_view sentence,
                     std::optional<Arrival> arrival);
  std::uint32_t count_losses(Speaker& me, std::uint16_t count, std::optional<Arrival> arrival,
                             DecoderOutput& out);
  void check_alone(Speaker& me, Arrival arrival, DecoderOutput& out);

  std::array<Speaker, 64> speakers_;
  std::size_t speaker_count_ = 0;
  std::array<Line, 128> lines_;
  std::size_t next_line_ = 0;
  std::uint64_t turn_ = 0;
};

}  // namespace leadline::decode::udpbc
