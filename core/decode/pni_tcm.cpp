#include "core/decode/pni_tcm.h"

#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "core/decode/byte_order.h"
#include "core/decode/frame_search.h"

namespace leadline::decode {
namespace {

using Is = FrameStart::Is;
using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kWindowBytes = 16 * 1024, kShortest = 5, kLongest = 512, kHead = 3;
constexpr Duration kSilence = std::chrono::milliseconds(100);
constexpr std::uint8_t kData = 5;

struct Known {
  std::uint8_t id;
  std::string_view kind;
};
constexpr Known kKnown[] = {{1, "kGetModInfo"},
                            {2, "kGetModInfoResp"},
                            {3, "kSetDataComponents"},
                            {4, "kGetData"},
                            {kData, "kGetDataResp"},
                            {6, "kSetConfig"},
                            {7, "kGetConfig"},
                            {8, "kGetConfigResp"},
                            {9, "kSave"},
                            {10, "kStartCal"},
                            {11, "kStopCal"},
                            {16, "kSaveDone"},
                            {17, "kUserCalSampleCount"},
                            {18, "kUserCalScore"},
                            {19, "kSetConfigDone"},
                            {21, "kStartContinuousMode"},
                            {22, "kStopContinuousMode"},
                            {24, "kSetAcqParams"},
                            {25, "kGetAcqParams"},
                            {26, "kAcqParamsDone"},
                            {27, "kGetAcqParamsResp"}};

std::string_view kind_of(std::uint8_t id) {
  for (const Known& known : kKnown)
    if (known.id == id) return known.kind;
  return {};
}

FrameStart start_of(Bytes b) {
  if (b[0] > kLongest >> 8) return {};
  if (b.size() < kHead) return {Is::unsettled, 0, {}, {}};
  const std::size_t count = be_u16(b, 0);
  if (count < kShortest || count > kLongest || b[2] == 0 || b[2] > 127) return {};
  const std::string_view known = kind_of(b[2]), kind = known.empty() ? "frame" : known;
  if (b[2] == kData) {  // as many components as fit, else half a kilobyte is waited for in vain
    if (b.size() <= kHead) return {Is::unsettled, 0, kind, {}};
    const std::size_t n = b[kHead];
    if (count < 6 + 2 * n || count > 6 + 17 * n) return {};
  }
  if (b.size() < count) return {Is::unsettled, 0, kind, {}};
  if (crc16_xmodem(b.first(count - 2)) != be_u16(b, count - 2)) return {Is::broken, count, kind, "checksum"};
  return {Is::frame, count, kind, {}};
}

/// Of a component's value; 0: not known.
std::size_t size_of(std::uint8_t component) {
  switch (component) {
    case 8:
    case 9:
      return 1;
    case 5:
    case 7:
    case 21:
    case 22:
    case 23:
    case 24:
    case 25:
    case 27:
    case 28:
    case 29:
    case 74:
    case 75:
    case 76:
      return 4;
    case 77:
      return 16;
    default:
      return 0;
  }
}

struct Sample {
  std::optional<double> heading_deg, pitch_deg, roll_deg;
  std::optional<bool> distorted;
};

/// False: more components than bytes.
bool read_sample(Bytes payload, bool little, Sample& s) {
  const auto f32 = [&](std::size_t at) {
    return static_cast<double>(little ? le_f32(payload, at) : be_f32(payload, at));
  };
  std::size_t at = 1;
  for (int left = payload[0]; left > 0; --left) {
    if (at >= payload.size()) return false;
    const std::uint8_t id = payload[at];
    const std::size_t size = size_of(id);
    if (size == 0) return true;  // what follows cannot be told apart
    if (++at + size > payload.size()) return false;
    if (id == 5) s.heading_deg = f32(at);
    if (id == 24) s.pitch_deg = f32(at);
    if (id == 25) s.roll_deg = f32(at);
    if (id == 8) s.distorted = payload[at] != 0;
    at += size;
  }
  return true;
}

bool within(std::optional<double> value, double lowest, double highest) {
  return !value || (*value >= lowest && *value <= highest);  // no NaN is within
}

class PniTcm final : public Decoder, private FrameFormat {
 public:
  explicit PniTcm(const ProfileOptions& profile)
      : little_(profile.pni_byte_order == "little"), search_(*this, kWindowBytes) {}

  void feed(Bytes bytes, std::optional<Arrival> arrival, DecoderOutput& out) override {
    out_ = &out;
    if (arrival && heard_ && *arrival - *heard_ >= kSilence) search_.finish();
    if (arrival && !bytes.empty()) heard_ = arrival;
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
    FrameReport report{ByteClass::decoded,
                       ChecksumState::ok,
                       start.kind,
                       {},
                       offset,
                       static_cast<std::uint32_t>(bytes.size())};
    if (bytes[2] == kData)
      tell(bytes.subspan(kHead, bytes.size() - kHead - 2), report);
    else
      report.byte_class = kind_of(bytes[2]).empty() ? ByteClass::unknown : ByteClass::unused;
    out_->frame(report);
  }

  void tell(Bytes payload, FrameReport& report) {
    Sample s;
    const bool whole = read_sample(payload, little_, s);
    const bool legal = within(s.heading_deg, 0.0, 360.0) && within(s.pitch_deg, -90.0, 90.0) &&
                       within(s.roll_deg, -180.0, 180.0);
    if (!whole || !legal) {
      report.byte_class = ByteClass::refused;
      report.reason = whole ? "range" : "fields";
      return;
    }
    if (s.distorted.value_or(false) && !distorted_)
      out_->fact({}, Health{Health::Level::warning,
                            "the compass reports a distorted magnetic field: its heading is in doubt"});
    distorted_ = s.distorted.value_or(distorted_);
    if (s.heading_deg)
      out_->fact({},
                 Heading{Angle::deg(*s.heading_deg).wrapped_2pi(), HeadingReference::magnetic_north, {}, {}});
    if (s.pitch_deg && s.roll_deg)
      out_->fact({}, Attitude{Angle::deg(*s.roll_deg), Angle::deg(*s.pitch_deg), {}, {}, {}});
  }

  bool little_, distorted_ = false;
  FrameSearch search_;
  std::optional<Arrival> heard_;
  DecoderOutput* out_ = nullptr;  ///< of the call under way
};

constexpr std::array<std::uint16_t, 256> xmodem_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned i = 0; i < 256; ++i) {
    unsigned crc = i << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000) != 0 ? crc << 1 ^ 0x1021 : crc << 1;
    table[i] = static_cast<std::uint16_t>(crc);
  }
  return table;
}

}  // namespace

std::uint16_t crc16_xmodem(Bytes bytes) {
  static constexpr std::array<std::uint16_t, 256> kTable = xmodem_table();
  unsigned crc = 0;
  for (const std::uint8_t b : bytes) crc = (crc << 8 & 0xFFFF) ^ kTable[crc >> 8 ^ b];
  return static_cast<std::uint16_t>(crc);
}

std::unique_ptr<Decoder> make_pni_tcm(const DecoderSettings&, const ProfileOptions& profile) {
  return std::make_unique<PniTcm>(profile);
}

}  // namespace leadline::decode
