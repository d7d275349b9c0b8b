#include "core/decode/frame_search.h"

#include <algorithm>
#include <cstring>

#include "core/types/expect.h"

namespace leadline::decode {
namespace {

constexpr std::uint64_t kLongestRun = 64 * 1024;

}  // namespace

FrameSearch::FrameSearch(FrameFormat& format, std::size_t window_bytes)
    : format_(format), window_(window_bytes) {}

void FrameSearch::feed(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const std::size_t taken = std::min(bytes.size(), window_.size() - size_);
    std::memcpy(window_.data() + size_, bytes.data(), taken);
    size_ += taken;
    bytes = bytes.subspan(taken);
    scan(false);
  }
}

void FrameSearch::finish() {
  scan(true);
  close_run();
}

void FrameSearch::scan(bool ended) {
  while (at_ < size_) {
    const std::span<const std::uint8_t> rest(window_.data() + at_, size_ - at_);
    FrameStart start = format_.start(rest, ended);
    switch (start.is) {
      case FrameStart::Is::frame:
        LL_EXPECT(start.length > 0 && start.length <= rest.size());
        close_run();
        format_.frame(offset_, rest.first(start.length), start);
        at_ += start.length;
        offset_ += start.length;
        run_start_ = offset_;
        continue;
      case FrameStart::Is::broken:
        give_up_byte(start.length, start);
        continue;
      case FrameStart::Is::nothing:
        give_up_byte(0, start);
        continue;
      case FrameStart::Is::unsettled:
        break;
    }
    if (ended) {
      start.reason = "truncated";
      give_up_byte(start.kind.empty() ? 0 : rest.size(), start);
    } else if (rest.size() == window_.size()) {
      start.reason = "too long";
      give_up_byte(rest.size(), start);
    } else {
      break;
    }
  }
  if (at_ == 0) return;
  std::memmove(window_.data(), window_.data() + at_, size_ - at_);
  size_ -= at_;
  at_ = 0;
}

/// The next byte begins no frame; announced: how long the frame would have been that it seemed to begin.
void FrameSearch::give_up_byte(std::size_t announced, const FrameStart& start) {
  // What looks like a start inside a broken frame is most likely its data.
  if (refused_end_ != 0 && offset_ >= refused_end_) close_run();
  if (refused_end_ == 0 && announced > 0) {
    close_run();
    refused_end_ = offset_ + announced;
    refused_kind_ = start.kind;
    reason_ = start.reason;
  }
  ++at_, ++offset_;
  if (offset_ - run_start_ == kLongestRun) close_run();
}

void FrameSearch::close_run() {
  const auto length = static_cast<std::uint32_t>(offset_ - run_start_);
  if (length > 0) {
    FrameReport report;
    report.byte_class = refused_end_ != 0 ? ByteClass::refused : ByteClass::skipped;
    if (refused_end_ != 0) {
      report.checksum = reason_ == "checksum" ? ChecksumState::bad : ChecksumState::none;
      report.kind = refused_kind_;
      report.reason = reason_;
    }
    report.offset = run_start_;
    report.length = length;
    format_.lost(report);
  }
  run_start_ = offset_;
  refused_end_ = 0;
}

}  // namespace leadline::decode
