#include "core/sim/telegrams/xsens_writer.h"

#include <Eigen/Geometry>
#include <initializer_list>

#include "core/decode/xsens_mtdata2_packet.h"
#include "core/sim/telegrams/binary_writer.h"
#include "core/types/expect.h"
#include "core/types/rotation.h"

namespace leadline::sim {
namespace {

class Packet {
 public:
  Packet(std::uint16_t counter, Time device, Telegrams& out) : out_(out), w_(out, BinaryWriter::Order::big) {
    w_.u8(0xFA), w_.u8(0xFF), w_.u8(decode::kXsensMtData2), w_.u8(0);
    const Civil c = to_civil(device);
    constexpr std::uint64_t kUtcValid = 7;
    head(0x1010, 12);
    w_.u32(static_cast<std::uint64_t>(c.nanosecond)), w_.u16(static_cast<std::uint64_t>(c.year));
    for (const int v : {c.month, c.day, c.hour, c.minute, c.second}) w_.u8(static_cast<std::uint64_t>(v));
    w_.u8(kUtcValid);
    head(0x1020, 2), w_.u16(counter);
  }
  void numbers(std::uint16_t id, std::initializer_list<double> values) {
    head(id, 8 * values.size());
    for (const double v : values) w_.f64(v);
  }
  void seal() {
    head(0xE020, 4), w_.u32(decode::kXsensSelfTest | decode::kXsensFilterValid);
    constexpr std::size_t kHead = 4, kLength = 3;
    LL_EXPECT(w_.written(kHead).size() < 255);
    out_.bytes[out_.bytes.size() - w_.written().size() + kLength] =
        static_cast<char>(w_.written(kHead).size());
    unsigned sum = 0;
    for (const std::uint8_t byte : w_.written(1)) sum += byte;
    w_.u8(0x100 - (sum & 0xFF));
    out_.end();
  }

 private:
  void head(std::uint16_t id, std::size_t size) { w_.u16(id), w_.u8(size); }
  Telegrams& out_;
  BinaryWriter w_;
};

}  // namespace

void write_xsens(std::uint16_t counter, Time device, const AttitudeMeasurement& m, Telegrams& out) {
  Eigen::Matrix3d C_enu_ned, C_frd_fpu = Eigen::Matrix3d::Identity();  // axes forward-port-up
  C_enu_ned << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  C_frd_fpu(1, 1) = C_frd_fpu(2, 2) = -1.0;
  const Eigen::Quaterniond q(
      Eigen::Matrix3d(C_enu_ned * Rotation<Ned, Instrument>::zyx(m.attitude).matrix() * C_frd_fpu));
  Packet packet(counter, device, out);
  packet.numbers(0x2013, {q.w(), q.x(), q.y(), q.z()});
  packet.numbers(0x8023, {0.0, 0.0, -m.rate_z_rps});
  packet.seal();
}

void write_xsens(std::uint16_t counter, Time device, const ImuSample& s, Telegrams& out) {
  LL_EXPECT(!s.increments);
  Packet packet(counter, device, out);
  packet.numbers(0x4027, {s.accel.x, s.accel.y, s.accel.z});
  packet.numbers(0x8027, {s.gyro.x, s.gyro.y, s.gyro.z});
  packet.seal();
}

}  // namespace leadline::sim
