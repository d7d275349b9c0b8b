#include "plugins/host/guarded_decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/support/decoder_harness.h"

namespace leadline {
namespace {

using test::as_bytes;
using test::Decoded;

/// Telegrams are single letters: "d" a depth, "n" a depth that is no number, "x" an exception, "h" a byte it
/// holds without a report, "l" a report much too long, "w" a raw frame of its own.
class Letters final : public Decoder {
 public:
  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) override {
    for (const auto byte : bytes) {
      const std::string kind = "kind " + std::to_string(++telegrams_);  // dies with this decoder's next
      kind_ = kind;
      if (byte == 'x') throw std::runtime_error("x");
      if (byte == 'h') continue;
      if (byte == 'w') out.fact({}, RawFrame{});
      if (byte == 'n') out.fact({}, DepthMeasured{.depth = {std::numeric_limits<double>::quiet_NaN()}});
      if (byte == 'd') out.fact({}, DepthMeasured{.depth = {5.0}});
      out.frame({.kind = kind_, .offset = offset_++, .length = byte == 'l' ? 4'000'000'000u : 1u});
    }
  }
  void finish(DecoderOutput&) override {}

 private:
  int telegrams_ = 0;
  std::uint64_t offset_ = 0;
  std::string kind_;
};

DecoderMaker letters() {
  return []() -> Result<std::unique_ptr<Decoder>> {
    return std::unique_ptr<Decoder>(std::make_unique<Letters>());
  };
}

/// Each byte in exactly one report, in order.
void expect_accounted(const Decoded& decoded, std::uint64_t bytes) {
  std::uint64_t next = 0;
  for (const auto& frame : decoded.frames) {
    EXPECT_EQ(frame.offset, next);
    next += frame.length;
  }
  EXPECT_EQ(next, bytes);
}

TEST(GuardedDecoder, PassesAHealthyOneThrough) {
  GuardedDecoder decoder(letters()().value(), letters());
  const auto decoded = test::decode_all(decoder, as_bytes("ddd"), {}, 1);
  EXPECT_EQ(decoded.all<DepthMeasured>().size(), 3u);
  expect_accounted(decoded, 3);
  EXPECT_EQ(decoded.frames[1].kind, "kind 2");
}

TEST(GuardedDecoder, AnExceptionCostsTheBytesItHeldAndNoMore) {
  GuardedDecoder decoder(letters()().value(), letters());
  Decoded decoded;
  for (const auto* chunk : {"dd", "hhd", "dxd", "dd"}) decoder.feed(as_bytes(chunk), {}, decoded);
  decoder.finish(decoded);
  expect_accounted(decoded, 10);
  EXPECT_EQ(decoded.all<DepthMeasured>().size(), 6u);
  ASSERT_EQ(decoded.ledger.refusals().size(), 1u);
  EXPECT_EQ(decoded.ledger.refusals()[0].name, "plugin");
  EXPECT_EQ(decoded.frames.back().kind, "kind 2") << "made anew: it counts from the start";
}

TEST(GuardedDecoder, WordsOutliveTheDecoderAndAreFew) {
  Decoded decoded;
  {
    GuardedDecoder decoder(letters()().value(), letters());
    decoded = test::decode_all(decoder, as_bytes(std::string(100, 'd')));
  }
  EXPECT_EQ(decoded.frames[1].kind, "kind 2");
  EXPECT_EQ(decoded.frames[99].kind, "other");
  EXPECT_EQ(decoded.ledger.kinds().size(), 65u);
}

TEST(GuardedDecoder, WhatItNeverReportsIsRefusedAtTheEnd) {
  GuardedDecoder decoder(letters()().value(), letters());
  const auto decoded = test::decode_all(decoder, as_bytes("dhh"));
  expect_accounted(decoded, 3);
  EXPECT_EQ(decoded.frames.back().reason, "plugin");
}

TEST(GuardedDecoder, CannotReportMoreThanItWasGiven) {
  GuardedDecoder decoder(letters()().value(), letters());
  expect_accounted(test::decode_all(decoder, as_bytes("dldd")), 4);
}

TEST(GuardedDecoder, AFactThatCannotBeIsDroppedAndItsTelegramRefused) {
  GuardedDecoder decoder(letters()().value(), letters());
  const auto decoded = test::decode_all(decoder, as_bytes("dnwd"));
  expect_accounted(decoded, 4);
  EXPECT_EQ(decoded.facts.size(), 2u);
  ASSERT_EQ(decoded.frames.size(), 4u);
  for (const std::size_t i : {1u, 2u}) {
    EXPECT_EQ(decoded.frames[i].byte_class, ByteClass::refused);
    EXPECT_EQ(decoded.frames[i].reason, "plugin");
  }
  EXPECT_EQ(decoded.frames[3].byte_class, ByteClass::decoded);
}

TEST(GuardedDecoder, ThatCannotBeMadeAnewHasAllFurtherBytesRefused) {
  GuardedDecoder decoder(letters()().value(), []() -> Result<std::unique_ptr<Decoder>> { throw 1; });
  Decoded decoded;
  for (const auto* chunk : {"dx", "dd", "d"}) decoder.feed(as_bytes(chunk), {}, decoded);
  decoder.finish(decoded);
  expect_accounted(decoded, 5);
  EXPECT_EQ(decoded.all<DepthMeasured>().size(), 1u);
  EXPECT_EQ(decoded.ledger.bytes(ByteClass::refused), 4u);
}

}  // namespace
}  // namespace leadline
