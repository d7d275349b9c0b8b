#include "core/decode/trdi_pd0.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "core/decode/trdi_pd0_ensemble.h"
#include "core/decode/trdi_pd0_facts.h"
#include "core/decode/trdi_pd0_framing.h"
#include "core/decode/trdi_pd0_nmea.h"

namespace leadline::decode {
namespace {

constexpr std::int64_t kNsPerDay = 86'400'000'000'000;

/// The instant with this UTC time of day that lies nearest to `about`: a clock on local time is up to 12 h
/// off.
std::int64_t nearest_day_ns(std::int64_t of_day_ns, Time about) {
  const std::int64_t into_day = (about.ns % kNsPerDay + kNsPerDay) % kNsPerDay;
  std::int64_t ns = about.ns - into_day + of_day_ns;
  if (ns - about.ns > kNsPerDay / 2) ns -= kNsPerDay;
  if (about.ns - ns > kNsPerDay / 2) ns += kNsPerDay;
  return ns;
}

/// The fixes told last, by their UTC: 10 Hz GNSS under 5 s ensembles fits twice.
class ToldFixes {
 public:
  /// False when this fix was told before. time: on the device's clock, to tell one day from the next.
  bool tell(std::int64_t of_day_ns, std::optional<Time> time) {
    for (std::size_t i = 0; i < count_; ++i) {
      const bool other_day =
          time && fixes_[i].time && std::abs((*time - *fixes_[i].time).count()) > kNsPerDay / 2;
      if (fixes_[i].of_day_ns == of_day_ns && !other_day) return false;
    }
    fixes_[next_] = {of_day_ns, time};
    next_ = (next_ + 1) % fixes_.size();
    count_ = std::min(count_ + 1, fixes_.size());
    return true;
  }

 private:
  struct Fix {
    std::int64_t of_day_ns;
    std::optional<Time> time;
  };
  std::array<Fix, 128> fixes_{};
  std::size_t next_ = 0, count_ = 0;
};

class Pd0Decoder final : public Decoder, private Pd0FrameSink {
 public:
  explicit Pd0Decoder(const DecoderSettings& settings) : settings_(settings), framer_(*this) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> /*arrival*/,
            DecoderOutput& out) override {
    out_ = &out;
    framer_.feed(bytes);
  }
  void finish(DecoderOutput& out) override {
    out_ = &out;
    framer_.finish();
  }

 private:
  void ensemble(std::uint64_t offset, std::uint32_t length, const Pd0Ensemble& e) override {
    tell_pd0_facts(e, settings_, *out_);
    std::size_t apart = 0;
    for (std::size_t i = 0; i < e.types(); ++i)
      if (const auto block = read_pd0_nmea(e.type(i))) apart += block->length;
    tell(ByteClass::decoded, ChecksumState::ok, "ensemble", "", offset, length - apart);
    const auto time = pd0_time(e.variable);
    last_depth_.reset();
    for (std::size_t i = 0; i < e.types(); ++i)
      if (const auto block = read_pd0_nmea(e.type(i))) tell_block(e, *block, time, offset + e.type_offset(i));
  }

  void waves(std::uint64_t offset, std::uint32_t length) override {
    tell(ByteClass::unused, ChecksumState::ok, "waves", "", offset, length);
  }

  void refused(std::uint64_t offset, std::uint32_t length, std::string_view reason, bool waves) override {
    const ChecksumState checksum = reason == "checksum" ? ChecksumState::bad
                                   : reason == "layout" ? ChecksumState::ok
                                                        : ChecksumState::none;
    tell(ByteClass::refused, checksum, waves ? "waves" : "ensemble", reason, offset, length);
  }

  void skipped(std::uint64_t offset, std::uint32_t length) override {
    tell(ByteClass::skipped, ChecksumState::none, "", "", offset, length);
  }

  void tell_block(const Pd0Ensemble& e, const Pd0Nmea& block, std::optional<Time> ensemble_time,
                  std::uint64_t offset) {
    std::optional<Time> time = ensemble_time;
    if (time && block.delta) time = *time - *block.delta;
    ByteClass byte_class = block.byte_class;
    if (block.fix && !tell_fix(e, block, time)) byte_class = ByteClass::unused;
    if (block.course) out_->fact(time, *block.course);
    if (block.depth && !tell_depth(*block.depth, time)) byte_class = ByteClass::unused;
    FrameReport report{byte_class, ChecksumState::none,
                       block.kind, block.reason,
                       offset,     static_cast<std::uint32_t>(block.length)};
    report.block = true;
    out_->frame(report);
  }

  bool tell_fix(const Pd0Ensemble& e, const Pd0Nmea& block, std::optional<Time> time) {
    if (!block.binary && has_binary_fix(e, *block.utc_of_day_ns)) return false;
    if (!told_.tell(*block.utc_of_day_ns, time)) return false;
    out_->fact(time, *block.fix);
    if (time && block.delta)  // the older types do not say how long before the ensemble they came
      out_->fact(time, ClockReading{block.kind, time->ns, nearest_day_ns(*block.utc_of_day_ns, *time)});
    return true;
  }

  static bool has_binary_fix(const Pd0Ensemble& e, std::int64_t of_day_ns) {
    for (std::size_t i = 0; i < e.types(); ++i) {
      const auto other = read_pd0_nmea(e.type(i));
      if (other && other->binary && other->fix && other->utc_of_day_ns == of_day_ns) return true;
    }
    return false;
  }

  bool tell_depth(const BottomDepth& depth, std::optional<Time> time) {
    const std::pair told{time, depth};
    if (last_depth_ == told) return false;
    last_depth_ = told;
    out_->fact(time, depth);
    return true;
  }

  void tell(ByteClass byte_class, ChecksumState checksum, std::string_view kind, std::string_view reason,
            std::uint64_t offset, std::size_t length) {
    out_->frame({byte_class, checksum, kind, reason, offset, static_cast<std::uint32_t>(length), false});
  }

  DecoderSettings settings_;
  Pd0Framer framer_;
  DecoderOutput* out_ = nullptr;  ///< of the call under way
  ToldFixes told_;
  std::optional<std::pair<std::optional<Time>, BottomDepth>> last_depth_;  ///< within one ensemble
};

}  // namespace

std::unique_ptr<Decoder> make_trdi_pd0(const DecoderSettings& settings) {
  return std::make_unique<Pd0Decoder>(settings);
}

}  // namespace leadline::decode
