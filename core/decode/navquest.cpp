#include "core/decode/navquest.h"

#include <array>
#include <string>

#include "core/decode/line_search.h"
#include "core/decode/number.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kLongest = 1024;
constexpr std::string_view kPrefix = "$#NQ.RES";
constexpr std::size_t kTokens = 47;
constexpr double kFastest_mmps = 20'000.0, kFarthest_m = 10'000.0;

/// What the numbered tokens may be; those that are not named are numbers of any size.
struct Range {
  std::size_t first, last;
  double least, most;
};
constexpr std::array kRanges{Range{2, 5, 0.0, 1.0},                         // beam flags
                             Range{6, 9, -kFarthest_m, kFarthest_m},        // altitudes of the beams
                             Range{10, 17, -kFastest_mmps, kFastest_mmps},  // along the beams
                             Range{18, 21, 0.0, 50.0},                      // water credits
                             Range{22, 24, -kFastest_mmps, kFastest_mmps},  // instrument frame
                             Range{25, 25, 0.0, 2.0},
                             Range{26, 28, -kFastest_mmps, kFastest_mmps},  // earth frame
                             Range{29, 29, 0.0, 2.0},
                             Range{30, 32, -kFastest_mmps, kFastest_mmps},  // water current
                             Range{33, 33, 0.0, 2.0},
                             Range{34, 36, -kFastest_mmps, kFastest_mmps},
                             Range{37, 37, 0.0, 2.0},
                             Range{38, 38, -180.0, 180.0},              // roll
                             Range{39, 39, -90.0, 90.0},                // pitch
                             Range{40, 40, 0.0, 360.0},                 // heading
                             Range{41, 41, -kFarthest_m, kFarthest_m},  // altitude
                             Range{42, 42, -20.0, 80.0},                // temperature
                             Range{44, 44, 0.0, 100.0},                 // salinity
                             Range{45, 45, 0.0, 2000.0}};               // sound speed

bool is_flag(double value) { return value == 0.0 || value == 1.0 || value == 2.0; }

/// 0X and hex digits.
std::optional<std::uint32_t> parse_code(std::string_view text) {
  if (text.size() < 3 || text.size() > 10 || text[0] != '0' || (text[1] != 'X' && text[1] != 'x'))
    return std::nullopt;
  std::uint32_t code = 0;
  for (const char c : text.substr(2)) {
    const std::array pair{'0', c};
    const auto digit = parse_hex_byte({pair.data(), pair.size()});
    if (!digit) return std::nullopt;
    code = code << 4 | *digit;
  }
  return code;
}

/// A line's numbers, by the numbers of their tokens; [0] and [1] are the prefix and the error code.
struct Ping {
  std::array<double, kTokens> value{};
  std::uint32_t error = 0;
};

/// Why the line may not be used; empty when it was read.
std::string_view read_ping(std::string_view text, Ping& ping) {
  std::size_t n = 0;
  while (true) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);
    const std::string_view token = text.substr(0, text.find(' '));
    text.remove_prefix(token.size());
    if (n == kTokens) return "fields";
    if (n == 1) {
      const auto code = parse_code(token);
      if (!code) return "fields";
      ping.error = *code;
    } else if (n + 1 == kTokens) {
      if (!parse_digits(token)) return "fields";
    } else if (n > 1) {
      const auto value = parse_number(token);
      if (!value) return "fields";
      ping.value[n] = *value;
    }
    ++n;
  }
  if (n != kTokens) return "fields";
  for (const Range& r : kRanges)
    for (std::size_t i = r.first; i <= r.last; ++i)
      if (ping.value[i] < r.least || ping.value[i] > r.most) return "range";
  for (const std::size_t flag : {2u, 3u, 4u, 5u, 25u, 29u, 33u, 37u})
    if (!is_flag(ping.value[flag])) return "range";
  return {};
}

class NavQuest final : public Decoder, private LineReader {
 public:
  NavQuest(const DecoderSettings& settings, const ProfileOptions& profile)
      : settings_(settings), of_bottom_(profile.navquest_velocity == "bottom"), lines_(*this, kLongest) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) override {
    lines_.feed(bytes, out);
  }
  void finish(DecoderOutput& out) override { lines_.finish(out); }

 private:
  Verdict read(const FoundLine& line, DecoderOutput& out) override {
    Verdict verdict;
    FrameReport& report = verdict.report;
    report.byte_class = ByteClass::refused;
    report.kind = "NQ.RES";
    if (!is_printable(line.text)) return report.reason = "not printable", verdict;
    if (line.end == FoundLine::End::too_long) return report.reason = "too long", verdict;
    // The last one: before it the line may hold the beginning of a torn one, or rubbish.
    const std::size_t begin = line.text.rfind(kPrefix);
    if (begin == std::string_view::npos) {
      const bool torn = line.text.front() == '$' &&
                        line.text.substr(0, kPrefix.size()) == kPrefix.substr(0, line.text.size());
      if (torn) return report.reason = "truncated", verdict;
      report.byte_class = ByteClass::unknown;
      report.kind = "text";
      return verdict;
    }
    if (line.end == FoundLine::End::stream) return report.reason = "truncated", verdict;
    Ping ping;
    report.reason = read_ping(line.text.substr(begin), ping);
    if (!report.reason.empty()) return verdict;
    if (begin > 0) {
      verdict.skipped = begin;
      out.frame(
          {ByteClass::skipped, ChecksumState::none, "", "", line.offset, static_cast<std::uint32_t>(begin)});
    }
    report.byte_class = ByteClass::decoded;
    tell(ping, out);
    return verdict;
  }

  void tell(const Ping& ping, DecoderOutput& out) {
    const auto& v = ping.value;
    if (ping.error != error_ && ping.error != 0)
      out.fact(std::nullopt,
               Health{Health::Level::warning, "the DVL reports error code " + std::to_string(ping.error)});
    error_ = ping.error;
    if (v[38] != 0.0 || v[39] != 0.0 || v[40] != 0.0) {
      const auto reference =
          settings_.heading_magnetic ? HeadingReference::magnetic_north : HeadingReference::true_north;
      out.fact(std::nullopt, Heading{Angle::deg(v[40] == 360.0 ? 0.0 : v[40]), reference, {}, {}});
      out.fact(std::nullopt, Attitude{Angle::deg(v[38]), Angle::deg(v[39]), {}, {}, {}});
    }
    if (v[45] >= 1400.0 && v[45] <= 1600.0) out.fact(std::nullopt, SoundSpeed{v[45]});
    BeamRanges ranges;  // the telegram does not tell the beam angle
    for (std::size_t i = 0; i < 4; ++i)
      if (v[2 + i] == 1.0 && v[6 + i] > 0.0) ranges.range_m[i] = v[6 + i];
    out.fact(std::nullopt, ranges);
    if (v[41] > 0.0) out.fact(std::nullopt, AltitudeAboveBottom{v[41]});
    out.fact(std::nullopt, velocity(v));
  }

  [[nodiscard]] DvlVelocity velocity(const std::array<double, kTokens>& v) const {
    DvlVelocity velocity;
    velocity.reference = v[25] == 2.0 ? DvlReference::water : DvlReference::bottom;
    velocity.valid = v[25] != 0.0;
    if (!velocity.valid) return velocity;
    const double mps = of_bottom_ ? -1e-3 : 1e-3;
    velocity.x_mps = v[22] * mps + 0.0;
    velocity.y_mps = v[23] * mps + 0.0;
    velocity.z_mps = v[24] * mps + 0.0;
    return velocity;
  }

  DecoderSettings settings_;
  bool of_bottom_;
  LineSearch lines_;
  std::uint32_t error_ = 0;
};

}  // namespace

std::unique_ptr<Decoder> make_navquest(const DecoderSettings& settings, const ProfileOptions& profile) {
  return std::make_unique<NavQuest>(settings, profile);
}

}  // namespace leadline::decode
