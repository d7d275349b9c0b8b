#include "core/decode/waterlinked_serial.h"

#include <array>

#include "core/decode/line_search.h"
#include "core/decode/number.h"
#include "core/decode/waterlinked.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kLongest = 512;

constexpr auto kCrc = [] {
  std::array<std::uint8_t, 256> table{};
  for (unsigned i = 0; i < 256; ++i) {
    unsigned crc = i;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ ((crc & 0x80) != 0 ? 0x07 : 0);
    table[i] = static_cast<std::uint8_t>(crc);
  }
  return table;
}();

/// The options of a line, between its commas.
class Options {
 public:
  explicit Options(std::string_view text) {
    while (count_ < fields_.size()) {
      const std::size_t comma = text.find(',');
      fields_[count_++] = text.substr(0, comma);
      if (comma == std::string_view::npos) return;
      text.remove_prefix(comma + 1);
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::string_view text(std::size_t i) const { return fields_[i]; }
  std::optional<double> number(std::size_t i) {
    const auto value = parse_scientific(fields_[i]);
    malformed_ = malformed_ || !value;
    return value;
  }
  bool yes(std::size_t i) {
    malformed_ = malformed_ || (fields_[i] != "y" && fields_[i] != "n");
    return fields_[i] == "y";
  }
  std::uint32_t digits(std::size_t i) {
    const auto value = parse_digits(fields_[i]);
    malformed_ = malformed_ || !value;
    return value.value_or(0);
  }
  std::array<double, 9> matrix(std::size_t i) {
    std::array<double, 9> values{};
    std::string_view rest = fields_[i];
    for (std::size_t n = 0; n < values.size(); ++n) {
      const std::size_t semicolon = rest.find(';');
      const auto value = parse_scientific(rest.substr(0, semicolon));
      malformed_ = malformed_ || !value || (semicolon == std::string_view::npos) != (n + 1 == values.size());
      values[n] = value.value_or(0.0);
      rest = semicolon == std::string_view::npos ? std::string_view{} : rest.substr(semicolon + 1);
    }
    return values;
  }
  void refuse() { malformed_ = true; }
  [[nodiscard]] bool malformed() const { return malformed_; }

 private:
  std::array<std::string_view, 16> fields_;
  std::size_t count_ = 0;
  bool malformed_ = false;
};

/// A range as sent: -1 is none, which is 0 inside.
double range_m(double sent) { return sent < 0.0 ? 0.0 : sent; }

class WaterLinkedSerial final : public Decoder, private LineReader {
 public:
  explicit WaterLinkedSerial(const DecoderSettings& settings)
      : settings_(settings), lines_(*this, kLongest) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
            DecoderOutput& out) override {
    arrival_ = arrival;
    lines_.feed(bytes, out);
  }
  void finish(DecoderOutput& out) override { lines_.finish(out); }

 private:
  Verdict read(const FoundLine& line, DecoderOutput& out) override {
    Verdict verdict;
    FrameReport& report = verdict.report;
    report.byte_class = ByteClass::refused;
    report.kind = "line";
    if (!is_printable(line.text)) return report.reason = "not printable", verdict;
    if (line.end == FoundLine::End::too_long) return report.reason = "too long", verdict;

    std::string_view text = line.text;
    const bool starred = text.size() >= 3 && text[text.size() - 3] == '*';
    const auto given = starred ? parse_hex_byte(text.substr(text.size() - 2)) : std::nullopt;
    if (!given) {
      if (line.end == FoundLine::End::stream) return report.reason = "truncated", verdict;
      if (text.front() != 'w') {
        report.byte_class = ByteClass::unknown;
        report.kind = "text";
        return verdict;
      }
      report.checksum = ChecksumState::absent;
      if (settings_.checksum_required || text.find('*') != std::string_view::npos)
        return report.reason = "checksum absent", verdict;
    } else {
      text.remove_suffix(3);
      verdict.skipped = begin_of(text, *given);
      if (verdict.skipped == std::string_view::npos) {
        verdict.skipped = 0;
        report.checksum = ChecksumState::bad;
        report.reason = "checksum";
        return verdict;
      }
      report.checksum = ChecksumState::ok;
      if (verdict.skipped > 0)
        out.frame({ByteClass::skipped, ChecksumState::none, "", "", line.offset,
                   static_cast<std::uint32_t>(verdict.skipped)});
      text.remove_prefix(verdict.skipped);
    }
    judge(text, out, report);
    return verdict;
  }

  /// Where in the text the line begins whose CRC this is; npos: nowhere.
  static std::size_t begin_of(std::string_view text, std::uint8_t crc) {
    if (waterlinked_crc(text) == crc) return 0;
    for (std::size_t at = text.find("wr", 1); at != std::string_view::npos; at = text.find("wr", at + 1))
      if (waterlinked_crc(text.substr(at)) == crc) return at;
    return std::string_view::npos;
  }

  void judge(std::string_view text, DecoderOutput& out, FrameReport& report) {
    const std::size_t comma = text.find(',');
    const std::string_view name = text.substr(0, comma);
    Options options(comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1));
    report.byte_class = ByteClass::decoded;
    if (name == "wrz") {
      report.kind = "wrz";
      report.reason = options.count() < 11 ? "fields" : velocity("wrz", options, true, out);
    } else if (name == "wrs" && options.count() == 4) {
      report.kind = "wrs time";
      facts_.clock_set(options.yes(1));
      report.reason = options.malformed() ? "fields" : "";
    } else if (name == "wrs") {
      report.kind = "wrs";
      report.reason = options.count() < 10 ? "fields" : velocity("wrs", options, false, out);
    } else if (name == "wru") {
      report.kind = "wru";
      report.reason = options.count() < 5 ? "fields" : beam(options, out);
    } else if (name == "wrp") {
      report.kind = "wrp";
      report.reason = options.count() < 9 ? "fields" : attitude(options, out);
    } else if (name == "wrx") {
      report.kind = "wrx";
      report.reason = options.count() < 8 ? "fields" : old_velocity(options, out);
    } else if (name == "wrt") {
      report.kind = "wrt";
      report.reason = options.count() < 4 ? "fields" : old_ranges(options, out);
    } else {
      const bool reply = name.size() == 3 && name.substr(0, 2) == "wr",
                 command = name.size() == 3 && name.substr(0, 2) == "wc";
      report.byte_class = reply || command ? ByteClass::unused : ByteClass::unknown;
      report.kind = reply ? "reply" : command ? "command" : "line";
    }
    if (!report.reason.empty()) report.byte_class = ByteClass::refused;
  }

  std::string_view velocity(std::string_view telegram, Options& o, bool with_altitude, DecoderOutput& out) {
    WaterLinkedVelocity v;
    v.water = !with_altitude;
    for (std::size_t i = 0; i < 3; ++i) v.mps[i] = o.number(i);
    v.valid = o.yes(3);
    std::size_t next = 4;
    if (with_altitude) v.altitude_m = o.number(next++);
    v.fom_mps = o.number(next);
    v.covariance_m2ps2 = o.matrix(next + 1);
    v.validity_us = o.number(next + 2);
    v.transmission_us = o.number(next + 3);
    (void)o.number(next + 4);  // since the report before
    v.status = o.digits(next + 5);
    if (o.malformed()) return "fields";
    const auto reason = facts_.tell(telegram, v, arrival_, out);
    if (!reason.empty()) return reason;
    ping_time_ = facts_.last_time();
    beams_ = 0;
    return {};
  }

  std::string_view beam(Options& o, DecoderOutput& out) {
    const std::uint32_t id = o.digits(0);
    (void)o.number(1);
    const double range = o.number(2).value_or(0.0);
    (void)o.number(3);
    (void)o.number(4);
    if (o.malformed()) return "fields";
    if (id > 3 || range > kFarthest_m) return "range";
    if (id != beams_) beams_ = 0;  // one of them is lost
    if (id != beams_) return {};
    range_m_[id] = range_m(range);
    if (++beams_ < 4) return {};
    beams_ = 0;
    facts_.tell_ranges(range_m_, ping_time_, out);
    ping_time_.reset();
    return {};
  }

  std::string_view attitude(Options& o, DecoderOutput& out) {
    WaterLinkedAttitude a;
    a.time_s = o.number(0);
    for (std::size_t i = 1; i < 5; ++i) (void)o.number(i);  // the place since its reset, and its sigma
    a.roll_deg = o.number(5);
    a.pitch_deg = o.number(6);
    (void)o.number(7);
    a.status = o.digits(8);
    return o.malformed() ? "fields" : facts_.tell(a, arrival_, out);
  }

  std::string_view old_velocity(Options& o, DecoderOutput& out) {
    WaterLinkedVelocity v;
    (void)o.number(0);
    for (std::size_t i = 0; i < 3; ++i) v.mps[i] = o.number(i + 1);
    v.fom_mps = o.number(4);
    v.altitude_m = o.number(5);
    v.valid = o.yes(6);
    v.status = o.digits(7);
    return o.malformed() ? "fields" : facts_.tell("wrx", v, arrival_, out);
  }

  std::string_view old_ranges(Options& o, DecoderOutput& out) {
    std::array<double, 4> ranges{};
    bool far = false;
    for (std::size_t i = 0; i < 4; ++i) {
      ranges[i] = range_m(o.number(i).value_or(0.0));
      far = far || ranges[i] > kFarthest_m;
    }
    if (o.malformed() || far) return far ? "range" : "fields";
    facts_.tell_ranges(ranges, {}, out);
    return {};
  }

  static constexpr double kFarthest_m = 1000.0;

  DecoderSettings settings_;
  WaterLinkedFacts facts_;
  LineSearch lines_;
  std::optional<Arrival> arrival_;
  std::array<double, 4> range_m_{};
  std::uint32_t beams_ = 0;        ///< of the open ping, in order
  std::optional<Time> ping_time_;  ///< of the velocity they follow
};

}  // namespace

std::uint8_t waterlinked_crc(std::string_view text) {
  std::uint8_t crc = 0;
  for (const char c : text) crc = kCrc[crc ^ static_cast<std::uint8_t>(c)];
  return crc;
}

std::unique_ptr<Decoder> make_waterlinked_serial(const DecoderSettings& settings) {
  return std::make_unique<WaterLinkedSerial>(settings);
}

}  // namespace leadline::decode
