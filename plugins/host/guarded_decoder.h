#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "core/flow/decoder.h"
#include "core/types/result.h"

namespace leadline {

using DecoderMaker = std::function<Result<std::unique_ptr<Decoder>>()>;

/// A third party's decoder on the core thread. When it throws, the bytes it held are refused ("plugin") and
/// it is made anew; when that fails too, all further bytes are refused. A fact that it must not say
/// (fault_of_decoder) is dropped and its telegram refused. Whatever it reports, each byte is in exactly one
/// report. It is not watched for time.
class GuardedDecoder final : public Decoder, private DecoderOutput {
 public:
  GuardedDecoder(std::unique_ptr<Decoder> decoder, DecoderMaker maker);

  void sender(std::string_view name) override;
  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival, DecoderOutput& out) override;
  void finish(DecoderOutput& out) override;

 private:
  void fact(std::optional<Time> device_time, const Message& message) override;
  void frame(const FrameReport& report) override;
  template <class Call>
  void guarded(DecoderOutput& out, Call call);
  void refuse_pending();
  std::string_view kept(std::string_view text);

  std::unique_ptr<Decoder> decoder_;
  DecoderMaker maker_;
  DecoderOutput* out_ = nullptr;
  std::uint64_t fed_ = 0, reported_ = 0;
  bool bad_fact_ = false;
  std::array<std::string_view, 64> words_;
};

}  // namespace leadline
