#include "core/decode/frame_search.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/core/decode/decoder_laws.h"

namespace leadline::decode {
namespace {

/// Frames `<n...>`: n digits, as told by the digit behind '<'; an 'x' among them breaks one.
class Brackets final : public FrameFormat {
 public:
  FrameStart start(std::span<const std::uint8_t> b, bool) const override {
    using Is = FrameStart::Is;
    if (b[0] != '<') return {};
    if (b.size() < 2) return {Is::unsettled, 0, {}, {}};
    if (b[1] < '0' || b[1] > '9') return {};
    const std::size_t whole = 3u + (b[1] - '0');
    if (b.size() < whole) return {Is::unsettled, 0, "bracket", {}};
    if (b[whole - 1] != '>') return {Is::broken, whole, "bracket", "checksum"};
    return {Is::frame, whole, "bracket", {}};
  }
  void frame(std::uint64_t offset, std::span<const std::uint8_t> bytes, const FrameStart&) override {
    say("frame", offset, bytes.size());
  }
  void lost(const FrameReport& r) override {
    say(r.byte_class == ByteClass::skipped ? "skipped" : std::string(r.reason), r.offset, r.length);
  }
  std::string said;

 private:
  void say(const std::string& what, std::uint64_t offset, std::size_t length) {
    said += what + " " + std::to_string(offset) + "+" + std::to_string(length) + "; ";
  }
};

std::string search(const std::string& text, std::size_t chunk, std::size_t window = 16) {
  Brackets brackets;
  FrameSearch search(brackets, window);
  const auto bytes = test::as_bytes(text);
  for (std::size_t i = 0; i < bytes.size(); i += chunk)
    search.feed(bytes.subspan(i, std::min(chunk, bytes.size() - i)));
  search.finish();
  return brackets.said;
}

TEST(FrameSearch, TellsFramesAndWhatLiesBetween) {
  const struct {
    std::string text, said;
  } cases[] = {{"", ""},
               {"<2ab>", "frame 0+5; "},
               {"..<2ab><0>.", "skipped 0+2; frame 2+5; frame 7+3; skipped 10+1; "},
               {"<2abc>", "checksum 0+5; skipped 5+1; "},
               {"<2a<0>", "checksum 0+3; frame 3+3; "},
               {"<5<5<0>....", "checksum 0+4; frame 4+3; skipped 7+4; "},
               {"<5ab", "truncated 0+4; "},
               {"<9ab<0>", "truncated 0+4; frame 4+3; "},
               {"<", "skipped 0+1; "},
               {"<<<0>", "skipped 0+2; frame 2+3; "}};
  for (const auto& c : cases)
    for (std::size_t chunk = 1; chunk <= c.text.size() + 1; ++chunk)
      EXPECT_EQ(search(c.text, chunk), c.said) << c.text << " in chunks of " << chunk;
}

TEST(FrameSearch, AFrameLongerThanTheWindowIsRefusedAndTheNextOneFound) {
  const std::string text = "<9123<0><2ab>";
  EXPECT_EQ(search(text, 3, 8), "too long 0+5; frame 5+3; frame 8+5; ");
  EXPECT_EQ(search(text, 1, 8), search(text, text.size(), 8));
}

TEST(FrameSearch, GoesOnBehindAnEarlyEnd) {
  Brackets brackets;
  FrameSearch search(brackets, 16);
  search.feed(test::as_bytes("<5a"));
  search.finish();
  search.feed(test::as_bytes("bcde><0>"));
  search.finish();
  EXPECT_EQ(brackets.said, "truncated 0+3; skipped 3+5; frame 8+3; ");
}

TEST(FrameSearch, ALongRunIsToldInPieces) {
  EXPECT_EQ(search(std::string(150'000, '.'), 7000),
            "skipped 0+65536; skipped 65536+65536; skipped 131072+18928; ");
}

}  // namespace
}  // namespace leadline::decode
