#include "core/links/stream_times.h"

#include <algorithm>
#include <cmath>

namespace leadline::links {
namespace {

constexpr Duration kJump = std::chrono::hours(1);

Duration gap(Time a, Time b) { return a < b ? b - a : a - b; }

/// One instrument's clock as it goes on, with its single bad readings left out.
class TimeLine {
 public:
  void read(std::uint64_t offset, Time time) {
    const Reading reading{offset, time};
    if (last_ && follows(time)) return accept(reading), waiting_.clear();
    const auto near = std::find_if(waiting_.begin(), waiting_.end(),
                                   [&](const Reading& w) { return gap(w.time, time) <= kJump; });
    if (near != waiting_.end()) {
      accept(*near);
      return accept(reading), waiting_.clear();
    }
    if (in_stride(time)) {
      for (const Reading& w : waiting_) accept(w);
      return accept(reading), waiting_.clear();
    }
    // Kept: the newest doubtful reading, and before it one that makes a stride with it.
    const bool forward = !waiting_.empty() && waiting_.back().time < time;
    if (!waiting_.empty()) waiting_.erase(waiting_.begin(), forward ? waiting_.end() - 1 : waiting_.end());
    waiting_.push_back(reading);
  }

  /// No more readings: the only ones there are need no confirmation.
  void end() {
    if (!last_)
      for (const Reading& w : waiting_) accept(w);
    waiting_.clear();
  }

  [[nodiscard]] const std::optional<Time>& first() const { return first_; }
  void correct(const StreamTimeOptions& options) { options_ = &options; }
  std::vector<Stamp> take_stamps() { return std::move(stamps_); }

 private:
  struct Reading {
    std::uint64_t offset;
    Time time;
  };

  [[nodiscard]] bool follows(Time time) const {
    return gap(*last_, time) <= kJump || (time > *last_ && time - *last_ <= 2 * step_);
  }

  /// A moored ADCP pings every few hours: three readings in about equal steps forward confirm each other.
  [[nodiscard]] bool in_stride(Time time) const {
    if (waiting_.empty() || (waiting_.size() < 2 && !last_)) return false;
    const Duration stride = waiting_.back().time - (waiting_.size() > 1 ? waiting_.front().time : *last_);
    const Duration step = time - waiting_.back().time;
    return stride > Duration(0) && step > Duration(0) && step <= 2 * stride && stride <= 2 * step;
  }

  void accept(const Reading& r) {
    if (!first_) first_ = r.time;
    step_ = last_ && *last_ < r.time ? r.time - *last_ : Duration(0);
    last_ = r.time;
    Time time = r.time;
    if (options_)
      time = (options_->gps_time ? utc_from_gps(time) : time) + Duration(options_->time_offset_ns);
    const Arrival arrival = arrival_at(time);
    if (stamps_.empty() || (arrival > stamps_.back().arrival && r.offset > stamps_.back().offset))
      stamps_.push_back({r.offset, arrival});
  }

  const StreamTimeOptions* options_ = nullptr;
  std::vector<Stamp> stamps_;
  std::vector<Reading> waiting_;  // two at most
  std::optional<Time> first_, last_;
  Duration step_{0};  // between the last two accepted
};

/// Listens to a decoder for what each telegram says of the time.
class Scan final : public DecoderOutput {
 public:
  explicit Scan(const StreamTimeOptions& options) : options_(options) {
    clock.correct(options);
    device.correct(options);
  }

  void fact(std::optional<Time> device_time, const Message& message) override {
    if (const auto* reading = std::get_if<ClockReading>(&message))
      clock_ = Time{reading->device_ns};
    else if (device_time)
      device_ = std::max(device_.value_or(*device_time), *device_time);
  }

  void frame(const FrameReport& report) override {
    if (report.block) {  // a reading inside a block belongs to the telegram around it
      if ((clock_ || device_) && !block_offset_) block_offset_ = report.offset;
      return;
    }
    const std::uint64_t offset = std::min(report.offset, block_offset_.value_or(report.offset));
    if (clock_) clock.read(offset, *clock_);
    if (device_ && !clock.first()) device.read(offset, *device_);
    const bool telegram = report.byte_class == ByteClass::decoded || report.byte_class == ByteClass::unused;
    if (telegram && !report.kind.empty()) count_telegram(offset);
    clock_.reset(), device_.reset(), block_offset_.reset();
  }

  TimeLine clock, device;
  std::uint64_t telegrams = 0;
  std::vector<Stamp> by_rate;

 private:
  void count_telegram(std::uint64_t offset) {
    const auto k = static_cast<double>(telegrams++);
    if (!options_.date || options_.rate_hz <= 0.0 || clock.first() || device.first()) return;
    const Arrival arrival = arrival_at(*options_.date + Duration(std::llround(k * 1e9 / options_.rate_hz)));
    if (by_rate.empty() || arrival > by_rate.back().arrival) by_rate.push_back({offset, arrival});
  }

  const StreamTimeOptions& options_;
  std::optional<Time> clock_, device_;
  std::optional<std::uint64_t> block_offset_;
};

/// Runs the decoder over the file; stops at the first time of the clock where nothing more is asked.
Result<void> run(FileReader& file, Decoder& decoder, Scan& scan, bool only_first) {
  constexpr std::size_t kPiece = std::size_t{64} << 10;
  file.rewind();
  for (auto bytes = file.take(kPiece); !bytes.empty(); bytes = file.take(kPiece)) {
    decoder.feed(bytes, std::nullopt, scan);
    if (only_first && scan.clock.first()) return {};
  }
  if (file.failure()) return *file.failure();
  decoder.finish(scan);
  scan.clock.end();
  scan.device.end();
  return {};
}

}  // namespace

Result<std::vector<Stamp>> stream_times(FileReader& file, const DecoderMaker& make_decoder,
                                        const StreamTimeOptions& options) {
  std::optional<Time> host;
  {
    Scan scan(options);
    const auto decoder = make_decoder(std::nullopt);
    if (const auto done = run(file, *decoder, scan, true); !done) return done.error();
    host = scan.clock.first() ? scan.clock.first() : scan.device.first();
  }
  if (!host && file.offset() == 0) return std::vector<Stamp>{};
  if (!host && !options.date)
    return Error{"holds no date", options.file, "set `date = \"YYYY-MM-DD\"` for source " + options.source};
  if (!host) host = *options.date + std::chrono::hours(12);

  Scan scan(options);
  const auto decoder = make_decoder(host);
  if (const auto done = run(file, *decoder, scan, false); !done) return done.error();
  if (scan.clock.first()) return scan.clock.take_stamps();
  if (scan.device.first()) return scan.device.take_stamps();
  if (options.rate_hz > 0.0 && !scan.by_rate.empty()) return std::move(scan.by_rate);
  if (options.rate_hz <= 0.0 && scan.telegrams > 1)
    return Error{"holds no times", options.file, "set `rate_hz` for source " + options.source};
  return std::vector<Stamp>{{0, arrival_at(options.date.value_or(*host))}};
}

}  // namespace leadline::links
