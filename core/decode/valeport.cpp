#include "core/decode/valeport.h"

#include <algorithm>
#include <array>

#include "core/decode/line_search.h"
#include "core/decode/number.h"
#include "core/decode/pressure_depth.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kLongest = 256;
constexpr std::size_t kMostTokens = 16;
constexpr double kPaPerDbar = 1e4, kPaPerHpa = 100.0;
constexpr double kLeast_dbar = -20.0, kMost_dbar = 12'000.0;
constexpr double kLeast_m = -20.0, kMost_m = 12'000.0;
constexpr double kSlowest_mps = 1300.0, kFastest_mps = 1800.0;
constexpr std::string_view kSeparators = " \t,;";

/// What stands between separators.
class Tokens {
 public:
  explicit Tokens(std::string_view text) {
    while (true) {
      const std::size_t begin = text.find_first_not_of(kSeparators);
      if (begin == std::string_view::npos) return;
      text.remove_prefix(begin);
      if (count_ == kMostTokens) {
        too_many_ = true;
        return;
      }
      const std::size_t end = std::min(text.find_first_of(kSeparators), text.size());
      token_[count_++] = text.substr(0, end);
      text.remove_prefix(end);
    }
  }
  [[nodiscard]] std::size_t count() const { return too_many_ ? kMostTokens + 1 : count_; }
  [[nodiscard]] std::string_view operator[](std::size_t i) const { return token_[i]; }

 private:
  std::array<std::string_view, kMostTokens> token_;
  std::size_t count_ = 0;
  bool too_many_ = false;
};

/// The form a line has, by its tokens.
enum class Form : std::uint8_t { value, legacy, row };

/// What a line said.
struct Reading {
  std::optional<double> pressure_dbar, depth_m, sound_speed_mps;
  std::string_view refusal;

  std::optional<double> number(std::string_view token, double least, double most) {
    const auto value = parse_number(token);
    if (!value) refusal = "fields";
    if (value && (*value < least || *value > most) && refusal.empty()) refusal = "range";
    return value;
  }
  void value(std::string_view token, bool metres) {
    if (metres)
      depth_m = number(token, kLeast_m, kMost_m);
    else
      pressure_dbar = number(token, kLeast_dbar, kMost_dbar);
  }
  void sound_speed(std::string_view token, double mps_per_unit) {
    const auto sent = number(token, 0.0, 1e7);
    if (!sent || *sent == 0.0) return;
    sound_speed_mps = *sent * mps_per_unit;
    if ((*sound_speed_mps < kSlowest_mps || *sound_speed_mps > kFastest_mps) && refusal.empty())
      refusal = "range";
  }
};

std::uint8_t exclusive_or(std::string_view text) {
  std::uint8_t sum = 0;
  for (const char c : text) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
  return sum;
}

class Valeport final : public Decoder, private LineReader {
 public:
  Valeport(const DecoderSettings& settings, const ProfileOptions& profile)
      : settings_(settings),
        columns_(profile.valeport_columns),
        metres_(profile.valeport_unit == "m"),
        atmosphere_pa_(profile.valeport_atmosphere_hpa * kPaPerHpa),
        depth_(profile.latitude_deg, profile.density_kgm3),
        lines_(*this, kLongest) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) override {
    lines_.feed(bytes, out);
  }
  void finish(DecoderOutput& out) override { lines_.finish(out); }

 private:
  Verdict read(const FoundLine& line, DecoderOutput& out) override {
    Verdict verdict;
    FrameReport& report = verdict.report;
    report.byte_class = ByteClass::refused;
    report.kind = "line";
    if (!is_printable_or_tab(line.text)) return report.reason = "not printable", verdict;
    if (line.end == FoundLine::End::too_long) return report.reason = "too long", verdict;
    if (const std::size_t dollar = line.text.rfind('$'); dollar != std::string_view::npos) {
      if (dollar > 0)
        out.frame({ByteClass::skipped, ChecksumState::none, "", "", line.offset,
                   static_cast<std::uint32_t>(dollar)});
      verdict.skipped = dollar;
      sentence(line.text.substr(dollar + 1), line.end, out, report);
    } else if (line.end == FoundLine::End::stream) {
      report.reason = "truncated";
    } else {
      numbers(line.text, out, report);
    }
    return verdict;
  }

  static bool is_printable_or_tab(std::string_view text) {
    return std::all_of(text.begin(), text.end(),
                       [](char c) { return (c >= 0x20 && c <= 0x7E) || c == '\t'; });
  }

  void sentence(std::string_view text, FoundLine::End end, DecoderOutput& out, FrameReport& report) {
    const bool starred = text.size() >= 3 && text[text.size() - 3] == '*';
    const auto given = starred ? parse_hex_byte(text.substr(text.size() - 2)) : std::nullopt;
    if (given) text.remove_suffix(3);
    report.checksum = !given                         ? ChecksumState::absent
                      : *given == exclusive_or(text) ? ChecksumState::ok
                                                     : ChecksumState::bad;
    if (text.substr(0, 7) == "PVIPS2,") report.kind = "PVIPS2";
    if (!given && end == FoundLine::End::stream) {
      report.reason = "truncated";
    } else if (!given && (settings_.checksum_required || text.find('*') != std::string_view::npos)) {
      report.reason = "checksum absent";
    } else if (report.checksum == ChecksumState::bad) {
      report.reason = "checksum";
    } else if (report.kind != "PVIPS2") {
      report.byte_class = ByteClass::unknown;
    } else {
      nmea0183::Fields fields(text.substr(7));
      const MiniIps2 said = read_mini_ips2(fields);
      report.reason = fields.refusal();
      if (!report.reason.empty()) return;
      report.byte_class = ByteClass::decoded;
      tell({said.pressure_dbar, said.depth_m, {}, {}}, out);
    }
  }

  void numbers(std::string_view text, DecoderOutput& out, FrameReport& report) {
    const Tokens tokens(text);
    Reading reading;
    const bool unit =
        tokens.count() == 2 && tokens[1].size() == 1 && (tokens[1][0] < '0' || tokens[1][0] > '9');
    if (unit) {
      report.kind = "value";
      const char letter = tokens[1][0];
      reading.value(tokens[0], letter == 'M' || letter == 'm');
      if (std::string_view("MmdD").find(letter) == std::string_view::npos) reading.refusal = "fields";
    } else if (tokens.count() == 5 && tokens[0].find('/') != std::string_view::npos) {
      report.kind = "legacy";
      reading.value(tokens[2], metres_);
      for (const std::size_t i : {3u, 4u}) (void)reading.number(tokens[i], -1e6, 1e6);
    } else if (tokens.count() == 1 && columns_.size() != 1) {
      report.kind = "value";
      reading.value(tokens[0], metres_);
    } else {
      report.kind = "row";
      row(tokens, reading);
    }
    report.reason = reading.refusal;
    if (!report.reason.empty()) return;
    report.byte_class = ByteClass::decoded;
    tell(reading, out);
  }

  void row(const Tokens& tokens, Reading& reading) const {
    if (tokens.count() != columns_.size()) {
      reading.refusal = "fields";
      return;
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i] == "pressure_dbar")
        reading.value(tokens[i], false);
      else if (columns_[i] == "depth_m")
        reading.value(tokens[i], true);
      else if (columns_[i] == "sound_speed_mps")
        reading.sound_speed(tokens[i], 1.0);
      else if (columns_[i] == "sound_speed_mmps")
        reading.sound_speed(tokens[i], 1e-3);
      else
        (void)reading.number(tokens[i], -1e9, 1e9);
    }
  }

  void tell(const Reading& r, DecoderOutput& out) {
    std::optional<double> depth_m = r.depth_m;
    if (r.pressure_dbar) {
      const double sent_pa = *r.pressure_dbar * kPaPerDbar;
      out.fact(std::nullopt, Pressure{atmosphere_pa_ > 0.0 ? sent_pa - kStandardAtmosphere_pa : sent_pa});
      if (!depth_m) {
        if (const auto note = depth_.note()) out.fact(std::nullopt, *note);
        depth_m = depth_.metres(sent_pa - atmosphere_pa_);
      }
    }
    if (depth_m) out.fact(std::nullopt, DepthMeasured{Depth{*depth_m}, {}});
    if (r.sound_speed_mps) out.fact(std::nullopt, SoundSpeed{*r.sound_speed_mps});
  }

  DecoderSettings settings_;
  std::vector<std::string> columns_;
  bool metres_;
  double atmosphere_pa_;
  PressureDepth depth_;
  LineSearch lines_;
};

}  // namespace

MiniIps2 read_mini_ips2(nmea0183::Fields& f) {
  f.require(6);
  MiniIps2 said;
  said.pressure_dbar = f.number(3, kLeast_dbar, kMost_dbar);
  const char pressure_unit = f.letter(4), depth_unit = f.letter(6);
  const auto depth_m = f.number(5, kLeast_m, kMost_m);
  if (pressure_unit != 'd' && pressure_unit != 'D' && pressure_unit != '\0')
    f.refuse(nmea0183::kReasonFields);
  // With units off the field is empty.
  if (depth_unit != 'M' && depth_unit != 'm' && depth_unit != '\0') f.refuse(nmea0183::kReasonFields);
  said.depth_m = depth_m;
  return said;
}

std::unique_ptr<Decoder> make_valeport(const DecoderSettings& settings, const ProfileOptions& profile) {
  return std::make_unique<Valeport>(settings, profile);
}

}  // namespace leadline::decode
