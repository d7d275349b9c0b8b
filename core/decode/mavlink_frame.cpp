#include "core/decode/mavlink_frame.h"

#include <algorithm>
#include <array>

#include "core/decode/byte_order.h"

namespace leadline::decode {
namespace {

using Is = FrameStart::Is;
using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t kVersion1 = 0xFE, kVersion2 = 0xFD, kSigned = 1;
constexpr std::size_t kHead1 = 6, kHead2 = 10, kChecksum = 2, kSignature = 13;
constexpr std::uint64_t kFirst_us = 946'684'800'000'000, kLast_us = 4'102'444'800'000'000;  // 2000 to 2100

// Ordered by id.
constexpr MavlinkKind kKinds[] = {{0, 50, "HEARTBEAT"},
                                  {1, 124, "SYS_STATUS"},
                                  {2, 137, "SYSTEM_TIME"},
                                  {4, 237, "PING"},
                                  {20, 214, "PARAM_REQUEST_READ"},
                                  {21, 159, "PARAM_REQUEST_LIST"},
                                  {22, 220, "PARAM_VALUE"},
                                  {23, 168, "PARAM_SET"},
                                  {24, 24, "GPS_RAW_INT"},
                                  {26, 170, "SCALED_IMU"},
                                  {27, 144, "RAW_IMU"},
                                  {29, 115, "SCALED_PRESSURE"},
                                  {30, 39, "ATTITUDE"},
                                  {31, 246, "ATTITUDE_QUATERNION"},
                                  {32, 185, "LOCAL_POSITION_NED"},
                                  {33, 104, "GLOBAL_POSITION_INT"},
                                  {36, 222, "SERVO_OUTPUT_RAW"},
                                  {42, 28, "MISSION_CURRENT"},
                                  {43, 132, "MISSION_REQUEST_LIST"},
                                  {44, 221, "MISSION_COUNT"},
                                  {47, 153, "MISSION_ACK"},
                                  {49, 39, "GPS_GLOBAL_ORIGIN"},
                                  {62, 183, "NAV_CONTROLLER_OUTPUT"},
                                  {65, 118, "RC_CHANNELS"},
                                  {66, 148, "REQUEST_DATA_STREAM"},
                                  {69, 243, "MANUAL_CONTROL"},
                                  {74, 20, "VFR_HUD"},
                                  {76, 152, "COMMAND_LONG"},
                                  {77, 143, "COMMAND_ACK"},
                                  {111, 34, "TIMESYNC"},
                                  {116, 76, "SCALED_IMU2"},
                                  {125, 203, "POWER_STATUS"},
                                  {136, 1, "TERRAIN_REPORT"},
                                  {137, 195, "SCALED_PRESSURE2"},
                                  {147, 154, "BATTERY_STATUS"},
                                  {148, 178, "AUTOPILOT_VERSION"},
                                  {150, 134, "SENSOR_OFFSETS"},
                                  {152, 208, "MEMINFO"},
                                  {158, 134, "MOUNT_STATUS"},
                                  {163, 127, "AHRS"},
                                  {165, 21, "HWSTATUS"},
                                  {173, 83, "RANGEFINDER"},
                                  {178, 47, "AHRS2"},
                                  {193, 71, "EKF_STATUS_REPORT"},
                                  {232, 151, "GPS_INPUT"},
                                  {241, 90, "VIBRATION"},
                                  {242, 104, "HOME_POSITION"},
                                  {251, 170, "NAMED_VALUE_FLOAT"},
                                  {253, 83, "STATUSTEXT"},
                                  {261, 179, "STORAGE_INFORMATION"},
                                  {270, 59, "VIDEO_STREAM_STATUS"},
                                  {321, 88, "PARAM_EXT_REQUEST_LIST"},
                                  {322, 243, "PARAM_EXT_VALUE"}};

bool is_magic(std::uint8_t byte) { return byte == kVersion1 || byte == kVersion2; }

/// Does another frame begin at `at`, as far as can be seen? Empty: too few bytes to tell.
std::optional<bool> goes_on(Bytes b, std::size_t at, bool stamped, bool ended) {
  const std::size_t magic = at + (stamped ? kMavlinkStamp : 0);
  if (b.size() <= magic) return ended ? std::optional(b.size() == at) : std::nullopt;
  if (!is_magic(b[magic])) return false;
  if (!stamped) return true;
  const std::uint64_t us = be_u64(b, at);
  return us >= kFirst_us && us <= kLast_us;
}

/// b begins with a frame's magic byte; at most its length and kind are known when it is unsettled.
FrameStart frame_start(Bytes b, bool stamped, bool ended) {
  constexpr std::string_view kUnknown = "message";
  const std::size_t head = b[0] == kVersion1 ? kHead1 : kHead2;
  if (head == kHead2 && b.size() > 2 && (b[2] & ~kSigned) != 0) return {};  // a flag nobody defines
  if (b.size() < head) return {Is::unsettled, 0, stamped ? kUnknown : "", {}};
  const std::uint32_t id = head == kHead1 ? b[5] : b[7] | b[8] << 8 | b[9] << 16;
  const std::size_t covered = head + b[1];
  const std::size_t whole = covered + kChecksum + (head == kHead2 && (b[2] & kSigned) != 0 ? kSignature : 0);
  const MavlinkKind* const known = find_mavlink(id);
  const std::string_view kind = known ? known->name : kUnknown;
  if (!known && !stamped && (head == kHead1 || id > 0xFFFF)) return {};
  if (b.size() < whole) return {Is::unsettled, 0, known || stamped ? kind : "", {}};
  if (known) {
    const bool holds =
        mavlink_checksum(b.subspan(1, covered - 1), known->checksum_extra) == le_u16(b, covered);
    return holds ? FrameStart{Is::frame, whole, kind, {}} : FrameStart{Is::broken, whole, kind, "checksum"};
  }
  const auto next = goes_on(b, whole, stamped, ended);
  if (!next) return {Is::unsettled, 0, kind, {}};
  if (!*next) return {};
  return {Is::frame, whole, kind, {}};
}

}  // namespace

const MavlinkKind* find_mavlink(std::uint32_t id) {
  const auto found =
      std::lower_bound(std::begin(kKinds), std::end(kKinds), id,
                       [](const MavlinkKind& k, std::uint32_t wanted) { return k.id < wanted; });
  return found != std::end(kKinds) && found->id == id ? found : nullptr;
}

FrameStart mavlink_start(Bytes rest, bool stamps, bool ended) {
  if (is_magic(rest[0])) return frame_start(rest, false, ended);
  if (!stamps || rest[0] != 0) return {};  // until 2248 a stamp begins with 00
  if (rest.size() <= kMavlinkStamp) return {Is::unsettled, 0, {}, {}};
  const std::uint64_t us = be_u64(rest, 0);
  if (us < kFirst_us || us > kLast_us || !is_magic(rest[kMavlinkStamp])) return {};
  FrameStart start = frame_start(rest.subspan(kMavlinkStamp), true, ended);
  if (start.is == Is::frame || start.is == Is::broken) start.length += kMavlinkStamp;
  return start;
}

MavlinkFrame read_mavlink_frame(Bytes b) {
  MavlinkFrame f;
  if (!is_magic(b[0])) {
    f.stamp = Time{static_cast<std::int64_t>(be_u64(b, 0)) * 1000};
    b = b.subspan(kMavlinkStamp);
  }
  f.version = b[0] == kVersion1 ? 1 : 2;
  const std::size_t head = f.version == 1 ? kHead1 : kHead2;
  f.system = b[head == kHead1 ? 3 : 5];
  f.component = b[head == kHead1 ? 4 : 6];
  f.id = head == kHead1 ? b[5] : static_cast<std::uint32_t>(b[7] | b[8] << 8 | b[9] << 16);
  f.payload = b.subspan(head, b[1]);
  return f;
}

std::uint16_t mavlink_checksum(Bytes bytes, std::uint8_t extra) {
  std::uint32_t crc = 0xFFFF;
  const auto add = [&](std::uint8_t byte) {
    std::uint32_t t = byte ^ (crc & 0xFF);
    t = (t ^ t << 4) & 0xFF;
    crc = (crc >> 8 ^ t << 8 ^ t << 3 ^ t >> 4) & 0xFFFF;
  };
  for (const std::uint8_t byte : bytes) add(byte);
  add(extra);
  return static_cast<std::uint16_t>(crc);
}

}  // namespace leadline::decode
