#include "core/decode/nortek_dvl.h"

#include <optional>

#include "core/decode/frame_search.h"
#include "core/decode/nortek_dvl_ping.h"
#include "core/decode/number.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kWindowBytes = 48 * 1024;
constexpr double kPascalPerBar = 1e5;

constexpr std::string_view kSentences[] = {"PNORBT0", "PNORBT1", "PNORBT3", "PNORBT4", "PNORBT6", "PNORBT7",
                                           "PNORBT8", "PNORBT9", "PNORWT0", "PNORWT1", "PNORWT3", "PNORWT4",
                                           "PNORWT6", "PNORWT7", "PNORWT8", "PNORWT9"};

std::string_view kind_of_sentence(std::string_view fields) {
  const std::string_view address = fields.substr(0, fields.find(','));
  for (const std::string_view known : kSentences)
    if (address == known) return known;
  return "PNOR";
}

/// Opposite beams are 1 and 3, 2 and 4: the mean of a pair does not feel a tilt.
std::optional<double> altitude_of(const std::array<double, 4>& d) {
  double sum_m = 0.0;
  int beams = 0;
  for (std::size_t i = 0; i < 2; ++i)
    if (d[i] > 0.0 && d[i + 2] > 0.0) sum_m += d[i] + d[i + 2], beams += 2;
  return beams > 0 ? std::optional(sum_m / beams) : std::nullopt;
}

class NortekDvl final : public Decoder, private FrameFormat {
 public:
  NortekDvl(const DecoderSettings& settings, const ProfileOptions& profile)
      : checksum_required_(settings.checksum_required),
        sign_(profile.nortek_velocity == "bottom" ? -1.0 : 1.0),
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
  [[nodiscard]] FrameStart start(std::span<const std::uint8_t> rest, bool ended) const override {
    return nortek_start(rest, ended);
  }
  void lost(const FrameReport& report) override { out_->frame(report); }

  void frame(std::uint64_t offset, std::span<const std::uint8_t> bytes, const FrameStart& start) override {
    FrameReport report;
    report.offset = offset;
    report.length = static_cast<std::uint32_t>(bytes.size());
    report.kind = start.kind;
    if (bytes[0] == '$') {
      read_line({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, report);
    } else {
      report.checksum = ChecksumState::ok;
      tell(read_nortek_record(bytes), report);
    }
    out_->frame(report);
  }

  void read_line(std::string_view line, FrameReport& report) {
    while (line.back() == '\r' || line.back() == '\n') line.remove_suffix(1);
    line.remove_prefix(1);
    const std::size_t star = line.find('*');
    report.kind = kind_of_sentence(line.substr(0, star));
    report.checksum = ChecksumState::absent;
    if (star != std::string_view::npos) {
      std::uint8_t sum = 0;
      for (const char c : line.substr(0, star))
        sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
      report.checksum = parse_hex_byte(line.substr(star + 1)) == sum ? ChecksumState::ok : ChecksumState::bad;
    }
    if (report.checksum == ChecksumState::bad) return refuse("checksum", report);
    if (report.checksum == ChecksumState::absent && checksum_required_)
      return refuse("checksum absent", report);
    tell(read_nortek_sentence(line.substr(0, star)), report);
  }

  static void refuse(std::string_view reason, FrameReport& report) {
    report.byte_class = ByteClass::refused;
    report.reason = reason;
  }

  void tell(const NortekVerdict& verdict, FrameReport& report) {
    report.byte_class = verdict.byte_class;
    report.reason = verdict.reason;
    if (verdict.byte_class != ByteClass::decoded) return;
    const NortekPing& ping = verdict.ping;
    std::optional<Time> time;
    if (ping.trigger) {
      time = *ping.trigger + duration(ping.delay_s);
      out_->fact(time, ClockReading{report.kind, ping.trigger->ns, {}});
    }
    if (ping.sound_speed_mps && *ping.sound_speed_mps >= 1400.0 && *ping.sound_speed_mps <= 1600.0)
      out_->fact(time, SoundSpeed{*ping.sound_speed_mps});
    if (ping.pressure_bar) out_->fact(time, Pressure{*ping.pressure_bar * kPascalPerBar});
    if (!ping.water) {
      out_->fact(time, BeamRanges{ping.distance_m, {}});  // the telegram does not tell the beam angle
      if (const auto above_m = altitude_of(ping.distance_m)) out_->fact(time, AltitudeAboveBottom{*above_m});
    }
    if (!ping.water || ping.velocity) out_->fact(time, velocity_of(ping));
  }

  [[nodiscard]] DvlVelocity velocity_of(const NortekPing& ping) const {
    DvlVelocity v;
    v.reference = ping.water ? DvlReference::water : DvlReference::bottom;
    v.valid = ping.velocity.has_value();
    if (!ping.velocity) return v;
    v.x_mps = sign_ * ping.velocity->x_mps;
    v.y_mps = sign_ * ping.velocity->y_mps;
    v.z_mps = sign_ * ping.velocity->z_mps;
    v.sd_mps = ping.sd_mps;
    return v;
  }

  bool checksum_required_;
  double sign_;
  FrameSearch search_;
  DecoderOutput* out_ = nullptr;  ///< of the call under way
};

}  // namespace

std::unique_ptr<Decoder> make_nortek_dvl(const DecoderSettings& settings, const ProfileOptions& profile) {
  return std::make_unique<NortekDvl>(settings, profile);
}

}  // namespace leadline::decode
