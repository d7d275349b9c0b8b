#include "core/decode/trdi_pd4_framing.h"

#include <algorithm>
#include <cstring>

#include "core/decode/trdi_pd0_fields.h"
#include "core/decode/trdi_pd0_framing.h"

namespace leadline::decode {
namespace {

constexpr std::uint64_t kLongestRun = 64 * 1024;

}  // namespace

void Pd4Framer::feed(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const std::size_t taken = std::min(bytes.size(), window_.size() - size_);
    std::memcpy(window_.data() + size_, bytes.data(), taken);
    size_ += taken;
    bytes = bytes.subspan(taken);
    scan(false);
  }
}

void Pd4Framer::finish() {
  scan(true);
  close_run();
}

void Pd4Framer::scan(bool ended) {
  while (at_ < size_) {
    const std::span<const std::uint8_t> rest(window_.data() + at_, size_ - at_);
    const Pd4Start start = pd4_start(rest);
    if (start == Pd4Start::partial && !ended) break;
    const bool pd5 = start == Pd4Start::pd5;
    if (start == Pd4Start::none || start == Pd4Start::partial) {
      // A lone 7D is no start of anything.
      const bool cut = start == Pd4Start::partial && rest.size() >= 2;
      give_up_byte(cut ? rest.size() : 0, rest.size() >= 2 && rest[1] == 1, "truncated");
      continue;
    }
    const std::size_t length = pd5 ? kPd5Bytes : kPd4Bytes;
    if (rest.size() < length) {
      if (!ended) break;
      give_up_byte(rest.size(), pd5, "truncated");
      continue;
    }
    const auto body = rest.first(length - 2);
    if (pd0_checksum(body) != le_u16(rest, length - 2)) {
      give_up_byte(length, pd5, "checksum");
      continue;
    }
    close_run();
    sink_.frame(offset_, rest.first(length));
    at_ += length;
    offset_ += length;
    run_start_ = offset_;
  }
  std::memmove(window_.data(), window_.data() + at_, size_ - at_);
  size_ -= at_;
  at_ = 0;
}

/// The next byte begins no frame; announced: how long the frame would have been that it seemed to begin.
void Pd4Framer::give_up_byte(std::size_t announced, bool pd5, std::string_view reason) {
  // What looks like a start inside a broken frame is most likely its data.
  if (refused_end_ != 0 && offset_ >= refused_end_) close_run();
  if (refused_end_ == 0 && announced > 0) {
    close_run();
    refused_end_ = offset_ + announced;
    refused_pd5_ = pd5;
    reason_ = reason;
  }
  ++at_, ++offset_;
  if (offset_ - run_start_ == kLongestRun) close_run();
}

void Pd4Framer::close_run() {
  const auto length = static_cast<std::uint32_t>(offset_ - run_start_);
  if (length > 0 && refused_end_ != 0) sink_.refused(run_start_, length, refused_pd5_, reason_);
  if (length > 0 && refused_end_ == 0) sink_.skipped(run_start_, length);
  run_start_ = offset_;
  refused_end_ = 0;
}

}  // namespace leadline::decode
