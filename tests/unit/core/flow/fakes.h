#pragma once

// A decoder, an engine and a sink small enough to know by heart.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/flow/bus.h"
#include "tests/support/decoder_harness.h"

namespace leadline::test {

/// Each byte is a telegram: a digit n is a depth of n m, 't' the same with a device time, 'x' is refused, 'u'
/// is unknown, '_' is skipped. A 'p' is held back until finish().
class LetterDecoder final : public Decoder {
 public:
  explicit LetterDecoder(std::optional<Time> device_time = {}) : device_time_(device_time) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) override {
    for (const std::uint8_t c : bytes) {
      const std::uint64_t offset = offset_++;
      if (c == 'p') {
        ++pending_;
      } else if (c == 'x') {
        out.frame({ByteClass::refused, ChecksumState::bad, "letter", "checksum", offset, 1});
      } else if (c == 'u') {
        out.frame({ByteClass::unknown, ChecksumState::ok, "strange", "", offset, 1});
      } else if (c == '_') {
        out.frame({ByteClass::skipped, ChecksumState::none, "", "", offset, 1});
      } else {
        out.fact(c == 't' ? device_time_ : std::nullopt,
                 DepthMeasured{Depth{static_cast<double>(c - '0')}, {}});
        out.frame({ByteClass::decoded, ChecksumState::ok, "letter", "", offset, 1});
      }
    }
  }
  void finish(DecoderOutput& out) override {
    for (; pending_ > 0; --pending_) {
      out.fact({}, DepthMeasured{});
      out.frame({ByteClass::decoded, ChecksumState::ok, "letter", "", offset_ - 1, 1});
    }
  }

 private:
  std::optional<Time> device_time_;
  std::uint64_t offset_ = 0;
  int pending_ = 0;
};

/// Answers each depth with a mode change and a solution.
class EchoEngine final : public Engine {
 public:
  explicit EchoEngine(EngineId id) : id_(id) {}
  void take(const Envelope& envelope, EngineOutput& out) override {
    heard.push_back(envelope.seq);
    if (!std::holds_alternative<DepthMeasured>(envelope.message)) return;
    ModeChange change;
    change.engine = id_;
    out.publish(envelope.valid, change);
    Solution solution;
    solution.engine = id_;
    out.publish(envelope.valid, solution, envelope.source);
  }
  std::vector<std::uint64_t> heard;

 private:
  EngineId id_;
};

/// Keeps every envelope, and each raw frame's bytes, which live only during take().
class KeepingSink final : public Sink {
 public:
  void take(const Envelope& envelope) override {
    std::string bytes;
    if (const auto* raw = std::get_if<RawFrame>(&envelope.message))
      bytes.assign(raw->bytes.begin(), raw->bytes.end());
    all.push_back(envelope);
    all.back().message =
        std::holds_alternative<RawFrame>(envelope.message) ? Message{RawFrame{}} : envelope.message;
    raw_bytes.push_back(bytes);
    kinds += letter(envelope.message);
  }
  template <class T>
  [[nodiscard]] std::vector<Envelope> of() const {
    std::vector<Envelope> found;
    for (const auto& e : all)
      if (std::holds_alternative<T>(e.message)) found.push_back(e);
    return found;
  }
  std::vector<Envelope> all;
  std::vector<std::string> raw_bytes;
  std::string kinds;  ///< R raw, D depth, M mode change, S solution, T tick, X rejected

 private:
  static char letter(const Message& m) {
    if (std::holds_alternative<RawFrame>(m)) return 'R';
    if (std::holds_alternative<DepthMeasured>(m)) return 'D';
    if (std::holds_alternative<ModeChange>(m)) return 'M';
    if (std::holds_alternative<Solution>(m)) return 'S';
    if (std::holds_alternative<Tick>(m)) return 'T';
    if (std::holds_alternative<Rejected>(m)) return 'X';
    return '?';
  }
};

inline Arrival ms(std::int64_t value) { return {value * 1'000'000}; }

inline Chunk chunk(SourceId source, Arrival arrival, std::string_view text) {
  Chunk c;
  c.source = source;
  c.arrival = arrival;
  c.bytes = as_bytes(text);
  return c;
}

inline std::vector<SourceInfo> two_sources() {
  std::vector<SourceInfo> sources(2);
  sources[0].id = 0, sources[0].name = "dvl";
  sources[1].id = 1, sources[1].name = "depth";
  return sources;
}

}  // namespace leadline::test
