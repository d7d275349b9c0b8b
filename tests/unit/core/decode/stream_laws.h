#pragma once

// What holds of every decoder whatever the bytes: each is reported once, in order, and however the stream is
// cut the same comes out.

#include <gtest/gtest.h>

#include <string>

#include "tests/support/decoder_harness.h"
#include "tests/unit/core/decode/decoder_laws.h"

namespace leadline::test {

inline constexpr Arrival kHeard{1'795'350'919'600'000'000};  // 2026-11-22T12:35:19.6Z

/// Kind and what became of it, of each report: "wrz -wru wru!checksum ?text skipped".
inline std::string classes(const Decoded& d) {
  std::string text;
  for (const FrameReport& f : d.frames) {
    if (!text.empty()) text += ' ';
    if (f.byte_class == ByteClass::skipped) text += "skipped";
    if (f.byte_class == ByteClass::comment) text += "comment";
    if (f.byte_class == ByteClass::unused) text += '-';
    if (f.byte_class == ByteClass::unknown) text += '?';
    text += f.kind;
    if (f.byte_class == ByteClass::refused) text += "!" + std::string(f.reason);
  }
  return text;
}

/// Every split in two, several chunk sizes, every prefix, and every byte changed in five ways.
inline void expect_stream_laws(const DecoderMaker& make, const std::string& text) {
  const Decoded whole = decode_all(*make(), as_bytes(text), kHeard);
  ASSERT_TRUE(covers(whole, text.size()));
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    const auto decoder = make();
    Decoded parts;
    decoder->feed(as_bytes(std::string_view(text).substr(0, cut)), kHeard, parts);
    decoder->feed(as_bytes(std::string_view(text).substr(cut)), kHeard, parts);
    decoder->finish(parts);
    ASSERT_TRUE(same(whole, parts)) << "cut at " << cut;
  }
  for (const std::size_t chunk : {1, 2, 3, 7, 64, 257})
    ASSERT_TRUE(same(whole, decode_all(*make(), as_bytes(text), kHeard, chunk))) << "chunks of " << chunk;
  for (std::size_t size = 0; size < text.size(); ++size)
    ASSERT_TRUE(covers(decode_all(*make(), as_bytes(std::string_view(text).substr(0, size)), kHeard), size))
        << "prefix of " << size;
  for (std::size_t at = 0; at < text.size(); ++at)
    for (const char change : {'\0', '\n', '9', ',', static_cast<char>(text[at] ^ 0x80)}) {
      std::string changed = text;
      changed[at] = change;
      ASSERT_TRUE(covers(decode_all(*make(), as_bytes(changed), kHeard), changed.size()))
          << "byte " << at << " is " << static_cast<int>(change);
    }
}

}  // namespace leadline::test
