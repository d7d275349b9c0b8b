#include "core/decode/evologics_usbl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/decode/frame_search.h"
#include "core/decode/number.h"

namespace leadline::decode {
namespace {

using Is = FrameStart::Is;
using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kWindowBytes = 16 * 1024, kLongestBody = 8 * 1024;
constexpr std::string_view kPrefix = "+++AT:", kPosition = "USBLLONG";
constexpr double kFirstUnix_s = 1e9;  // earlier times count from the device's start
constexpr double kOldest_s = 600.0, kFarthest_m = 20'000.0;

constexpr std::string_view kKnown[] = {
    kPosition,     "USBLANGLES",    "USBLPHYD",   "USBLPHYP",   "RECV",       "RECVIM",
    "RECVIMS",     "RECVPBM",       "RECVSTART",  "RECVEND",    "RECVFAILED", "DELIVERED",
    "FAILED",      "DELIVEREDIM",   "FAILEDIM",   "CANCELEDIM", "BITRATE",    "SRCLEVEL",
    "SENDSTART",   "SENDEND",       "PHYON",      "PHYOFF",     "STATUS",     "CONNECT",
    "CONNECTOPEN", "CONNECTCLOSED", "DISCONNECT", "CHANNEL",    "DROPCNT"};

std::string_view text_of(Bytes b) { return {reinterpret_cast<const char*>(b.data()), b.size()}; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where the body begins and how long it says it is; false: not yet or not at all.
bool read_head(std::string_view text, std::size_t& begin, std::size_t& length) {
  const std::size_t colon = text.find(':', kPrefix.size());
  if (colon == std::string_view::npos) return false;
  const auto digits = parse_digits(text.substr(kPrefix.size(), colon - kPrefix.size()));
  if (!digits) return false;
  begin = colon + 1, length = *digits;
  return true;
}

FrameStart start_of(Bytes rest) {
  constexpr std::string_view kKind = "notification";
  constexpr std::size_t kMostDigits = 5;
  const std::string_view text = text_of(rest.first(std::min(rest.size(), kLongestBody + 64)));
  const std::size_t shown = std::min(text.size(), kPrefix.size());
  if (text.substr(0, shown) != kPrefix.substr(0, shown)) return {};
  std::size_t at = shown;
  while (at < text.size() && at - shown <= kMostDigits && is_digit(text[at])) ++at;
  if (at == text.size()) return {Is::unsettled, 0, shown == kPrefix.size() ? kKind : "", {}};
  std::size_t begin = 0, length = 0;
  if (text[at] != ':' || !read_head(text, begin, length) || length == 0)
    return {Is::broken, at, kKind, "length"};
  if (length > kLongestBody) return {Is::broken, begin, kKind, "too long"};
  // A USBLLONG may count its CR LF.
  const std::string_view body = text.substr(begin, length);
  if (body.size() < length) return {Is::unsettled, 0, kKind, {}};
  if (length > 2 && body.substr(length - 2) == "\r\n" && body.substr(0, kPosition.size()) == kPosition)
    return {Is::frame, begin + length, kKind, {}};
  const std::string_view end = text.substr(begin + length, 2);
  if (end == "\r\n") return {Is::frame, begin + length + 2, kKind, {}};
  if (end.empty() || end == "\r") return {Is::unsettled, 0, kKind, {}};
  return {Is::broken, begin + length, kKind, "length"};
}

struct Position {
  double now_s = 0.0, measured_s = 0.0;
  std::string_view address;
  double east_m = 0.0, north_m = 0.0, up_m = 0.0;
};

/// Why it is refused; empty when it is not.
std::string_view read_position(std::string_view body, Position& p) {
  constexpr std::size_t kFields = 17;
  std::array<std::string_view, kFields> field;
  for (std::size_t i = 0; i < kFields; ++i) {
    const std::size_t comma = body.find(',');
    if (comma == std::string_view::npos && i + 1 < kFields) return "fields";
    field[i] = body.substr(0, comma);
    if (comma != std::string_view::npos) body.remove_prefix(comma + 1);
  }
  std::array<double, kFields> number{};
  for (std::size_t i = 1; i < kFields; ++i) {
    const auto value = parse_number(field[i]);
    if (!value) return "fields";
    number[i] = *value;
  }
  const auto address = parse_digits(field[3]);
  if (!address) return "fields";
  if (*address > 65535) return "range";
  for (std::size_t i = 4; i < 10; ++i)
    if (std::abs(number[i]) > kFarthest_m) return "range";
  for (std::size_t i = 10; i < 13; ++i)
    if (std::abs(number[i]) > 2.0 * kPi) return "range";
  p = {number[1], number[2], field[3], number[7], number[8], number[9]};
  const double age_s = p.now_s - p.measured_s;
  if (p.measured_s < 0.0 || p.now_s > 9e9 || age_s < 0.0 || age_s > kOldest_s) return "range";
  return {};
}

class EvologicsUsbl final : public Decoder, private FrameFormat {
 public:
  explicit EvologicsUsbl(const DecoderSettings& settings)
      : address_(settings.address), search_(*this, kWindowBytes) {}

  void feed(Bytes bytes, std::optional<Arrival> arrival, DecoderOutput& out) override {
    out_ = &out;
    arrival_ = arrival;
    search_.feed(bytes);
  }
  void finish(DecoderOutput& out) override {
    out_ = &out;
    search_.finish();
  }

 private:
  [[nodiscard]] FrameStart start(Bytes rest, bool) const override { return start_of(rest); }
  void lost(const FrameReport& report) override { out_->frame(report); }

  void frame(std::uint64_t offset, Bytes bytes, const FrameStart& start) override {
    FrameReport report{ByteClass::unknown,
                       ChecksumState::none,
                       start.kind,
                       {},
                       offset,
                       static_cast<std::uint32_t>(bytes.size())};
    std::string_view body = text_of(bytes.first(bytes.size() - 2));
    body.remove_prefix(body.find(':', kPrefix.size()) + 1);
    const std::string_view name = body.substr(0, body.find(','));
    for (const std::string_view known : kKnown)
      if (name == known) report.kind = known, report.byte_class = ByteClass::unused;
    if (name == kPosition) tell(body, report);
    out_->frame(report);
  }

  void tell(std::string_view body, FrameReport& report) {
    Position p;
    report.reason = read_position(body, p);
    report.byte_class = report.reason.empty() ? ByteClass::decoded : ByteClass::refused;
    if (!report.reason.empty()) return;
    if (!address_.empty() && p.address != address_) {
      report.byte_class = ByteClass::unused;
      return;
    }
    std::optional<Time> time;
    if (p.measured_s >= kFirstUnix_s) {
      time = from_unix(p.measured_s);
      out_->fact(time, ClockReading{kPosition, from_unix(p.now_s).ns, {}});
    } else if (arrival_) {
      time = arrival_->host() - duration(p.now_s - p.measured_s);
    }
    if (!north_told_)
      out_->fact(time, Health{Health::Level::note,
                              "the EvoLogics turns its positions with a heading of its own, whose north may "
                              "be the magnetic one: see its settings"});
    north_told_ = true;
    out_->fact(time, UsblRelative{p.address, UsblAxes::north_up, p.north_m, p.east_m, 0.0 - p.up_m, {}});
  }

  std::string_view address_;
  FrameSearch search_;
  std::optional<Arrival> arrival_;
  bool north_told_ = false;
  DecoderOutput* out_ = nullptr;  ///< of the call under way
};

}  // namespace

std::unique_ptr<Decoder> make_evologics_usbl(const DecoderSettings& settings) {
  return std::make_unique<EvologicsUsbl>(settings);
}

}  // namespace leadline::decode
