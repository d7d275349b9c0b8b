#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/flow/decoder.h"
#include "core/flow/ledger.h"

namespace leadline::test {

/// Everything one decoder said.
struct Decoded final : DecoderOutput {
  struct Fact {
    std::optional<Time> device_time;
    Message message;
    bool operator==(const Fact&) const = default;
  };
  std::vector<Fact> facts;
  std::vector<FrameReport> frames;
  Ledger ledger;

  void fact(std::optional<Time> device_time, const Message& message) override {
    facts.push_back({device_time, message});
  }
  void frame(const FrameReport& report) override {
    frames.push_back(report);
    ledger.count(report, Arrival{});
  }

  template <class T>
  [[nodiscard]] std::vector<T> all() const {
    std::vector<T> found;
    for (const auto& f : facts)
      if (const T* m = std::get_if<T>(&f.message)) found.push_back(*m);
    return found;
  }
  template <class T>
  [[nodiscard]] const Fact* first() const {
    for (const auto& f : facts)
      if (std::holds_alternative<T>(f.message)) return &f;
    return nullptr;
  }
};

inline std::span<const std::uint8_t> as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Feeds `bytes` in chunks of `chunk` bytes (0: at once), then finishes.
inline Decoded decode_all(Decoder& decoder, std::span<const std::uint8_t> bytes,
                          std::optional<Arrival> arrival = {}, std::size_t chunk = 0) {
  Decoded out;
  if (chunk == 0) chunk = std::max<std::size_t>(bytes.size(), 1);
  for (std::size_t i = 0; i < bytes.size(); i += chunk)
    decoder.feed(bytes.subspan(i, std::min(chunk, bytes.size() - i)), arrival, out);
  decoder.finish(out);
  return out;
}

using DecoderMaker = std::function<std::unique_ptr<Decoder>()>;

/// Same facts and same reports?
inline bool same(const Decoded& a, const Decoded& b) {
  return a.facts == b.facts && std::equal(a.frames.begin(), a.frames.end(), b.frames.begin(), b.frames.end(),
                                          [](const FrameReport& x, const FrameReport& y) {
                                            return x.byte_class == y.byte_class && x.checksum == y.checksum &&
                                                   x.kind == y.kind && x.reason == y.reason &&
                                                   x.offset == y.offset && x.length == y.length &&
                                                   x.block == y.block;
                                          });
}

}  // namespace leadline::test
