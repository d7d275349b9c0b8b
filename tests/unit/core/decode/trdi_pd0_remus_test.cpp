// The REMUS-600 files against the values their upstream published, raw integer by raw integer.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

#include "core/decode/byte_order.h"
#include "core/decode/trdi_pd0_facts.h"
#include "tests/unit/core/decode/trdi_pd0_samples.h"

namespace leadline::test {
namespace {

using Values = std::vector<double>;
using Record = std::map<std::string, Values>;  ///< key -> one number, or a list of them
constexpr double kSecondsFrom1900To1970 = 2208988800.0;

/// The subset of YAML these files are written in: "  - _index:" opens a record, "key: value" lines follow.
std::vector<Record> read_yml(const std::string& path) {
  std::vector<Record> records;
  std::istringstream in(read_text(path));
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("  - _index", 0) == 0) records.emplace_back();
    if (records.empty() || colon == std::string::npos) continue;
    std::string key = line.substr(0, colon), text = line.substr(colon + 2);
    key.erase(0, key.find_first_not_of(" -"));
    for (char& c : text)
      if (std::string("[],'").find(c) != std::string::npos) c = ' ';
    std::istringstream numbers(text);
    Values values;
    for (double v = 0; numbers >> v;) values.push_back(v);
    if (!values.empty()) records.back()[key] = values;
  }
  return records;
}

/// Raw values of one ensemble under upstream's names.
Record named(const decode::Pd0Ensemble& e) {
  const auto& f = e.fixed;
  const auto& v = e.variable;
  const auto& b = *e.bottom;
  Record r;
  const auto put = [&r](const std::string& key, double value) { r[key] = {value}; };
  const auto bit = [](unsigned byte, unsigned mask) { return (byte & mask) != 0 ? 1.0 : 0.0; };
  put("internal_timestamp", to_unix(*decode::pd0_time(v)) + kSecondsFrom1900To1970);
  put("bin_1_distance", f.bin1_cm), put("cell_length", f.cell_cm), put("num_cells", f.cells),
      put("num_beams", f.beams);
  put("ensemble_number", v.ensemble_number), put("heading", v.heading_cdeg), put("pitch", v.pitch_cdeg);
  put("roll", v.roll_cdeg), put("salinity", v.salinity_ppt), put("temperature", v.temperature_cdegc);
  put("transducer_depth", v.depth_dm), put("sysconfig_vertical_orientation", f.up_facing() ? 1 : 0);
  put("beam_angle", f.beam_angle()), put("blank_after_transmit", f.blank_cm);
  put("coord_transform_beams", f.three_beams_allowed()), put("coord_transform_tilts", f.tilts_used());
  put("coord_transform_mapping", bit(f.coordinate_transform, 1)),
      put("coord_transform_type", static_cast<int>(f.coordinates()));
  put("data_flag", f.simulated), put("error_vel_threshold", f.error_velocity_max_mmps);
  put("false_target_threshold", f.false_target_max), put("firmware_version", f.firmware_version);
  put("firmware_revision", f.firmware_revision), put("heading_alignment", f.heading_alignment_cdeg);
  put("heading_bias", f.heading_bias_cdeg), put("lag_length", f.lag_length),
      put("low_corr_threshold", f.correlation_min);
  put("low_latency_trigger", f.low_latency_trigger), put("num_code_repetitions", f.code_repetitions);
  put("percent_good_min", f.percent_good_min), put("pings_per_ensemble", f.pings);
  put("reference_layer_start", f.reference_layer_start), put("reference_layer_stop", f.reference_layer_stop);
  const std::pair<const char*, unsigned> sensors[] = {{"speed", 0x40},   {"depth", 0x20}, {"heading", 0x10},
                                                      {"pitch", 8},      {"roll", 4},     {"conductivity", 2},
                                                      {"temperature", 1}};
  for (const auto& [name, mask] : sensors) {
    put(std::string("sensor_available_") + name, bit(f.sensors_available, mask));
    put(std::string("sensor_source_") + name, bit(f.sensor_source, mask));
  }
  put("serial_number", *f.serial_number), put("signal_processing_mode", f.processing_mode);
  put("sysconfig_beam_angle", f.system_configuration >> 8 & 3),
      put("sysconfig_beam_config", f.system_configuration >> 12);
  put("sysconfig_beam_pattern", f.convex()), put("sysconfig_frequency", 75 << (f.system_configuration & 7));
  put("sysconfig_head_attached", bit(f.system_configuration, 0x40));
  put("sysconfig_sensor_config", f.system_configuration >> 4 & 3);
  put("time_per_ping_minutes", f.ping_minutes), put("time_per_ping_seconds", f.ping_seconds);
  put("time_per_ping_hundredths", f.ping_hundredths), put("transmit_lag_distance", f.lag_cm);
  const char* adc[] = {"transmit_current", "transmit_voltage", "ambient_temp", "pressure_plus",
                       "pressure_minus",   "attitude_temp",    "attitude",     "contamination_sensor"};
  for (std::size_t i = 0; i < 8; ++i) put(std::string("adc_") + adc[i], v.adc[i]);
  put("bit_result", v.built_in_test), put("error_status_word", *v.error_status),
      put("speed_of_sound", v.sound_speed_mps);
  put("heading_stdev", v.sd_heading_deg), put("pitch_stdev", v.sd_pitch_ddeg),
      put("roll_stdev", v.sd_roll_ddeg);
  put("mpt_minutes", v.min_ping_minutes), put("mpt_seconds", v.min_ping_seconds);
  put("mpt_hundredths", v.min_ping_hundredths), put("transmit_pulse_length", f.pulse_cm);
  const char* components[] = {"forward", "starboard", "vertical", "error"};  // upstream's names for 1 to 4
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string beam = "bt_beam" + std::to_string(i + 1) + "_",
                      component = std::string("bt_") + components[i];
    put(beam + "range", b.range_cm[i]), put(beam + "correlation", b.correlation[i]),
        put(beam + "eval_amp", b.evaluation[i]);
    put(beam + "percent_good", b.percent_good[i]), put(beam + "rssi_amplitude", b.rssi[i]);
    put(beam + "ref_correlation", b.layer_correlation[i]), put(beam + "ref_intensity", b.layer_echo[i]);
    put(beam + "ref_percent_good", b.layer_percent_good[i]);
    put(component + "_velocity", b.velocity_mmps[i]),
        put(component + "_ref_layer_velocity", b.layer_velocity_mmps[i]);
  }
  put("bt_gain", b.gain), put("bt_max_depth", b.max_depth_dm), put("bt_mode", b.mode);
  put("bt_ref_layer_min", b.layer_min_dm), put("bt_ref_layer_near", b.layer_near_dm),
      put("bt_ref_layer_far", b.layer_far_dm);
  put("bt_corr_magnitude_min", b.correlation_min), put("bt_delay_before_reacquire", b.delay);
  put("bt_error_velocity_max", b.error_velocity_max_mmps), put("bt_eval_magnitude_min", b.evaluation_min);
  put("bt_percent_good_min", b.percent_good_min), put("bt_pings_per_ensemble", b.pings);
  const char* water[] = {"water_velocity_east", "water_velocity_north", "water_velocity_up",
                         "error_velocity"};
  const char* good[] = {"percent_good_3beam", "percent_transforms_reject", "percent_bad_beams",
                        "percent_good_4beam"};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t cell = 0; cell < f.cells; ++cell) {
      const std::string beam = "_beam" + std::to_string(i + 1);
      r[water[i]].push_back(e.velocity.velocity_mmps(cell, i));
      r[good[i]].push_back(e.percent_good.count(cell, i));
      r["correlation_magnitude" + beam].push_back(e.correlation.count(cell, i));
      r["echo_intensity" + beam].push_back(e.echo.count(cell, i));
    }
  return r;
}

class Ensembles final : public decode::Pd0FrameSink {
 public:
  std::vector<Record> records;
  std::vector<double> past_the_leader;  ///< what stands where a longer leader has its pressure
  void ensemble(std::uint64_t, std::uint32_t, const decode::Pd0Ensemble& e) override {
    records.push_back(named(e));
    past_the_leader.push_back(decode::le_u32(e.bytes, e.type_offset(1) + 48));
    EXPECT_FALSE(e.variable.pressure_dapa) << "the variable leader ends at 46 bytes";
  }
  void waves(std::uint64_t, std::uint32_t) override { ADD_FAILURE(); }
  void refused(std::uint64_t, std::uint32_t, std::string_view, bool) override { ADD_FAILURE(); }
  void skipped(std::uint64_t, std::uint32_t) override { ADD_FAILURE(); }
};

class Pd0Remus : public testing::TestWithParam<std::pair<const char*, std::size_t>> {};

TEST_P(Pd0Remus, RawIntegersAreThoseUpstreamPublished) {
  const std::string stem = data_path(std::string("dvl_pd0_remus600/") + GetParam().first);
  Ensembles ours;
  decode::Pd0Framer framer(ours);
  framer.feed(read_bytes(stem + ".pd0"));
  framer.finish();
  ASSERT_EQ(ours.records.size(), GetParam().second);
  std::size_t ensembles = 0, compared = 0;
  for (const Record& theirs : read_yml(stem + ".yml")) {
    ensembles += theirs.count("water_velocity_up");  // the record that opens an ensemble's group
    ASSERT_GE(ensembles, 1u);
    ASSERT_LE(ensembles, ours.records.size());
    const Record& mine = ours.records[ensembles - 1];
    for (const auto& [key, values] : theirs) {
      if (key == "_index") continue;
      if (key == "pressure") {  // upstream reads past the leader's end, into the first velocities
        EXPECT_EQ(std::fmod(values[0] + 4294967296.0, 4294967296.0), ours.past_the_leader[ensembles - 1]);
        continue;
      }
      const auto found = mine.find(key);
      ASSERT_NE(found, mine.end()) << key;
      ASSERT_EQ(found->second.size(), values.size()) << key;
      for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(found->second[i], values[i], key == "internal_timestamp" ? 1e-5 : 0.0)
            << key << " of ensemble " << ensembles;
      compared += values.size();
    }
  }
  EXPECT_EQ(ensembles, GetParam().second);
  EXPECT_GT(compared, 200 * ensembles);
  RecordProperty("values_compared", static_cast<int>(compared));
}

INSTANTIATE_TEST_SUITE_P(Files, Pd0Remus,
                         testing::Values(std::pair<const char*, std::size_t>{"adcp_auv_3", 3},
                                         std::pair<const char*, std::size_t>{"adcp_auv_51", 51}),
                         [](const auto& file) { return std::string(file.param.first); });

TEST(Pd0RemusFacts, BytesBeyondAShortLeaderAreNoPressure) {
  const Decoded d = decode_pd0(read_bytes(data_path("dvl_pd0_remus600/adcp_auv_51.pd0")));
  EXPECT_EQ(d.all<Pressure>().size(), 0u);
  EXPECT_EQ(d.all<DepthMeasured>().size(), 0u) << "no depth sensor";
  EXPECT_EQ(d.all<ClockReading>().size(), 51u);
}

}  // namespace
}  // namespace leadline::test
