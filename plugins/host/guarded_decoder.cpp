#include "plugins/host/guarded_decoder.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <set>
#include <string>

#include "plugins/host/message_faults.h"

namespace leadline {
namespace {

constexpr std::string_view kReason = "plugin";

/// Accounts keep views of these words when the decoder, made anew, is long gone; those of the decoders linked
/// in are literals.
std::string_view kept_for_good(std::string_view text) {
  static std::mutex mutex;
  static auto& words = *new std::set<std::string, std::less<>>;
  const std::lock_guard lock(mutex);
  return *words.emplace(text).first;
}

}  // namespace

GuardedDecoder::GuardedDecoder(std::unique_ptr<Decoder> decoder, DecoderMaker maker)
    : decoder_(std::move(decoder)), maker_(std::move(maker)) {}

template <class Call>
void GuardedDecoder::guarded(DecoderOutput& out, Call call) {
  out_ = &out;
  try {
    if (decoder_)
      call(*decoder_);
    else
      refuse_pending();
  } catch (...) {
    refuse_pending();
    bad_fact_ = false;
    try {
      decoder_.reset();
      auto made = maker_();
      if (made) decoder_ = std::move(made).value();
    } catch (...) {  // it stays away
    }
  }
}

void GuardedDecoder::sender(std::string_view name) {
  try {
    if (decoder_) decoder_->sender(name);
  } catch (...) {  // it holds no bytes of it: what it missed is its own loss
  }
}

void GuardedDecoder::feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
                          DecoderOutput& out) {
  fed_ += bytes.size();
  guarded(out, [&](Decoder& decoder) { decoder.feed(bytes, arrival, *this); });
}

void GuardedDecoder::finish(DecoderOutput& out) {
  guarded(out, [&](Decoder& decoder) { decoder.finish(*this); });
  refuse_pending();  // what it forgot
}

void GuardedDecoder::fact(std::optional<Time> device_time, const Message& message) {
  if (fault_of_decoder(message).empty())
    out_->fact(device_time, message);
  else
    bad_fact_ = true;
}

void GuardedDecoder::frame(const FrameReport& report) {
  FrameReport passed = report;
  passed.offset = reported_;
  passed.length = static_cast<std::uint32_t>(std::min<std::uint64_t>(report.length, fed_ - reported_));
  passed.kind = kept(report.kind);
  passed.reason = kept(report.reason);
  if (bad_fact_ || report.byte_class > ByteClass::skipped || report.checksum > ChecksumState::absent) {
    passed.byte_class = ByteClass::refused;
    passed.checksum = ChecksumState::none;
    passed.reason = kReason;
  }
  if (!report.block) bad_fact_ = false;
  reported_ += passed.length;
  out_->frame(passed);
}

void GuardedDecoder::refuse_pending() {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  while (reported_ < fed_) {
    const auto length = static_cast<std::uint32_t>(std::min(fed_ - reported_, kMost));
    out_->frame({.byte_class = ByteClass::refused, .reason = kReason, .offset = reported_, .length = length});
    reported_ += length;
  }
}

/// The same text for as long as the program runs; beyond 64 different words, "other".
std::string_view GuardedDecoder::kept(std::string_view text) {
  text = text.substr(0, 24);
  if (text.empty()) return {};
  for (auto& word : words_) {
    if (word.empty()) return word = kept_for_good(text);
    if (word == text) return word;
  }
  return "other";
}

}  // namespace leadline
