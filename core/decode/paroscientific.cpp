#include "core/decode/paroscientific.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/decode/line_search.h"
#include "core/decode/number.h"
#include "core/decode/pressure_depth.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kLongest = 128;
constexpr double kPaPerHpa = 100.0;
constexpr double kShallowest_m = -12.0, kDeepest_m = 12'000.0;
constexpr double kFastest_mps = 5.0;
constexpr double kSlack_m = 0.5;  ///< arrivals scatter

double pa_per(std::string_view unit) {
  struct Unit {
    std::string_view name;
    double pa;
  };
  constexpr std::array<Unit, 9> kUnits{{{"psi", 6894.757293168},
                                        {"hpa", 100.0},
                                        {"mbar", 100.0},
                                        {"bar", 1e5},
                                        {"kpa", 1e3},
                                        {"mpa", 1e6},
                                        {"inhg", 3386.389},
                                        {"mmhg", 133.322387415},
                                        {"m", 9806.65}}};
  for (const Unit& u : kUnits)
    if (u.name == unit) return u.pa;
  return kUnits[0].pa;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Paroscientific final : public Decoder, private LineReader {
 public:
  Paroscientific(const DecoderSettings& settings, const ProfileOptions& profile)
      : wanted_(parse_digits(settings.address)),
        any_(settings.address.empty()),
        pa_per_unit_(pa_per(profile.paroscientific_unit)),
        atmosphere_pa_(profile.paroscientific_atmosphere_hpa * kPaPerHpa),
        depth_(profile.latitude_deg, profile.density_kgm3),
        lines_(*this, kLongest) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
            DecoderOutput& out) override {
    arrival_ = arrival;
    lines_.feed(bytes, out);
  }
  void finish(DecoderOutput& out) override { lines_.finish(out); }

 private:
  /// A depth and when it was heard.
  struct Heard {
    double depth_m;
    Arrival arrival;
    [[nodiscard]] bool reaches(double depth, Arrival at) const {
      const double s = std::abs(seconds(at - arrival));
      return s == 0.0 || std::abs(depth - depth_m) <= kFastest_mps * s + kSlack_m;
    }
  };
  struct Device {
    std::optional<Heard> believed, before;
  };

  Verdict read(const FoundLine& line, DecoderOutput& out) override {
    Verdict verdict;
    FrameReport& report = verdict.report;
    report.byte_class = ByteClass::refused;
    report.kind = "line";
    if (!is_printable(line.text)) return report.reason = "not printable", verdict;
    if (line.end == FoundLine::End::too_long) return report.reason = "too long", verdict;
    const std::size_t star = line.text.rfind('*');
    if (star == std::string_view::npos) {
      report.byte_class = ByteClass::unknown;
      report.kind = "text";
      return verdict;
    }
    if (line.end == FoundLine::End::stream) return report.reason = "truncated", verdict;
    if (star > 0)
      out.frame(
          {ByteClass::skipped, ChecksumState::none, "", "", line.offset, static_cast<std::uint32_t>(star)});
    verdict.skipped = star;
    judge(line.text.substr(star + 1), out, report);
    return verdict;
  }

  void judge(std::string_view text, DecoderOutput& out, FrameReport& report) {
    if (text.size() < 4 || !std::all_of(text.begin(), text.begin() + 4, is_digit)) {
      report.reason = "fields";
      return;
    }
    const std::uint32_t destination = *parse_digits(text.substr(0, 2)),
                        source = *parse_digits(text.substr(2, 2));
    const std::string_view value = text.substr(4);
    const bool letters = std::any_of(value.begin(), value.end(),
                                     [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); });
    report.kind = letters || destination != 0 ? "command" : "pressure";
    if (report.kind == "command" || (!any_ && wanted_ != source)) {
      report.byte_class = ByteClass::unused;
      return;
    }
    const auto pressure = parse_number(value);
    if (!pressure) {
      report.reason = "fields";
      return;
    }
    const double sent_pa = *pressure * pa_per_unit_;
    const double depth_m = depth_.metres(sent_pa - atmosphere_pa_);
    if (!(depth_m >= kShallowest_m && depth_m <= kDeepest_m)) {
      report.reason = "range";
      return;
    }
    if (!reachable(devices_[source], depth_m)) {
      report.reason = "rate";
      return;
    }
    report.byte_class = ByteClass::decoded;
    if (const auto note = depth_.note()) out.fact(std::nullopt, *note);
    out.fact(std::nullopt, Pressure{atmosphere_pa_ > 0.0 ? sent_pa - kStandardAtmosphere_pa : sent_pa});
    out.fact(std::nullopt, DepthMeasured{Depth{depth_m}, {}});
  }

  /// From the last depth believed, or from the one before, which may have been refused: a jump that stays is
  /// none.
  bool reachable(Device& device, double depth_m) const {
    if (!arrival_) return true;
    const bool reached = !device.believed || device.believed->reaches(depth_m, *arrival_) ||
                         (device.before && device.before->reaches(depth_m, *arrival_));
    device.before = Heard{depth_m, *arrival_};
    if (reached) device.believed = device.before;
    return reached;
  }

  std::optional<std::uint32_t> wanted_;
  bool any_;
  double pa_per_unit_, atmosphere_pa_;
  PressureDepth depth_;
  LineSearch lines_;
  std::optional<Arrival> arrival_;
  std::array<Device, 100> devices_{};  ///< by source
};

}  // namespace

std::unique_ptr<Decoder> make_paroscientific(const DecoderSettings& settings, const ProfileOptions& profile) {
  return std::make_unique<Paroscientific>(settings, profile);
}

}  // namespace leadline::decode
