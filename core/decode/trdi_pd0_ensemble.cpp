#include "core/decode/trdi_pd0_ensemble.h"

#include "core/decode/byte_order.h"

namespace leadline::decode {
namespace {

using Bytes = std::span<const std::uint8_t>;

// The shortest forms seen: old fixed leaders, a REMUS's variable leader (46), an Explorer's bottom track.
constexpr std::size_t kFixedBytes = 42, kVariableBytes = 42, kBottomBytes = 81, kHighResolutionBytes = 18;

std::array<std::uint8_t, 4> four_u8(Bytes t, std::size_t i) { return {t[i], t[i + 1], t[i + 2], t[i + 3]}; }
std::array<std::int16_t, 4> four_i16(Bytes t, std::size_t i) {
  return {le_i16(t, i), le_i16(t, i + 2), le_i16(t, i + 4), le_i16(t, i + 6)};
}

Pd0FixedLeader read_fixed(Bytes t) {
  Pd0FixedLeader f{};
  f.firmware_version = t[2], f.firmware_revision = t[3];
  f.system_configuration = le_u16(t, 4);
  f.simulated = t[6], f.lag_length = t[7], f.beams = t[8], f.cells = t[9];
  f.pings = le_u16(t, 10), f.cell_cm = le_u16(t, 12), f.blank_cm = le_u16(t, 14);
  f.processing_mode = t[16], f.correlation_min = t[17], f.code_repetitions = t[18],
  f.percent_good_min = t[19];
  f.error_velocity_max_mmps = le_u16(t, 20);
  f.ping_minutes = t[22], f.ping_seconds = t[23], f.ping_hundredths = t[24];
  f.coordinate_transform = t[25];
  f.heading_alignment_cdeg = le_i16(t, 26), f.heading_bias_cdeg = le_i16(t, 28);
  f.sensor_source = t[30], f.sensors_available = t[31];
  f.bin1_cm = le_u16(t, 32), f.pulse_cm = le_u16(t, 34);
  f.reference_layer_start = t[36], f.reference_layer_stop = t[37];
  f.false_target_max = t[38], f.low_latency_trigger = t[39];
  f.lag_cm = le_u16(t, 40);
  if (t.size() >= 58) f.serial_number = le_u32(t, 54);
  if (t.size() >= 59) f.beam_angle_deg = t[58];
  return f;
}

Pd0VariableLeader read_variable(Bytes t) {
  Pd0VariableLeader v{};
  v.ensemble_number = le_u16(t, 2) + 65536u * t[11];
  v.clock = {t[4], t[5], t[6], t[7], t[8], t[9], t[10]};
  v.built_in_test = le_u16(t, 12), v.sound_speed_mps = le_u16(t, 14), v.depth_dm = le_u16(t, 16);
  v.heading_cdeg = le_u16(t, 18), v.pitch_cdeg = le_i16(t, 20), v.roll_cdeg = le_i16(t, 22);
  v.salinity_ppt = le_u16(t, 24), v.temperature_cdegc = le_i16(t, 26);
  v.min_ping_minutes = t[28], v.min_ping_seconds = t[29], v.min_ping_hundredths = t[30];
  v.sd_heading_deg = t[31], v.sd_pitch_ddeg = t[32], v.sd_roll_ddeg = t[33];
  for (std::size_t i = 0; i < v.adc.size(); ++i) v.adc[i] = t[34 + i];
  if (t.size() >= 46) v.error_status = le_u32(t, 42);
  if (t.size() >= 52) v.pressure_dapa = le_i32(t, 48);
  if (t.size() >= 65)
    v.century = t[57],
    v.clock_y2k = Pd0VariableLeader::Clock{t[58], t[59], t[60], t[61], t[62], t[63], t[64]};
  return v;
}

Pd0BottomTrack read_bottom(Bytes t) {
  Pd0BottomTrack b{};
  b.pings = le_u16(t, 2), b.delay = le_u16(t, 4);
  b.correlation_min = t[6], b.evaluation_min = t[7], b.percent_good_min = t[8], b.mode = t[9];
  b.error_velocity_max_mmps = le_u16(t, 10);
  for (std::size_t i = 0; i < 4; ++i) b.range_cm[i] = le_u16(t, 16 + 2 * i) + 65536u * t[77 + i];
  b.velocity_mmps = four_i16(t, 24);
  b.correlation = four_u8(t, 32), b.evaluation = four_u8(t, 36), b.percent_good = four_u8(t, 40);
  b.layer_min_dm = le_u16(t, 44), b.layer_near_dm = le_u16(t, 46), b.layer_far_dm = le_u16(t, 48);
  b.layer_velocity_mmps = four_i16(t, 50);
  b.layer_correlation = four_u8(t, 58), b.layer_echo = four_u8(t, 62), b.layer_percent_good = four_u8(t, 66);
  b.max_depth_dm = le_u16(t, 70);
  b.rssi = four_u8(t, 72);
  b.gain = t[76];
  return b;
}

Pd0Profile read_profile(Bytes t, std::size_t cells, std::size_t value_bytes) {
  const std::size_t length = 4 * cells * value_bytes;
  return {t.size() >= 2 + length ? t.subspan(2, length) : Bytes{}};
}

bool offsets_increase(const Pd0Ensemble& e) {
  std::size_t previous = 6 + 2 * e.types() - 1;
  for (std::size_t i = 0; i < e.types(); ++i) {
    const std::size_t offset = e.type_offset(i);
    if (offset <= previous || offset + 2 > e.bytes.size()) return false;
    if (i > 0 && offset < previous + 2) return false;  // room for the id before it
    previous = offset;
  }
  return true;
}

}  // namespace

int Pd0FixedLeader::beam_angle() const {
  if (beam_angle_deg && *beam_angle_deg > 0 && *beam_angle_deg <= 60) return *beam_angle_deg;
  constexpr std::array<int, 4> kByConfiguration = {15, 20, 30, 0};
  return kByConfiguration[system_configuration >> 8 & 3];
}

std::int16_t Pd0Profile::velocity_mmps(std::size_t cell, std::size_t beam) const {
  return le_i16(values, 2 * (4 * cell + beam));
}

std::size_t Pd0Ensemble::type_offset(std::size_t i) const { return le_u16(bytes, 6 + 2 * i); }

std::span<const std::uint8_t> Pd0Ensemble::type(std::size_t i) const {
  const std::size_t start = type_offset(i), end = i + 1 < types() ? type_offset(i + 1) : bytes.size();
  return bytes.subspan(start, end - start);
}

std::optional<Pd0Ensemble> read_pd0_ensemble(Bytes bytes) {
  Pd0Ensemble e{};
  e.bytes = bytes;
  if (bytes.size() < 6 || bytes.size() < 6 + 2 * e.types() || !offsets_increase(e)) return std::nullopt;
  bool fixed = false, variable = false;
  for (std::size_t i = 0; i < e.types(); ++i) {
    const Bytes t = e.type(i);
    switch (le_u16(t, 0)) {
      case 0x0000:
        if (t.size() < kFixedBytes) return std::nullopt;
        e.fixed = read_fixed(t), fixed = true;
        break;
      case 0x0080:
        if (t.size() < kVariableBytes) return std::nullopt;
        e.variable = read_variable(t), variable = true;
        break;
      case 0x0600:
        if (t.size() < kBottomBytes) return std::nullopt;
        e.bottom = read_bottom(t);
        break;
      case 0x5803:
        if (t.size() < kHighResolutionBytes) return std::nullopt;
        e.high_resolution = {le_i32(t, 2), le_i32(t, 6), le_i32(t, 10), le_i32(t, 14)};
        break;
      default:
        break;
    }
  }
  if (!fixed || !variable) return std::nullopt;
  for (std::size_t i = 0; i < e.types();
       ++i) {  // again: their size is the fixed leader's, which may come later
    const Bytes t = e.type(i);
    switch (le_u16(t, 0)) {
      case 0x0100:
        e.velocity = read_profile(t, e.fixed.cells, 2);
        break;
      case 0x0200:
        e.correlation = read_profile(t, e.fixed.cells, 1);
        break;
      case 0x0300:
        e.echo = read_profile(t, e.fixed.cells, 1);
        break;
      case 0x0400:
        e.percent_good = read_profile(t, e.fixed.cells, 1);
        break;
      default:
        break;
    }
  }
  return e;
}

}  // namespace leadline::decode
