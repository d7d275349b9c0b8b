#include "core/decode/mavlink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/decode/byte_order.h"
#include "core/decode/frame_search.h"
#include "core/decode/mavlink_frame.h"
#include "core/decode/number.h"
#include "core/decode/pressure_depth.h"

namespace leadline::decode {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kWindowBytes = 16 * 1024;
constexpr std::uint32_t kGpsRawInt = 24, kAttitude = 30, kScaledPressure2 = 137, kGpsInput = 232;
constexpr std::int64_t kFresh_ns = 5'000'000'000;

/// A payload with the zeros that version 2 cuts off.
class Payload {
 public:
  explicit Payload(Bytes sent) { std::copy(sent.begin(), sent.end(), bytes_.begin()); }
  [[nodiscard]] std::uint8_t u8(std::size_t at) const { return bytes_[at]; }
  [[nodiscard]] std::uint16_t u16(std::size_t at) const { return le_u16(bytes_, at); }
  [[nodiscard]] std::int32_t i32(std::size_t at) const { return le_i32(bytes_, at); }
  [[nodiscard]] double f32(std::size_t at) const { return le_f32(bytes_, at); }

 private:
  std::array<std::uint8_t, 256> bytes_{};
};

bool is_place(double lat_deg, double lon_deg) {
  return std::abs(lat_deg) <= 90.0 && std::abs(lon_deg) <= 180.0 && (lat_deg != 0.0 || lon_deg != 0.0);
}

Geodetic place(double lat_deg, double lon_deg) {
  return {Angle::deg(lat_deg), Angle::deg(lon_deg == 180.0 ? -180.0 : lon_deg)};
}

/// GPS_FIX_TYPE; empty: no fix in three dimensions.
std::optional<GnssQuality> quality_of(std::uint8_t fix_type) {
  switch (fix_type) {
    case 3:
      return GnssQuality::autonomous;
    case 4:
      return GnssQuality::differential;
    case 5:
      return GnssQuality::rtk_float;
    case 6:
      return GnssQuality::rtk_fixed;
    case 8:
      return GnssQuality::precise;
    default:
      return std::nullopt;
  }
}

class Mavlink final : public Decoder, private FrameFormat {
 public:
  Mavlink(const DecoderSettings& settings, const ProfileOptions& profile)
      : reference_(settings.heading_magnetic ? HeadingReference::magnetic_north
                                             : HeadingReference::true_north),
        any_system_(settings.address.empty()),
        system_(parse_digits(settings.address).value_or(256)),
        atmosphere_hpa_(profile.mavlink_atmosphere_hpa),
        depth_(profile.latitude_deg, profile.density_kgm3),
        search_(*this, kWindowBytes) {}

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
  [[nodiscard]] FrameStart start(Bytes rest, bool ended) const override {
    return mavlink_start(rest, !bare_, ended);
  }
  void lost(const FrameReport& report) override { out_->frame(report); }

  void frame(std::uint64_t offset, Bytes bytes, const FrameStart& start) override {
    const MavlinkFrame f = read_mavlink_frame(bytes);
    const std::size_t stamp_bytes = f.stamp ? kMavlinkStamp : 0;
    const bool known = find_mavlink(f.id) != nullptr;
    // In a log eight bytes lie between one frame and the next.
    bare_ = bare_ || (!f.stamp && behind_last_ == offset && offset > 0);
    behind_last_ = offset + bytes.size();
    time_ = f.stamp;
    if (time_) out_->fact(time_, ClockReading{"MAVLink", time_->ns, {}});
    FrameReport report{known ? ByteClass::unused : ByteClass::unknown,
                       known ? ChecksumState::ok : ChecksumState::none,
                       start.kind,
                       {},
                       offset + stamp_bytes,
                       static_cast<std::uint32_t>(bytes.size() - stamp_bytes)};
    if (any_system_ || f.system == system_) tell(f, report);
    if (f.stamp) out_->frame({ByteClass::stamp, ChecksumState::none, {}, {}, offset, kMavlinkStamp});
    out_->frame(report);
  }

  void tell(const MavlinkFrame& f, FrameReport& report) {
    const Payload p(f.payload);
    // Version 1 sends a message whole; what comes behind it in version 2 was added later.
    const auto whole = [&](std::size_t bytes) { return f.version == 2 || f.payload.size() >= bytes; };
    switch (f.id) {
      case kAttitude:
        return whole(28) ? tell_attitude(p, report) : refuse("fields", report);
      case kGpsRawInt:
        return whole(30) ? tell_gps_raw(p, report) : refuse("fields", report);
      case kGpsInput:
        return whole(63) ? tell_gps_input(p, report) : refuse("fields", report);
      case kScaledPressure2:
        return whole(14) ? tell_pressure(p, report) : refuse("fields", report);
      default:
        return;
    }
  }

  static void refuse(std::string_view reason, FrameReport& report) {
    report.byte_class = ByteClass::refused;
    report.reason = reason;
  }

  void tell_attitude(const Payload& p, FrameReport& report) {
    constexpr double kTurn = 2.0 * kPi + 1e-3, kFastest_rps = 100.0;
    const double roll = p.f32(4), pitch = p.f32(8), yaw = p.f32(12), yaw_rate = p.f32(24);
    const bool legal = std::abs(roll) <= kTurn && std::abs(pitch) <= kPi / 2.0 + 1e-3 &&
                       std::abs(yaw) <= kTurn && std::abs(yaw_rate) <= kFastest_rps;
    if (!legal) return refuse("range", report);
    report.byte_class = ByteClass::decoded;
    out_->fact(time_, Heading{Angle::rad(yaw).wrapped_2pi(), reference_, {}, {}});
    out_->fact(time_, Attitude{Angle::rad(roll), Angle::rad(pitch), {}, {}, {}});
    out_->fact(time_, Rates{yaw_rate});
  }

  void tell_gps_raw(const Payload& p, FrameReport& report) {
    const auto quality = quality_of(p.u8(28));
    if (!quality || input_is_fresh()) return;  // a repeat of GPS_INPUT
    const double lat_deg = p.i32(8) * 1e-7, lon_deg = p.i32(12) * 1e-7;
    if (!is_place(lat_deg, lon_deg)) return refuse("range", report);
    report.byte_class = ByteClass::decoded;
    GnssFix fix;
    fix.position = place(lat_deg, lon_deg);
    fix.quality = *quality;
    if (p.i32(30) != 0) fix.height = EllipsoidHeight{p.i32(30) * 1e-3};
    if (p.u8(29) != 255) fix.satellites = p.u8(29);
    if (p.u16(20) != 65535 && p.u16(20) != 0) fix.hdop = p.u16(20) * 0.01;
    out_->fact(time_, fix);
    if (p.u16(24) == 65535) return;
    Course course;
    course.speed_mps = p.u16(24) * 0.01;
    if (p.u16(26) < 36000) course.course = Angle::deg(p.u16(26) * 0.01);
    out_->fact(time_, course);
  }

  void tell_gps_input(const Payload& p, FrameReport& report) {
    constexpr unsigned kNoHdop = 2, kNoHorizontalVelocity = 8, kNoVerticalVelocity = 16;
    constexpr double kFastest_mps = 1000.0;
    const auto quality = quality_of(p.u8(61));
    if (!quality) return;
    const double lat_deg = p.i32(12) * 1e-7, lon_deg = p.i32(16) * 1e-7;
    const unsigned ignored = p.u16(56);
    const double hdop = p.f32(24), north = p.f32(32), east = p.f32(36), down = p.f32(40);
    const bool moves = (ignored & kNoHorizontalVelocity) == 0;
    if (!is_place(lat_deg, lon_deg)) return refuse("range", report);
    if (moves && !(std::hypot(north, east) <= kFastest_mps)) return refuse("range", report);
    report.byte_class = ByteClass::decoded;
    input_heard_ = true;
    input_at_ns_ = moment_ns();
    GnssFix fix;
    fix.position = place(lat_deg, lon_deg);
    fix.quality = *quality;
    fix.satellites = p.u8(62);
    if ((ignored & kNoHdop) == 0 && std::isfinite(hdop) && hdop > 0.0) fix.hdop = hdop;
    out_->fact(time_, fix);
    // Who only knows positions leaves the velocity at zero without saying so.
    if (!moves || (north == 0.0 && east == 0.0)) return;
    Course course;
    course.speed_mps = std::hypot(north, east);
    course.course = Angle::rad(std::atan2(east, north)).wrapped_2pi();
    if ((ignored & kNoVerticalVelocity) == 0 && std::abs(down) <= kFastest_mps) course.vel_down_mps = down;
    out_->fact(time_, course);
  }

  void tell_pressure(const Payload& p, FrameReport& report) {
    constexpr double kPascalPerHectopascal = 100.0, kMost_hpa = 1e6;
    const double absolute_hpa = p.f32(4);
    if (!(absolute_hpa > 0.0 && absolute_hpa <= kMost_hpa)) return refuse("range", report);
    report.byte_class = ByteClass::decoded;
    out_->fact(time_, Pressure{absolute_hpa * kPascalPerHectopascal - kStandardAtmosphere_pa});
    if (const auto note = depth_.note()) out_->fact(time_, *note);
    const double gauge_pa = (absolute_hpa - atmosphere_hpa_) * kPascalPerHectopascal;
    out_->fact(time_, DepthMeasured{Depth{depth_.metres(gauge_pa)}, {}});
  }

  [[nodiscard]] std::optional<std::int64_t> moment_ns() const {
    if (time_) return time_->ns;
    return arrival_ ? std::optional(arrival_->ns) : std::nullopt;
  }
  [[nodiscard]] bool input_is_fresh() const {
    const auto now = moment_ns();
    return input_heard_ && (!now || !input_at_ns_ || std::abs(*now - *input_at_ns_) <= kFresh_ns);
  }

  HeadingReference reference_;
  bool any_system_;
  std::uint32_t system_;
  double atmosphere_hpa_;
  PressureDepth depth_;
  FrameSearch search_;
  std::optional<Arrival> arrival_;
  std::optional<Time> time_;  ///< of the frame being read
  bool bare_ = false;  ///< a stream without stamps: what looks like one is the tail of something broken
  std::uint64_t behind_last_ = 0;
  bool input_heard_ = false;
  std::optional<std::int64_t> input_at_ns_;
  DecoderOutput* out_ = nullptr;  ///< of the call under way
};

}  // namespace

std::unique_ptr<Decoder> make_mavlink(const DecoderSettings& settings, const ProfileOptions& profile) {
  return std::make_unique<Mavlink>(settings, profile);
}

}  // namespace leadline::decode
