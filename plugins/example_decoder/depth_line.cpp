// A whole decoder plugin: options, decoder, and the root object the program loads.

#include <QObject>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

#include "core/flow/decoder.h"
#include "plugins/sdk/decoder_plugin.h"

namespace leadline::example {
namespace {

/// The keys this decoder adds to its [[source]].
struct DepthLineOptions {
  std::string unit_id;           ///< two digits; empty: any
  double metres_per_unit = 1.0;  ///< of the value as sent
};

/// Lines of an intelligent pressure gauge on a shared wire: `*ddssVALUE<CR><LF>` or <LF>, dd the two digits
/// of whom it is for, ss of who speaks, VALUE a decimal number: "*000112.345" is gauge 01 at 12.345 m. There
/// is no checksum, so everything else about a line must be right.
class DepthLine final : public Decoder {
 public:
  explicit DepthLine(DepthLineOptions options);
  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival, DecoderOutput& out) override;
  void finish(DecoderOutput& out) override;

 private:
  void close(DecoderOutput& out);
  void report(ByteClass byte_class, std::string_view reason, DecoderOutput& out);
  void report_skipped(DecoderOutput& out);

  DepthLineOptions options_;
  std::array<char, 32> line_{};  // from "*" on
  std::uint32_t size_ = 0, skipped_ = 0;
  std::uint64_t offset_ = 0;  // of the first byte not reported yet
};

constexpr double kShallowest_m = -10.0, kDeepest_m = 12000.0;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Digits with at most one sign before and one point within; no blanks, exponents, "inf" or "nan".
std::optional<double> decimal(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  const std::string_view digits = text.substr(!text.empty() && text[0] == '-' ? 1 : 0);
  if (digits.empty() || !is_digit(digits.front()) || !is_digit(digits.back())) return std::nullopt;
  if (std::count(digits.begin(), digits.end(), '.') > 1) return std::nullopt;
  if (!std::all_of(digits.begin(), digits.end(), [](char c) { return is_digit(c) || c == '.'; }))
    return std::nullopt;
  double value = 0.0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

DepthLine::DepthLine(DepthLineOptions options) : options_(std::move(options)) {}

void DepthLine::feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) {
  for (const std::uint8_t byte : bytes) {
    const char c = static_cast<char>(byte);
    if (c == '*') {
      if (size_ > 0) report(ByteClass::refused, "torn", out);
      report_skipped(out);
    } else if (size_ == 0) {
      if (++skipped_ == std::numeric_limits<std::uint32_t>::max()) report_skipped(out);
      continue;
    }
    line_[size_++] = c;
    if (c == '\n')
      close(out);
    else if (size_ == line_.size())
      report(ByteClass::refused, "oversize", out);
  }
}

void DepthLine::finish(DecoderOutput& out) {
  if (size_ > 0) report(ByteClass::refused, "truncated", out);
  report_skipped(out);
}

void DepthLine::close(DecoderOutput& out) {
  std::string_view line(line_.data(), size_ - 1);  // a log may have kept <LF> alone
  if (line.ends_with('\r')) line.remove_suffix(1);
  const bool framed = line.size() >= 6 && std::all_of(&line_[1], &line_[5], is_digit);
  const auto value = framed ? decimal(line.substr(5)) : std::nullopt;
  if (!value) return report(ByteClass::refused, "syntax", out);
  if (!options_.unit_id.empty() && line.substr(3, 2) != options_.unit_id)
    return report(ByteClass::unused, "", out);
  const double depth_m = *value * options_.metres_per_unit;
  if (!(depth_m >= kShallowest_m && depth_m <= kDeepest_m)) return report(ByteClass::refused, "range", out);
  out.fact(std::nullopt, DepthMeasured{.depth = Depth{depth_m}});
  report(ByteClass::decoded, "", out);
}

void DepthLine::report(ByteClass byte_class, std::string_view reason, DecoderOutput& out) {
  out.frame({.byte_class = byte_class,
             .kind = byte_class == ByteClass::refused ? "" : "depth",
             .reason = reason,
             .offset = offset_,
             .length = size_});
  offset_ += size_;
  size_ = 0;
}

void DepthLine::report_skipped(DecoderOutput& out) {
  if (skipped_ == 0) return;
  out.frame({.byte_class = ByteClass::skipped, .offset = offset_, .length = skipped_});
  offset_ += skipped_;
  skipped_ = 0;
}

struct Settings final : SourceSettings {
  DepthLineOptions options;

  std::vector<BoundKey> keys() override {
    using O = DepthLineOptions;
    static const std::array<Key<O>, 2> keys{{
        {"unit_id", &O::unit_id, "two digits: only this gauge's lines; any, if left out"},
        {"metres_per_unit", &O::metres_per_unit, "of the value as sent", 1e-6, 1e6},
    }};
    return bind(std::span<const Key<O>>(keys), options);
  }
};

}  // namespace

class DepthLinePlugin final : public QObject, public DecoderPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID LEADLINE_DECODER_PLUGIN FILE "leadline_plugin.json")
  Q_INTERFACES(leadline::DecoderPlugin)

 public:
  std::vector<Offer> decoders() const override {
    return {{"depth-line", "lines *ddssVALUE of a pressure gauge (an example)"}};
  }
  std::unique_ptr<SourceSettings> settings(std::string_view) const override {
    return std::make_unique<Settings>();
  }
  Result<std::unique_ptr<Decoder>> make(std::string_view, const DecoderSettings&,
                                        const SourceSettings& settings) const override {
    return std::unique_ptr<Decoder>(
        std::make_unique<DepthLine>(static_cast<const Settings&>(settings).options));
  }
};

}  // namespace leadline::example

#include "depth_line.moc"
