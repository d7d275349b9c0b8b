#include "core/decode/xsens_mtdata2_packet.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/decode/byte_order.h"

namespace leadline::decode {
namespace {

using Is = FrameStart::Is;
using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kLongest = 8 * 1024;

struct Known {
  std::uint8_t id;
  std::string_view kind;
};
constexpr Known kKnown[] = {{kXsensMtData2, "MTData2"}, {0x42, "Error"},
                            {0x3E, "WakeUp"},           {0x3F, "WakeUpAck"},
                            {0x30, "GotoConfig"},       {0x31, "GotoConfigAck"},
                            {0x10, "GotoMeasurement"},  {0x11, "GotoMeasurementAck"}};

std::string_view kind_of(std::uint8_t id) {
  for (const Known& known : kKnown)
    if (known.id == id) return known.kind;
  return "Xbus";
}

enum class Axes : std::uint8_t { enu, ned, nwu };

/// Takes the instrument's axes as the packet has them to forward-starboard-down.
Eigen::Matrix3d to_forward_starboard_down(Axes axes) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  if (axes != Axes::ned) m(1, 1) = m(2, 2) = -1.0;
  return m;
}

/// Takes the packet's local axes to north-east-down.
Eigen::Matrix3d to_north_east_down(Axes axes) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  if (axes == Axes::nwu) m(1, 1) = m(2, 2) = -1.0;
  if (axes == Axes::enu) m << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  return m;
}

EulerAngles attitude_of(const Eigen::Matrix3d& as_sent, Axes axes) {
  return Rotation<Ned, Instrument>(to_north_east_down(axes) * as_sent * to_forward_starboard_down(axes))
      .euler();
}

std::size_t size_of_number(unsigned format) {
  constexpr std::size_t kSizes[] = {4, 4, 6, 8};
  return kSizes[format];
}

double number(Bytes b, std::size_t at, unsigned format) {
  switch (format) {
    case 0:
      return be_f32(b, at);
    case 1:
      return static_cast<std::int32_t>(be_u32(b, at)) * 0x1p-20;
    case 2:  // the fraction comes first
      return static_cast<std::int16_t>(be_u16(b, at + 4)) + be_u32(b, at) * 0x1p-32;
    default:
      return be_f64(b, at);
  }
}

/// One item of a packet.
struct Item {
  std::uint16_t id = 0;
  Bytes value;

  [[nodiscard]] unsigned format() const { return id & 3; }
  [[nodiscard]] std::uint16_t group() const { return id & 0xF8F0; }
  /// nullopt: a code that is not in use.
  [[nodiscard]] std::optional<Axes> axes() const {
    const unsigned code = id >> 2 & 3;
    return code == 3 ? std::nullopt : std::optional(static_cast<Axes>(code));
  }
};

/// What is read of a packet before its halves are put together.
class Reader {
 public:
  explicit Reader(XsensPacket& packet) : packet_(packet) {}

  void take(const Item& item) {
    switch (item.group()) {
      case 0x1010:
        if (sized(item, 12)) take_utc(item.value);
        break;
      case 0x1020:
        if (sized(item, 2)) packet_.counter = be_u16(item.value, 0);
        break;
      case 0x1060:
        if (sized(item, 4)) packet_.ticks = be_u32(item.value, 0);
        break;
      case 0x2010:
        if (const auto q = numbers<4>(item)) take_quaternion(*q, *item.axes());
        break;
      case 0x2030:
        if (const auto e = numbers<3>(item)) take_euler(*e, *item.axes());
        break;
      case 0x4020:
        take_vector(item, packet_.specific_force_mps2);
        break;
      case 0x8020:
        take_vector(item, packet_.rate_rps);
        break;
      case 0x5040:
        if (const auto p = numbers<2>(item)) take_position(*p);
        break;
      case 0xE020:
        if (sized(item, 4)) packet_.status = be_u32(item.value, 0);
        break;
      default:
        break;
    }
  }
  void refuse(std::string_view reason) {
    if (refusal_.empty()) refusal_ = reason;
  }
  [[nodiscard]] std::string_view refusal() const { return refusal_; }

 private:
  bool sized(const Item& item, std::size_t size) {
    if (item.value.size() != size) refuse("fields");
    return item.value.size() == size;
  }

  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(const Item& item) {
    const std::size_t each = size_of_number(item.format());
    if (!item.axes() || !sized(item, N * each)) return refuse("fields"), std::nullopt;
    std::array<double, N> values;
    for (std::size_t i = 0; i < N; ++i) {
      values[i] = number(item.value, i * each, item.format());
      if (!std::isfinite(values[i])) return refuse("range"), std::nullopt;
    }
    return values;
  }

  void take_utc(Bytes v) {
    if ((v[11] & 4) == 0) return;
    const std::uint32_t ns = be_u32(v, 0);
    if (ns >= 1'000'000'000) return refuse("range");
    packet_.utc = from_civil({be_u16(v, 4), v[6], v[7], v[8], v[9], v[10], static_cast<std::int32_t>(ns)});
    if (!packet_.utc) refuse("range");
  }

  void take_quaternion(const std::array<double, 4>& q, Axes axes) {
    const Eigen::Quaterniond sent(q[0], q[1], q[2], q[3]);
    if (!(std::abs(sent.norm() - 1.0) < 0.01)) return refuse("range");
    packet_.attitude = attitude_of(sent.normalized().toRotationMatrix(), axes);
    quaternion_ = true;
  }

  void take_euler(const std::array<double, 3>& e, Axes axes) {
    if (std::abs(e[0]) > 360.0 || std::abs(e[1]) > 90.0 || std::abs(e[2]) > 360.0) return refuse("range");
    if (quaternion_) return;
    const auto sent = Rotation<Ned, Instrument>::zyx({Angle::deg(e[0]), Angle::deg(e[1]), Angle::deg(e[2])});
    packet_.attitude = attitude_of(sent.matrix(), axes);
  }

  void take_vector(const Item& item, std::optional<Vec3<Instrument>>& to) {
    constexpr double kMost = 1e4;  // m/s2 or rad/s: beyond any instrument
    const auto v = numbers<3>(item);
    if (!v) return;
    for (const double component : *v)
      if (std::abs(component) > kMost) return refuse("range");
    const double sign = *item.axes() == Axes::ned ? 1.0 : -1.0;
    to = Vec3<Instrument>{(*v)[0], sign * (*v)[1], sign * (*v)[2]};
  }

  void take_position(const std::array<double, 2>& p) {
    if (std::abs(p[0]) > 90.0 || std::abs(p[1]) > 180.0) return refuse("range");
    packet_.position = Geodetic{Angle::deg(p[0]), Angle::deg(p[1] == 180.0 ? -180.0 : p[1])};
  }

  XsensPacket& packet_;
  bool quaternion_ = false;
  std::string_view refusal_;
};

std::size_t head_of(Bytes message) { return message[3] == 0xFF ? 6 : 4; }

}  // namespace

FrameStart xsens_start(Bytes b) {
  if (b[0] != 0xFA) return {};
  if (b.size() >= 2 && b[1] != 0xFF) return {};
  const std::string_view kind = b.size() >= 3 ? kind_of(b[2]) : "";
  if (b.size() < 4 || b.size() < head_of(b)) return {Is::unsettled, 0, kind, {}};
  const std::size_t head = head_of(b), whole = head + (head == 6 ? be_u16(b, 4) : b[3]) + 1;
  if (whole > kLongest) return {};
  if (b.size() < whole) return {Is::unsettled, 0, kind, {}};
  std::uint32_t sum = 0;
  for (const std::uint8_t byte : b.subspan(1, whole - 1)) sum += byte;
  if ((sum & 0xFF) != 0) return {Is::broken, whole, kind, "checksum"};
  return {Is::frame, whole, kind, {}};
}

Bytes xsens_data(Bytes message) {
  return message.subspan(head_of(message), message.size() - head_of(message) - 1);
}

std::string_view read_xsens_packet(Bytes data, XsensPacket& packet) {
  Reader reader(packet);
  while (!data.empty()) {
    if (data.size() < 3 || data.size() < 3u + data[2]) return "fields";
    reader.take({be_u16(data, 0), data.subspan(3, data[2])});
    data = data.subspan(3u + data[2]);
  }
  return reader.refusal();
}

}  // namespace leadline::decode
