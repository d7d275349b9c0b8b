#pragma once

#include <array>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/flow/engine.h"

namespace leadline::ui {

/// One line of what a source said, fit to be shown: `text` is printable ASCII, any other byte of a line is
/// "‹0D›", and what is no text is hex, "7F 7F 06".
struct RawLine {
  Arrival arrival;  ///< of its first byte, or of what that came with
  std::string text;
  std::string refusal;      ///< the reason; empty: it was not refused
  std::string sender;       ///< "ADDRESS:PORT", where the link tells
  std::uint32_t bytes = 0;  ///< its end of line included
  bool binary = false;
  bool operator==(const RawLine&) const = default;
};

/// The end of the Bus that a raw monitor looks at: of each source the newest telegrams, 200 of at most 64 KiB
/// together. take() is called by the core thread, the rest by any; a reader costs the core the time of one
/// copy at most, and never memory. Pieces of a stream that follow one another closely are one telegram, up to
/// the end of its line or 1 KiB; what names its sender came whole and is never joined.
class RawTail final : public Sink {
 public:
  static constexpr std::size_t kTelegrams = 200, kBytes = 64 * 1024;

  /// From the first message of a run, for the sources of its configuration.
  explicit RawTail(std::size_t sources);

  void take(const Envelope& envelope) override;

  /// The newest 200 at most, oldest first. Of a source that is not configured: none.
  [[nodiscard]] std::vector<RawLine> lines(SourceId source, bool refused_only) const;
  /// Of all sources of one link, in order of arrival. What several of them were handed is there once.
  [[nodiscard]] std::vector<RawLine> lines(std::span<const SourceId> sources, bool refused_only) const;
  /// What was heard so far is not shown any more.
  void clear(SourceId source);

 private:
  /// The newest N of a kind, without memory of its own to ask for.
  template <class T, std::size_t N>
  struct Newest {
    std::array<T, N> kept{};
    std::uint64_t count = 0;
    void push(const T& value) { kept[count++ % N] = value; }
    [[nodiscard]] std::size_t size() const { return count < N ? static_cast<std::size_t>(count) : N; }
    [[nodiscard]] T& back() { return kept[(count - 1) % N]; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return kept[(count - size() + i) % N]; }
  };
  /// Bytes of a source's stream, counted from its first one.
  struct Stretch {
    std::uint64_t from = 0, until = 0;
  };
  struct Telegram {
    Stretch at;
    Arrival first, last;
    SenderName sender;
  };
  struct Refusal {
    Stretch at;
    Text<24> reason;
  };
  struct Said {
    std::vector<std::uint8_t> bytes =
        std::vector<std::uint8_t>(kBytes);  // the newest, by place modulo kBytes
    std::uint64_t heard = 0, cleared = 0;   // places in the stream
    Newest<Telegram, kTelegrams> telegrams;
    Newest<Refusal, kTelegrams> refusals;
    std::uint64_t unfed = 0;  // bytes of frames refused as a whole, which no decoder counted
    std::uint64_t raw = 0;    // seq of the newest frame
    Stretch frame;            // its place
    bool whole = false;       // its sender is known
  };

  static void hear(Said& said, const Envelope& envelope, const RawFrame& frame);
  static void refuse(Said& said, const Envelope& envelope, const Rejected& rejected);
  [[nodiscard]] std::vector<RawLine> all_lines(SourceId source) const;
  static void split(const Said& said, const Telegram& telegram, std::vector<RawLine>& lines);
  static std::string refusal_of(const Said& said, const Stretch& at);

  mutable std::mutex mutex_;
  std::vector<Said> said_;  // guarded
};

}  // namespace leadline::ui
