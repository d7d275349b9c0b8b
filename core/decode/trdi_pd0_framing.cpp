#include "core/decode/trdi_pd0_framing.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "core/decode/byte_order.h"
#include "core/types/expect.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kHeaderBytes = 6;
constexpr std::size_t kChecksumBytes = 2;
constexpr std::uint64_t kLongestRun = 64 * 1024;

enum class HeaderState : std::uint8_t { none, partial, implausible, plausible };

struct Header {
  HeaderState state = HeaderState::none;
  bool waves = false;
  std::size_t length = 0;  ///< of the whole frame with its checksum
};

Header read_header(std::span<const std::uint8_t> bytes, std::size_t ceiling) {
  Header header;
  if (bytes.empty() || bytes[0] != 0x7F) return header;
  if (bytes.size() >= 2 && bytes[1] != 0x7F && bytes[1] != 0x79) return header;
  header.waves = bytes.size() >= 2 && bytes[1] == 0x79;
  header.state = HeaderState::partial;
  if (bytes.size() < kHeaderBytes) return header;
  const std::size_t size = le_u16(bytes, 2), types = bytes[5];
  const bool plausible = types > 0 && size >= kHeaderBytes + 2 * types && size <= ceiling;
  header.state = plausible ? HeaderState::plausible : HeaderState::implausible;
  header.length = size + kChecksumBytes;
  return header;
}

std::size_t find_7f(std::span<const std::uint8_t> bytes, std::size_t from) {
  if (from >= bytes.size()) return bytes.size();
  const void* found = std::memchr(bytes.data() + from, 0x7F, bytes.size() - from);
  return found ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - bytes.data())
               : bytes.size();
}

constexpr auto ends_later = [](const auto& a, const auto& b) {
  return a.end != b.end ? a.end > b.end : a.start > b.start;
};

}  // namespace

std::uint16_t pd0_checksum(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = 0;
  for (const std::uint8_t b : bytes) sum += b;
  return static_cast<std::uint16_t>(sum);
}

Pd0Framer::Pd0Framer(Pd0FrameSink& sink, std::size_t ceiling) : sink_(sink), ceiling_(ceiling) {
  LL_EXPECT(ceiling >= kHeaderBytes && ceiling <= 0xFFFF - kChecksumBytes);
  carry_.reserve(2 * (ceiling_ + kChecksumBytes + kHeaderBytes));
  candidates_.reserve(64);
}

void Pd0Framer::feed(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    if (carry_.empty()) {
      const std::size_t used = scan(bytes);
      base_ += used;
      carry_.assign(bytes.begin() + static_cast<std::ptrdiff_t>(used), bytes.end());
      return;
    }
    const std::size_t kept = carry_.size(), taken = std::min(bytes.size(), ceiling_ + kChecksumBytes);
    carry_.insert(carry_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(taken));
    const std::size_t used = scan(carry_);
    base_ += used;
    if (used >= kept) {
      carry_.clear();
      bytes = bytes.subspan(used - kept);
    } else {
      carry_.erase(carry_.begin(), carry_.begin() + static_cast<std::ptrdiff_t>(used));
      bytes = bytes.subspan(taken);
    }
  }
}

void Pd0Framer::finish() {
  candidates_.clear();
  settle(carry_, base_ + carry_.size(), true);
  close_run();
  base_ += carry_.size();
  discovered_ = base_;
  carry_.clear();
}

/// Takes every frame that is complete in the window; returns how many of its bytes are done with.
std::size_t Pd0Framer::scan(std::span<const std::uint8_t> window) {
  const std::uint64_t end = base_ + window.size();
  for (;;) {
    discover(window);
    if (candidates_.empty() || candidates_.front().end > end) break;
    std::pop_heap(candidates_.begin(), candidates_.end(), ends_later);
    const Candidate candidate = candidates_.back();
    candidates_.pop_back();
    judge(candidate, window);
  }
  std::uint64_t done = discovered_;
  for (const Candidate& c : candidates_) done = std::min(done, c.start);
  settle(window, done, false);
  return static_cast<std::size_t>(done - base_);
}

/// Finds headers as far as they can matter: a frame that starts after the earliest end cannot end before it.
void Pd0Framer::discover(std::span<const std::uint8_t> window) {
  const std::uint64_t end = base_ + window.size();
  while (discovered_ < end && (candidates_.empty() || discovered_ < candidates_.front().end)) {
    const std::size_t i = find_7f(window, static_cast<std::size_t>(discovered_ - base_));
    discovered_ = base_ + i;
    const Header header = read_header(window.subspan(i), ceiling_);
    if (i == window.size() || header.state == HeaderState::partial) return;
    if (header.state == HeaderState::plausible) {
      candidates_.push_back({discovered_, discovered_ + header.length, header.waves});
      std::push_heap(candidates_.begin(), candidates_.end(), ends_later);
    }
    ++discovered_;
  }
}

void Pd0Framer::judge(const Candidate& c, std::span<const std::uint8_t> window) {
  const auto frame =
      window.subspan(static_cast<std::size_t>(c.start - base_), static_cast<std::size_t>(c.end - c.start));
  const auto body = frame.first(frame.size() - kChecksumBytes);
  if (pd0_checksum(body) != le_u16(frame, body.size())) return;
  const std::optional<Pd0Ensemble> sound = c.waves ? std::nullopt : read_pd0_ensemble(body);
  // A sum alone is met by chance once in 65536: inside a frame still under way it proves nothing.
  const bool inside = std::any_of(candidates_.begin(), candidates_.end(),
                                  [&](const Candidate& o) { return o.start < c.start; });
  if (!sound && inside) return;
  settle(window, c.start, false);
  close_run();
  settled_ = c.end;
  discovered_ = c.end;
  candidates_.clear();  // all that are known start inside this frame
  const auto length = static_cast<std::uint32_t>(frame.size());
  if (sound) return sink_.ensemble(c.start, length, *sound);
  if (c.waves) return sink_.waves(c.start, length);
  sink_.refused(c.start, length, "layout", false);
}

/// Puts the bytes up to `upto`, which no frame will take, into runs.
void Pd0Framer::settle(std::span<const std::uint8_t> window, std::uint64_t upto, bool ended) {
  while (settled_ < upto) {
    const std::size_t i = static_cast<std::size_t>(settled_ - base_);
    const Header header = read_header(window.subspan(i), ceiling_);
    const std::uint64_t announced_end = settled_ + header.length;
    std::uint64_t next = settled_ + 1;
    switch (header.state) {
      case HeaderState::none:
        next = std::min(upto, base_ + find_7f(window, i + 1));
        break;
      case HeaderState::implausible:
        fail(settled_, settled_, "size", header.waves);
        break;
      case HeaderState::partial:  // only at the stream's end; a lone 7F is no header
        if (window.size() - i >= 2) fail(settled_, upto, "truncated", header.waves);
        break;
      case HeaderState::plausible:
        fail(settled_, announced_end, ended && announced_end > upto ? "truncated" : "checksum", header.waves);
        break;
    }
    extend_run(next);
  }
}

void Pd0Framer::fail(std::uint64_t at, std::uint64_t announced_end, std::string_view reason, bool waves) {
  // What looks like a header inside a broken frame is most likely its data.
  if (run_ == Run::refused && (at < run_announced_end_ || announced_end == at)) return;
  close_run();
  run_ = Run::refused;
  run_reason_ = reason;
  run_waves_ = waves;
  run_start_ = at;
  run_announced_end_ = announced_end;
}

void Pd0Framer::extend_run(std::uint64_t upto) {
  if (run_ == Run::none) run_ = Run::skipped, run_start_ = settled_;
  while (upto - run_start_ > kLongestRun) {
    settled_ = run_start_ + kLongestRun;
    close_run();
    run_ = Run::skipped;
    run_start_ = settled_;
  }
  settled_ = upto;
}

void Pd0Framer::close_run() {
  const auto length = static_cast<std::uint32_t>(settled_ - run_start_);
  if (run_ == Run::refused) sink_.refused(run_start_, length, run_reason_, run_waves_);
  if (run_ == Run::skipped) sink_.skipped(run_start_, length);
  run_ = Run::none;
}

}  // namespace leadline::decode
