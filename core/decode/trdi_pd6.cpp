#include "core/decode/trdi_pd6.h"

#include <array>
#include <string>

#include "core/decode/nmea0183_clock.h"
#include "core/decode/trdi_pd6_framing.h"
#include "core/decode/trdi_pd6_lines.h"
#include "core/decode/trdi_pd6_velocity.h"

namespace leadline::decode {
namespace {

bool is_printable(std::string_view text) {
  for (const char c : text)
    if (c < 0x20 || c > 0x7E) return false;
  return true;
}

class Pd6Decoder final : public Decoder, private Pd6LineSink {
 public:
  Pd6Decoder(const DecoderSettings& settings, const ProfileOptions& profile)
      : settings_(settings), dating_(settings.date), framer_(*this), axes_(profile.pd6_axes) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
            DecoderOutput& out) override {
    out_ = &out;
    arrival_ = arrival;
    framer_.feed(bytes);
  }
  void finish(DecoderOutput& out) override {
    out_ = &out;
    framer_.finish();
    close_ping();
  }

 private:
  struct Held {
    FrameReport report;
    std::optional<Pd6Line> line;
  };

  void line(std::string_view text, End end, std::uint64_t offset, std::uint32_t length) override {
    const auto known = pd6_line(text);
    FrameReport report{ByteClass::decoded,
                       ChecksumState::none,
                       known ? pd6_name(*known) : "line",
                       "",
                       offset,
                       length,
                       false};
    report.reason = !is_printable(text)     ? "not printable"
                    : end == End::too_long  ? "too long"
                    : end == End::next_line ? "torn"
                    : end == End::stream    ? "truncated"
                                            : "";
    if (!report.reason.empty()) return damage(refused(report));
    if (!known) {
      report.byte_class = ByteClass::unknown;
      return hold(report, std::nullopt);
    }
    if (*known == Pd6Line::HM) return take_health(text, report);
    take(*known, text, report);
  }

  void between(ByteClass byte_class, std::uint64_t offset, std::uint32_t length) override {
    const FrameReport report{
        byte_class, ChecksumState::none, byte_class == ByteClass::unknown ? "text" : "", "", offset, length,
        false};
    if (byte_class == ByteClass::comment) return hold(report, std::nullopt);
    damage(report);
  }

  void take(Pd6Line line, std::string_view text, FrameReport report) {
    if (starts_ping(line)) {
      close_ping();
      last_.reset();
      lost_ = false;
    }
    last_ = line;
    if (lost_) {
      report.reason = "group";
      out_->frame(refused(report));
    } else {
      report.reason = read_pd6_line(line, text, ping_);
      if (report.reason.empty() && line == Pd6Line::TS && !take_clock()) report.reason = "range";
      if (report.reason == "fields") return damage(refused(report));
      hold(report.reason.empty() ? report : refused(report), line);
    }
    if (line != Pd6Line::BD) return;
    close_ping();
    last_.reset();
    lost_ = false;
  }

  [[nodiscard]] bool starts_ping(Pd6Line line) const {
    return !last_ || line <= *last_ || (line == Pd6Line::TS && (lost_ || *last_ != Pd6Line::SA));
  }

  /// False: there is no such date.
  bool take_clock() {
    if (!ping_.timing->clock) return true;
    Civil civil = *ping_.timing->clock;
    civil.year = dating_.full_year(civil.year, arrival_);
    const auto full = from_civil(civil);
    if (!full) {
      ping_.timing.reset();
      return false;
    }
    if (dating_.learn(*full, arrival_)) {
      time_ = full;
    } else if (!rollover_told_) {
      rollover_told_ = true;
      out_->fact(std::nullopt,
                 Health{Health::Level::warning,
                        "GPS week rollover suspected: the DVL's date is a multiple of 1024 weeks from the "
                        "host's; the host's time is used instead"});
    }
    return true;
  }

  /// Bytes may be missing here: what follows need not be of the same ping.
  void damage(const FrameReport& report) {
    close_ping();
    out_->frame(report);
    if (last_) lost_ = true;
  }

  void hold(const FrameReport& report, std::optional<Pd6Line> line) {
    if (held_count_ == 0 && !line) return out_->frame(report);
    if (held_count_ == held_.size()) return damage(report);  // no ping holds so much
    held_[held_count_++] = {report, line};
  }

  void take_health(std::string_view text, FrameReport report) {
    Pd6Ping health;
    report.reason = read_pd6_line(Pd6Line::HM, text, health);
    if (!report.reason.empty()) {
      report = refused(report);
    } else if (health.leak != leak_) {
      leak_ = health.leak;
      if (leak_[0] == 'L' || leak_[1] == 'L')
        out_->fact(std::nullopt, Health{Health::Level::warning, "the DVL reports water inside (HM)"});
    }
    hold(report, std::nullopt);
  }

  void close_ping() {
    if (held_count_ == 0) return;
    axes_.observe(ping_);
    const Pd6Choice bottom = pd6_bottom_velocity(ping_, axes_, settings_);
    const Pd6Choice water = pd6_water_velocity(ping_, axes_, settings_);
    const auto attitude = pd6_attitude(ping_, settings_);
    const bool range_told =
        ping_.distance && ping_.distance->range_m > 0.0 && ping_.distance->since_good_s == 0.0;
    tell_facts(attitude, range_told, bottom, water);
    for (std::size_t i = 0; i < held_count_; ++i) {
      Held& held = held_[i];
      if (held.line && held.report.byte_class == ByteClass::decoded)
        judge(*held.line, attitude.has_value(), range_told, bottom, water, held.report);
      out_->frame(held.report);
    }
    held_count_ = 0;
    ping_ = {};
    time_.reset();
  }

  void tell_facts(const std::optional<DvlVelocity::Applied>& attitude, bool range_told,
                  const Pd6Choice& bottom, const Pd6Choice& water) {
    if (time_) out_->fact(time_, ClockReading{"TS", time_->ns, {}});
    if (attitude) {
      out_->fact(time_, Heading{attitude->heading, attitude->reference, {}, {}});
      out_->fact(time_, Attitude{attitude->roll, attitude->pitch, {}, {}, {}});
    }
    if (ping_.timing) tell_timing(*ping_.timing);
    if (ping_.ranges) tell_ranges(*ping_.ranges);
    if (range_told) out_->fact(time_, AltitudeAboveBottom{ping_.distance->range_m});
    if (bottom.verdict == Pd6Verdict::told) out_->fact(time_, bottom.velocity);
    if (water.verdict == Pd6Verdict::told) out_->fact(time_, water.velocity);
  }

  void tell_timing(const Pd6Ping::Timing& t) {
    if (t.sound_speed_mps >= 1400.0 && t.sound_speed_mps <= 1600.0)
      out_->fact(time_, SoundSpeed{t.sound_speed_mps});
    if (t.depth_m > 0.0) out_->fact(time_, DepthMeasured{Depth{t.depth_m}, {}});
    if (t.built_in_test != 0 && t.built_in_test != built_in_test_)
      out_->fact(time_, Health{Health::Level::warning,
                               "the DVL's built-in test reports " + std::to_string(t.built_in_test)});
    built_in_test_ = t.built_in_test;
  }

  void tell_ranges(const Pd6Ping::Ranges& r) {
    if (r.pressure_kpa != 0.0) out_->fact(time_, Pressure{r.pressure_kpa * 1e3});
    BeamRanges ranges;  // the telegram does not tell the beam angle
    for (std::size_t i = 0; i < 4; ++i) ranges.range_m[i] = r.range_dm[i] * 0.1;
    out_->fact(time_, ranges);
  }

  /// What became of a sound line, now that the whole ping is known.
  static void judge(Pd6Line line, bool attitude_told, bool range_told, const Pd6Choice& bottom,
                    const Pd6Choice& water, FrameReport& report) {
    const auto unless = [&](bool used) {
      if (!used) report.byte_class = ByteClass::unused;
    };
    const auto velocity = [&](const Pd6Choice& choice, Pd6Line first) {
      const auto i = static_cast<std::size_t>(line) - static_cast<std::size_t>(first);
      unless(choice.verdict == Pd6Verdict::told && choice.line == i);
      if (choice.verdict != Pd6Verdict::inconsistent) return;
      report.byte_class = ByteClass::refused;
      report.reason = "inconsistent";
    };
    if (line == Pd6Line::SA) unless(attitude_told);
    if (line == Pd6Line::WD) unless(false);
    if (line == Pd6Line::BD) unless(range_told);
    if (line >= Pd6Line::WI && line <= Pd6Line::WE) velocity(water, Pd6Line::WI);
    if (line >= Pd6Line::BI && line <= Pd6Line::BE) velocity(bottom, Pd6Line::BI);
  }

  static FrameReport refused(FrameReport report) {
    report.byte_class = ByteClass::refused;
    return report;
  }

  DecoderSettings settings_;
  nmea0183::Dating dating_;
  Pd6Framer framer_;
  DecoderOutput* out_ = nullptr;  ///< of the call under way
  std::optional<Arrival> arrival_;
  Pd6Axes axes_;

  Pd6Ping ping_;  ///< the open one
  std::optional<Time> time_;
  std::array<Held, 24> held_{};  ///< its lines, until it is whole
  std::size_t held_count_ = 0;
  std::optional<Pd6Line> last_;  ///< the line before, in the same ping
  bool lost_ = false;            ///< the ping was damaged: its other lines are refused

  std::uint32_t built_in_test_ = 0;
  std::array<char, 2> leak_{};
  bool rollover_told_ = false;
};

}  // namespace

std::unique_ptr<Decoder> make_trdi_pd6(const DecoderSettings& settings, const ProfileOptions& profile) {
  return std::make_unique<Pd6Decoder>(settings, profile);
}

}  // namespace leadline::decode
