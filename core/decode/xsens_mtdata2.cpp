#include "core/decode/xsens_mtdata2.h"

#include <string>

#include "core/decode/frame_search.h"
#include "core/decode/xsens_mtdata2_packet.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kWindowBytes = 16 * 1024;

/// How many packets went missing, by a counter of 16 bits. A gap of more than 1000 is a restart or an outage
/// that the ages tell of, not a count of losses.
class LossCount {
 public:
  /// Lost just before this one.
  std::uint32_t count(std::uint16_t counter) {
    constexpr std::uint16_t kMost = 1000;
    const auto step = last_ ? static_cast<std::uint16_t>(counter - *last_) : std::uint16_t{1};
    last_ = counter;
    if (step <= 1 || step > kMost) return 0;
    lost_ += step - 1u;
    return step - 1u;
  }
  /// Of how many in all to tell now; 0: nothing new. Told at the first and each time they have doubled.
  std::uint64_t to_tell() {
    if (lost_ < tell_at_) return 0;
    tell_at_ = 2 * lost_;
    return lost_;
  }

 private:
  std::optional<std::uint16_t> last_;
  std::uint64_t lost_ = 0, tell_at_ = 1;
};

/// UTC of packets that have only the sample time, from the newest one that had both.
class SampleClock {
 public:
  std::optional<Time> time_of(const XsensPacket& p) {
    constexpr std::uint32_t kBack = 0x80000000;
    constexpr std::int64_t kTick_ns = 100'000;
    if (!p.ticks) return p.utc;
    const std::uint32_t since = *p.ticks - ticks_;
    if (p.utc) {
      utc_ = p.utc;
    } else if (utc_ && since < kBack) {
      utc_ = *utc_ + Duration(since * kTick_ns);
    } else {
      utc_.reset();  // it went back: the device was started again
    }
    ticks_ = *p.ticks;
    return utc_;
  }

 private:
  std::optional<Time> utc_;
  std::uint32_t ticks_ = 0;
};

class XsensMtData2 final : public Decoder, private FrameFormat {
 public:
  explicit XsensMtData2(const DecoderSettings& settings)
      : reference_(settings.heading_magnetic ? HeadingReference::magnetic_north
                                             : HeadingReference::true_north),
        search_(*this, kWindowBytes) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) override {
    out_ = &out;
    search_.feed(bytes);
  }
  void finish(DecoderOutput& out) override {
    out_ = &out;
    search_.finish();
  }

 private:
  [[nodiscard]] FrameStart start(std::span<const std::uint8_t> rest, bool) const override {
    return xsens_start(rest);
  }
  void lost(const FrameReport& report) override { out_->frame(report); }

  void frame(std::uint64_t offset, std::span<const std::uint8_t> bytes, const FrameStart& start) override {
    FrameReport report{ByteClass::decoded,
                       ChecksumState::ok,
                       start.kind,
                       {},
                       offset,
                       static_cast<std::uint32_t>(bytes.size())};
    if (bytes[2] == kXsensMtData2) {
      XsensPacket packet;
      report.reason = read_xsens_packet(xsens_data(bytes), packet);
      if (report.reason.empty()) {
        if (packet.counter) report.lost = losses_.count(*packet.counter);
        tell(packet);
      } else {
        report.byte_class = ByteClass::refused;
      }
    } else {
      report.byte_class = start.kind == "Xbus" ? ByteClass::unknown : ByteClass::unused;
      if (start.kind == "Error" && !xsens_data(bytes).empty())
        out_->fact({}, Health{Health::Level::warning,
                              "the Xsens reports error " + std::to_string(xsens_data(bytes)[0])});
    }
    out_->frame(report);
  }

  void tell(const XsensPacket& p) {
    const std::optional<Time> time = clock_.time_of(p);
    if (p.utc) out_->fact(time, ClockReading{"MTData2", p.utc->ns, {}});
    if (const auto lost = losses_.to_tell(); lost > 0)
      out_->fact(time,
                 Health{Health::Level::note, "packets of the Xsens lost so far: " + std::to_string(lost)});
    const bool filter_valid = tell_status(p, time);
    if (p.attitude && filter_valid) {
      out_->fact(time, Heading{p.attitude->heading, reference_, {}, {}});
      out_->fact(time, Attitude{p.attitude->roll, p.attitude->pitch, {}, {}, {}});
    }
    if (p.rate_rps) out_->fact(time, Rates{p.rate_rps->z});
    if (p.rate_rps && p.specific_force_mps2)
      out_->fact(time, ImuSample{false, *p.rate_rps, *p.specific_force_mps2});
    if (p.position && (!p.status || (*p.status & kXsensGnssFix) != 0)) {
      GnssFix fix;
      fix.position = *p.position;
      out_->fact(time, fix);
    }
  }

  /// Is the attitude to be used?
  bool tell_status(const XsensPacket& p, std::optional<Time> time) {
    if (!p.status) return true;
    const bool valid = (*p.status & kXsensFilterValid) != 0, sound = (*p.status & kXsensSelfTest) != 0;
    if (!valid && filter_valid_)
      out_->fact(time,
                 Health{Health::Level::warning, "the Xsens calls its attitude invalid: it is not used"});
    if (!sound && sound_) out_->fact(time, Health{Health::Level::warning, "the Xsens failed its self-test"});
    filter_valid_ = valid, sound_ = sound;
    return valid;
  }

  HeadingReference reference_;
  FrameSearch search_;
  LossCount losses_;
  SampleClock clock_;
  bool filter_valid_ = true, sound_ = true;
  DecoderOutput* out_ = nullptr;  ///< of the call under way
};

}  // namespace

std::unique_ptr<Decoder> make_xsens_mtdata2(const DecoderSettings& settings) {
  return std::make_unique<XsensMtData2>(settings);
}

}  // namespace leadline::decode
