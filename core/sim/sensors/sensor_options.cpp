#include "core/sim/sensors/sensor_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace leadline::sim {
namespace {

/// What a kind can speak; the first format and the first sentences are the usual ones.
struct Kind {
  std::string_view name;
  std::vector<std::string_view> formats, sentences;
  std::size_t usual = 1;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> kKinds{
      {"gnss", {"nmea0183", "iec61162-450", "table"}, {"GGA", "RMC", "GNS", "GLL", "VTG", "ZDA", "GST"}, 2},
      {"usbl",
       {"nmea0183", "iec61162-450", "evologics-usbl"},
       {"PSIMSSB-H", "PSIMSSB-N", "PSIMSSB-E", "PSIMSSB-R", "PSIMSSB-U", "PTSAG", "PTSAX"}},
      {"dvl",
       {"trdi-pd0", "trdi-pd4", "trdi-pd6", "waterlinked-serial", "waterlinked-json", "navquest",
        "nortek-dvl", "nmea0183", "iec61162-450", "table"},
       {"VBW"}},
      {"ahrs",
       {"nmea0183", "iec61162-450", "xsens-mtdata2", "table"},
       {"PASHR", "HDT", "THS", "ROT", "PRDID", "PSXN", "XDR"}},
      {"compass", {"nmea0183", "iec61162-450", "pni-tcm", "table"}, {"HDG", "HDM"}},
      {"imu", {"table", "xsens-mtdata2"}, {}, 0},
      {"depth", {"table", "valeport", "paroscientific"}, {}, 0},
      {"altitude", {"nmea0183", "iec61162-450", "table"}, {"DPT", "DBT"}},
  };
  return kKinds;
}

const Kind* find_kind(const std::string& name) {
  const auto found =
      std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.name == name; });
  return found == kinds().end() ? nullptr : &*found;
}

bool one_of(const std::vector<std::string_view>& known, std::string_view text) {
  return std::find(known.begin(), known.end(), text) != known.end();
}

bool is_number(const std::string& text) {
  return !text.empty() && text.size() <= 4 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
}

void check_usbl(const SensorSetup& sensor, const UsblOptions& o, std::vector<SensorProblem>& problems) {
  if (sensor.options.body != "ship")
    problems.push_back({"body", "a USBL transceiver is the ship's: \"ship\""});
  if (o.transponder.empty() || o.transponder.size() > 8 || !is_plain(o.transponder))
    problems.push_back({"transponder", "must be 1 to 8 letters or digits"});
  for (const auto& sentence : sentences_of(sensor))
    if (sentence.substr(0, 3) == "PTS" && (!is_number(o.transponder) || std::stoi(o.transponder) == 0))
      problems.push_back({"transponder", "must be a number from 1 to 9999 for " + sentence});
  if (format_of(sensor) == "evologics-usbl" && !is_number(o.transponder))
    problems.push_back({"transponder", "must be a number for evologics-usbl"});
  if (o.outlier_to_m < o.outlier_from_m) problems.push_back({"outlier_to_m", "is less than outlier_from_m"});
}

}  // namespace

std::span<const Key<SensorOptions>> sensor_keys() {
  using O = SensorOptions;
  static const std::array<Key<O>, 14> keys{{
      {"name", &O::name, "of the source in the log"},
      {"kind",
       &O::kind,
       "what it measures",
       0,
       0,
       {"gnss", "usbl", "dvl", "ahrs", "compass", "imu", "depth", "altitude"}},
      {"body", &O::body, "who carries it", 0, 0, {"vehicle", "ship"}},
      {"format",
       &O::format,
       "how it speaks; left out: as its kind usually does",
       0,
       0,
       {"nmea0183", "iec61162-450", "trdi-pd0", "trdi-pd4", "trdi-pd6", "waterlinked-serial",
        "waterlinked-json", "navquest", "nortek-dvl", "evologics-usbl", "pni-tcm", "xsens-mtdata2",
        "valeport", "paroscientific", "table"}},
      {"sentences", &O::sentences, "of NMEA 0183; left out: the usual ones"},
      {"talker", &O::talker, "of standard sentences; left out: the usual one"},
      {"link", &O::link, "where it is sent with --live; left out: it is not"},
      {"rate_hz", &O::rate_hz, "measurements a second", 1e-4, 2000},
      {"first_s", &O::first_s, "the first measurement, after the start", 0, 1e7},
      {"latency_s", &O::latency_s, "from the measurement until it is heard", 0, 1000},
      {"jitter_s", &O::jitter_s, "scatter of that, one sigma of a half normal", 0, 100},
      {"clock_offset_s", &O::clock_offset_s, "the device's clock minus UTC", -1e6, 1e6},
      {"clock_drift_ppm", &O::clock_drift_ppm, "what that grows by", -1e4, 1e4},
      {"clock_known", &O::clock_known, "the configuration corrects the offset"},
  }};
  return keys;
}

std::span<const Key<FaultOptions>> fault_keys() {
  using O = FaultOptions;
  static const std::array<Key<O>, 12> keys{{
      {"kind",
       &O::kind,
       "what goes wrong",
       0,
       0,
       {"freeze", "sign-flip", "dropout", "jump", "false-fixes", "garbage", "corrupt"}},
      {"from_s", &O::from_s, "after the start", 0, 1e7},
      {"until_s", &O::until_s, "left out: to the end", 0, 1e7},
      {"count", &O::count, "of false fixes", 0, 1e6},
      {"north_m", &O::north_m, "a position's jump", -1e6, 1e6},
      {"east_m", &O::east_m, "a position's jump", -1e6, 1e6},
      {"down_m", &O::down_m, "a depth's jump", -1e4, 1e4},
      {"x_mps", &O::x_mps, "a DVL's jump, forward", -100, 100},
      {"y_mps", &O::y_mps, "a DVL's jump, to starboard", -100, 100},
      {"z_mps", &O::z_mps, "a DVL's jump, down", -100, 100},
      {"heading_deg", &O::heading_deg, "a heading's jump", -360, 360},
      {"bytes", &O::bytes, "of garbage before each telegram", 1, 4096},
  }};
  return keys;
}

std::optional<ErrorModel> error_model(const std::string& kind) {
  if (kind == "gnss") return GnssOptions{};
  if (kind == "usbl") return UsblOptions{};
  if (kind == "dvl") return DvlOptions{};
  if (kind == "ahrs") return AhrsOptions{};
  if (kind == "compass") return CompassOptions{};
  if (kind == "imu") return ImuOptions{};
  if (kind == "depth") return DepthOptions{};
  if (kind == "altitude") return AltitudeOptions{};
  return std::nullopt;
}

std::vector<BoundKey> error_keys(ErrorModel& errors) {
  struct Bind {
    std::vector<BoundKey> operator()(GnssOptions& o) const { return bind(gnss_keys(), o); }
    std::vector<BoundKey> operator()(UsblOptions& o) const { return bind(usbl_keys(), o); }
    std::vector<BoundKey> operator()(DvlOptions& o) const { return bind(dvl_keys(), o); }
    std::vector<BoundKey> operator()(AhrsOptions& o) const { return bind(ahrs_keys(), o); }
    std::vector<BoundKey> operator()(CompassOptions& o) const { return bind(compass_keys(), o); }
    std::vector<BoundKey> operator()(ImuOptions& o) const { return bind(imu_keys(), o); }
    std::vector<BoundKey> operator()(DepthOptions& o) const { return bind(depth_keys(), o); }
    std::vector<BoundKey> operator()(AltitudeOptions& o) const { return bind(altitude_keys(), o); }
  };
  return std::visit(Bind{}, errors);
}

std::string format_of(const SensorSetup& sensor) {
  if (!sensor.options.format.empty()) return sensor.options.format;
  const Kind* const kind = find_kind(sensor.options.kind);
  return kind ? std::string(kind->formats.front()) : "";
}

std::vector<std::string> sentences_of(const SensorSetup& sensor) {
  const Kind* const kind = find_kind(sensor.options.kind);
  const std::string format = format_of(sensor);
  if (!kind || (format != "nmea0183" && format != "iec61162-450")) return {};
  if (!sensor.options.sentences.empty()) return sensor.options.sentences;
  std::vector<std::string> usual(kind->sentences.begin(),
                                 kind->sentences.begin() + static_cast<std::ptrdiff_t>(kind->usual));
  const auto* const gnss = std::get_if<GnssOptions>(&sensor.errors);
  if (gnss && gnss->sigmas_told) usual.insert(usual.begin(), "GST");
  return usual;
}

std::vector<SensorProblem> check_sensor(const SensorSetup& sensor) {
  std::vector<SensorProblem> problems;
  const SensorOptions& o = sensor.options;
  const Kind* const kind = find_kind(o.kind);
  if (!kind) return {{"kind", "is no kind of sensor"}};
  if (!o.format.empty() && !one_of(kind->formats, o.format))
    problems.push_back(
        {"format", fmt::format("a {} speaks {} here", o.kind, fmt::join(kind->formats, ", "))});
  for (const auto& sentence : o.sentences)
    if (!one_of(kind->sentences, sentence))
      problems.push_back({"sentences", fmt::format("a {} does not speak \"{}\"; it speaks {}", o.kind,
                                                   sentence, fmt::join(kind->sentences, ", "))});
  if (!o.talker.empty() && (o.talker.size() != 2 || !is_plain(o.talker) || o.talker[0] == 'P'))
    problems.push_back({"talker", "must be two letters or digits, P not first"});
  if (const auto* imu = std::get_if<ImuOptions>(&sensor.errors))
    if (imu->increments && format_of(sensor) == "xsens-mtdata2")
      problems.push_back({"increments", "xsens-mtdata2 sends rates and accelerations here"});
  if (const auto* usbl = std::get_if<UsblOptions>(&sensor.errors)) check_usbl(sensor, *usbl, problems);
  if (const auto* dvl = std::get_if<DvlOptions>(&sensor.errors))
    if (format_of(sensor) == "trdi-pd0" && dvl->beam_angle_deg != std::floor(dvl->beam_angle_deg))
      problems.push_back({"beam_angle_deg", "must be whole degrees in PD0"});
  if (const auto* dvl = std::get_if<DvlOptions>(&sensor.errors))
    if (dvl->coordinates == "beam" && (format_of(sensor) == "trdi-pd4" || format_of(sensor) == "trdi-pd6"))
      problems.push_back({"coordinates", "only PD0 can send beam coordinates"});
  if (const auto* dvl = std::get_if<DvlOptions>(&sensor.errors))
    if (dvl->coordinates != "instrument" &&
        one_of({"waterlinked-serial", "waterlinked-json", "navquest", "nortek-dvl"}, format_of(sensor)))
      problems.push_back({"coordinates", format_of(sensor) + " sends instrument coordinates only"});
  return problems;
}

std::optional<SensorProblem> check_fault(const SensorSetup& sensor, const FaultOptions& fault) {
  const std::string& kind = sensor.options.kind;
  const bool fixes = kind == "gnss" || kind == "usbl";
  if (fault.until_s && *fault.until_s <= fault.from_s) return SensorProblem{"until_s", "is not after from_s"};
  if (fault.kind == "false-fixes" && !fixes) return SensorProblem{"kind", "false fixes need a gnss or usbl"};
  if (fault.kind == "false-fixes" && fault.count <= 0) return SensorProblem{"count", "how many false fixes?"};
  if (fault.kind == "sign-flip" && kind != "dvl" && kind != "imu" && kind != "ahrs")
    return SensorProblem{"kind", "a sign flip needs a dvl, imu or ahrs"};
  if (fault.kind == "jump" && kind == "imu") return SensorProblem{"kind", "an imu cannot jump"};
  if (fault.kind == "corrupt" && format_of(sensor) == "table")
    return SensorProblem{"kind", "a table has no checksum: a turned bit would pass for data"};
  if (fault.kind == "corrupt" && format_of(sensor) == "trdi-pd6")
    return SensorProblem{"kind", "PD6 has no checksum: a turned bit would pass for data"};
  if (fault.kind == "corrupt" &&
      one_of({"waterlinked-json", "navquest", "paroscientific", "evologics-usbl"}, format_of(sensor)))
    return SensorProblem{"kind", format_of(sensor) + " has no checksum: a turned bit would pass for data"};
  return std::nullopt;
}

}  // namespace leadline::sim
