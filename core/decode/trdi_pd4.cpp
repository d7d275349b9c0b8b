#include "core/decode/trdi_pd4.h"

#include <optional>
#include <string>

#include "core/decode/frame_search.h"
#include "core/decode/nmea0183_clock.h"
#include "core/decode/trdi_pd0_facts.h"
#include "core/decode/trdi_pd4_frame.h"

namespace leadline::decode {
namespace {

using Attitude5 = Pd4Frame::Attitude;

constexpr std::size_t kWindowBytes = 16 * 1024;

std::optional<std::int64_t> time_of_day_ns(const Pd4Frame& f) {
  if (f.hour > 23 || f.minute > 59 || f.second > 60 || f.hundredths > 99) return std::nullopt;
  const std::int64_t s = (f.hour * 60 + f.minute) * 60 + f.second;
  const std::int64_t ns = s * 1'000'000'000 + f.hundredths * std::int64_t{10'000'000};
  return ns == 0 ? std::nullopt : std::optional(ns);
}

/// Empty when it is not sent, not filled or out of range.
std::optional<DvlVelocity::Applied> attitude_of(const Pd4Frame& f, const DecoderSettings& settings) {
  if (!f.attitude) return std::nullopt;
  const Attitude5& a = *f.attitude;
  if (a.heading_cdeg > 35999 || a.pitch_cdeg == kPd0Missing || a.roll_cdeg == kPd0Missing)
    return std::nullopt;
  if (a.heading_cdeg == 0 && a.pitch_cdeg == 0 && a.roll_cdeg == 0) return std::nullopt;
  return DvlVelocity::Applied{
      Angle::deg(a.heading_cdeg * 0.01), Angle::deg(a.roll_cdeg * 0.01), Angle::deg(a.pitch_cdeg * 0.01),
      settings.heading_magnetic ? HeadingReference::magnetic_north : HeadingReference::true_north};
}

/// x to starboard (east), y forward (north), z up, of the vehicle.
DvlVelocity velocity_of(const Pd4Frame& f, DvlReference reference, const std::array<std::int16_t, 4>& mmps,
                        const DecoderSettings& settings) {
  DvlVelocity v;
  v.reference = reference;
  const Pd0Coordinates coordinates = f.coordinates();
  v.frame = coordinates == Pd0Coordinates::ship    ? DvlFrame::ship
            : coordinates == Pd0Coordinates::earth ? DvlFrame::earth
                                                   : DvlFrame::instrument;
  v.tilt_applied = v.frame == DvlFrame::earth || (v.frame == DvlFrame::ship && f.tilts_used());
  if (v.frame == DvlFrame::earth) v.applied = attitude_of(f, settings);
  const bool whole = mmps[0] != kPd0Missing && mmps[1] != kPd0Missing && mmps[2] != kPd0Missing;
  v.valid = whole && coordinates != Pd0Coordinates::beam;
  if (!v.valid) return v;
  v.x_mps = mmps[1] * 1e-3, v.y_mps = mmps[0] * 1e-3, v.z_mps = 0.0 - mmps[2] * 1e-3;
  if (mmps[3] != kPd0Missing) v.error_mps = mmps[3] * 1e-3;
  return v;
}

class Pd4Decoder final : public Decoder, private FrameFormat {
 public:
  explicit Pd4Decoder(const DecoderSettings& settings)
      : settings_(settings), dating_(settings.date), search_(*this, kWindowBytes) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
            DecoderOutput& out) override {
    out_ = &out;
    arrival_ = arrival;
    search_.feed(bytes);
  }
  void finish(DecoderOutput& out) override {
    out_ = &out;
    search_.finish();
  }

 private:
  [[nodiscard]] FrameStart start(std::span<const std::uint8_t> rest, bool) const override {
    return pd4_start(rest);
  }
  void lost(const FrameReport& report) override { out_->frame(report); }
  void frame(std::uint64_t offset, std::span<const std::uint8_t> bytes, const FrameStart& start) override {
    const Pd4Frame f = read_pd4_frame(bytes);
    const std::string_view kind = start.kind;
    std::optional<Time> time;
    if (const auto of_day_ns = time_of_day_ns(f)) time = dating_.instant(*of_day_ns, arrival_);
    if (time) out_->fact(time, ClockReading{kind, time->ns, {}});
    tell_state(f, time);
    tell_velocities(f, time);
    out_->frame(
        {ByteClass::decoded, ChecksumState::ok, kind, "", offset, static_cast<std::uint32_t>(bytes.size())});
  }

  void tell_state(const Pd4Frame& f, std::optional<Time> time) {
    if (const auto a = attitude_of(f, settings_)) {
      out_->fact(time, Heading{a->heading, a->reference, {}, {}});
      out_->fact(time, Attitude{a->roll, a->pitch, {}, {}, {}});
    }
    if (f.sound_speed_mps >= 1400 && f.sound_speed_mps <= 1600)
      out_->fact(time, SoundSpeed{static_cast<double>(f.sound_speed_mps)});
    if (f.attitude && f.attitude->depth_dm > 0)
      out_->fact(time, DepthMeasured{Depth{f.attitude->depth_dm * 0.1}, {}});
    if (f.built_in_test != 0 && f.built_in_test != built_in_test_)
      out_->fact(time, Health{Health::Level::warning,
                              "the DVL's built-in test reports " + std::to_string(f.built_in_test)});
    built_in_test_ = f.built_in_test;
  }

  void tell_velocities(const Pd4Frame& f, std::optional<Time> time) {
    BeamRanges ranges;  // the frame does not tell the beam angle
    Pd0BottomTrack beams{};
    for (std::size_t i = 0; i < 4; ++i) {
      ranges.range_m[i] = f.range_cm[i] * 0.01;
      beams.range_cm[i] = f.range_cm[i];
    }
    out_->fact(time, ranges);
    if (const auto altitude = pd0_altitude(beams)) out_->fact(time, *altitude);
    if (f.coordinates() == Pd0Coordinates::beam) return warn_of_beams(time);
    auto bottom = velocity_of(f, DvlReference::bottom, f.bottom_mmps, settings_);
    if (f.beams_low() > 1) {
      bottom.valid = false;
      bottom.x_mps = bottom.y_mps = bottom.z_mps = 0.0;
      bottom.error_mps.reset();
    }
    out_->fact(time, bottom);
    if (f.layer_end_dm == 0) return;
    const auto water = velocity_of(f, DvlReference::water, f.water_mmps, settings_);
    if (water.valid) out_->fact(time, water);
  }

  void warn_of_beams(std::optional<Time> time) {
    if (beams_told_) return;
    beams_told_ = true;
    out_->fact(time,
               Health{Health::Level::warning,
                      "the DVL sends beam coordinates, whose beam angle PD4 does not tell: its velocity "
                      "is not used; set it to instrument, ship or earth coordinates (EX)"});
  }

  DecoderSettings settings_;
  nmea0183::Dating dating_;
  FrameSearch search_;
  DecoderOutput* out_ = nullptr;  ///< of the call under way
  std::optional<Arrival> arrival_;
  std::uint16_t built_in_test_ = 0;
  bool beams_told_ = false;
};

}  // namespace

std::unique_ptr<Decoder> make_trdi_pd4(const DecoderSettings& settings) {
  return std::make_unique<Pd4Decoder>(settings);
}

}  // namespace leadline::decode
