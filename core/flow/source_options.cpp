#include "core/flow/source_options.h"

#include <array>

namespace leadline {

std::span<const Key<SourceOptions>> source_keys() {
  using O = SourceOptions;
  static const std::array<Key<O>, 13> keys{{
      {"name", &O::name, "the instrument's name; inputs and results use it"},
      {"link", &O::link, "where its bytes come from live; may be left out where the input is a log"},
      {"decoder", &O::decoder, "the wire format, see `leadline list decoders`"},
      {"body", &O::body, "what it is fixed to", 0, 0, {"vehicle", "ship", "target"}},
      {"checksum",
       &O::checksum,
       "optional: accept telegrams that carry none",
       0,
       0,
       {"required", "optional"}},
      {"heading",
       &O::heading,
       "what the device's heading means (HDM and HDG are magnetic by themselves)",
       0,
       0,
       {"true", "magnetic"}},
      {"declination_deg", &O::declination_deg,
       "east positive; instead of the world magnetic model at place and date", -180, 180},
      {"time_scale", &O::time_scale, "the time the device's clock runs on", 0, 0, {"utc", "gps"}},
      {"time_offset_s", &O::time_offset_s, "added to the device's clock"},
      {"latency_s", &O::latency_s, "time of validity = arrival - latency where the device gives no time", 0,
       3600},
      {"rate_hz", &O::rate_hz, "rate of a byte stream without times of its own; 0: not used", 0, 100000},
      {"date", &O::date, "YYYY-MM-DD of a recording that holds times of day only"},
      {"address", &O::address,
       "which transponder, MMSI, SFI or bus address is this body's; any, if left out"},
  }};
  return keys;
}

std::span<const Key<MountOptions>> mount_keys() {
  using O = MountOptions;
  static const std::array<Key<O>, 6> keys{{
      {"roll_deg", &O::roll_deg, "starboard side down positive", -180, 180},
      {"pitch_deg", &O::pitch_deg, "bow up positive", -90, 90},
      {"yaw_deg", &O::yaw_deg, "clockwise seen from above positive", -360, 360},
      {"x_m", &O::x_m, "forward of the body's reference point", -1000, 1000},
      {"y_m", &O::y_m, "to starboard of it", -1000, 1000},
      {"z_m", &O::z_m, "below it", -1000, 1000},
  }};
  return keys;
}

std::span<const Key<CalibrationOptions>> calibration_keys() {
  using O = CalibrationOptions;
  static const std::array<Key<O>, 5> keys{{
      {"source", &O::source, "the [[source]] it belongs to"},
      {"yaw_deg", &O::yaw_deg, "added to the mount's yaw", -360, 360},
      {"roll_deg", &O::roll_deg, "added to the mount's roll", -180, 180},
      {"pitch_deg", &O::pitch_deg, "added to the mount's pitch", -90, 90},
      {"scale", &O::scale, "reference distance over DVL distance, near 1", 0.5, 2.0},
  }};
  return keys;
}

std::span<const Key<OutputOptions>> output_keys() {
  using O = OutputOptions;
  static const std::array<Key<O>, 8> keys{{
      {"name", &O::name, "its name in events and alarms"},
      {"link", &O::link, "where it goes"},
      {"format", &O::format, "plain sentences, or datagrams of them", 0, 0, {"nmea0183", "iec61162-450"}},
      {"sfi", &O::sfi, "who iec61162-450 says is speaking: two letters and four digits"},
      {"destination", &O::destination, "the SFI that iec61162-450 names as receiver; left out: none"},
      {"sentences",
       &O::sentences,
       "which sentences",
       0,
       0,
       {"GGA", "RMC", "HDT", "DPT", "GLL", "VTG", "ZDA", "THS", "ROT", "GST"}},
      {"rate_hz", &O::rate_hz, "how often; the program ticks ten times a second", 0.01, 10},
      {"body", &O::body, "whose position", 0, 0, {"vehicle", "ship"}},
  }};
  return keys;
}

}  // namespace leadline
