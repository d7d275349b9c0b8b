#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/messages/message.h"

namespace leadline::ui {

/// Who says messages of one kind; the engine counts where the kind has one.
struct KindSpeaker {
  std::uint8_t kind = 0;
  EngineId engine = 0;
  SourceId source = kNoSource;
  auto operator<=>(const KindSpeaker&) const = default;
};
[[nodiscard]] KindSpeaker speaker_of(const Envelope& envelope);

/// When each speaker of a run spoke last before any block of 1024 numbers, and how often until then: so that
/// a source that fell silent hours ago is found without reading those hours. 12 bytes a speaker and block.
class SpeakerIndex {
 public:
  static constexpr std::uint64_t kBlock = 1024;
  /// The last number not behind `seq` where a block begins; at least 1.
  [[nodiscard]] static constexpr std::uint64_t block_begin(std::uint64_t seq) {
    return seq / kBlock * kBlock == 0 ? 1 : seq / kBlock * kBlock;
  }

  /// In the order of seq.
  void add(const KindSpeaker& speaker, std::uint64_t seq);
  /// Up to this number everything was added.
  [[nodiscard]] std::uint64_t reaches() const { return reaches_; }
  void reached(std::uint64_t seq) { reaches_ = seq; }

  struct Last {
    KindSpeaker speaker;
    std::uint64_t seq;    ///< of its last message
    std::uint64_t count;  ///< of its messages so far
  };
  /// Everybody who spoke before `seq`, which begins a block.
  [[nodiscard]] std::vector<Last> before(std::uint64_t seq) const;

 private:
  struct Line {
    std::uint64_t first_block = 0;
    std::vector<std::uint64_t> last;   // at the end of each block from first_block on
    std::vector<std::uint32_t> count;  // likewise
  };
  std::map<KindSpeaker, Line> lines_;
  std::uint64_t reaches_ = 0;
};

}  // namespace leadline::ui
