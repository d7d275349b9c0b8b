#include "app/configuration.h"

#include <algorithm>
#include <array>
#include <set>

#include "app/outputs.h"
#include "core/config/document.h"
#include "core/config/render.h"
#include "core/decode/registry.h"

namespace leadline::app {
namespace {

struct FileOptions {
  std::int64_t version = 1;
};
struct VehicleOptions {
  std::string name = "vehicle";
};

std::span<const Key<FileOptions>> file_keys() {
  static const std::array<Key<FileOptions>, 1> keys{
      {{"version", &FileOptions::version, "of this format", 1, 1}}};
  return keys;
}

std::span<const Key<VehicleOptions>> vehicle_keys() {
  static const std::array<Key<VehicleOptions>, 1> keys{
      {{"name", &VehicleOptions::name, "as the screen and exports show it"}}};
  return keys;
}

/// A name is written into logs and file names.
bool good_name(const std::string& name) {
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
}

/// The keys of one decoder's profile.
std::vector<BoundKey> profile_of(const std::string& decoder, decode::ProfileOptions& options) {
  return bind(std::span<const Key<decode::ProfileOptions>>(decode::profile_keys(decoder)), options);
}

SourceConfiguration read_source(config::Table table, const PluginHost& plugins) {
  SourceConfiguration source;
  auto& options = source.options;
  table.read(bind(source_keys(), options));
  auto mount = table.table("mount");
  mount.read(bind(mount_keys(), source.mount));
  if (table.require("name") && !good_name(options.name))
    table.report("name", "may hold letters, digits, _ - and . only, 64 at most");
  if (!table.require("decoder")) return source;
  if (options.decoder == "table") table.read(bind(decode::table_keys(), source.table));
  table.read(profile_of(options.decoder, source.profile));
  source.plugin = plugins.source_settings(options.decoder);
  if (source.plugin) table.read(source.plugin->keys());
  const auto decoder = decoder_of(source, plugins, decoder_settings(options));
  if (!decoder) {
    const Error& e = decoder.error();
    table.report(options.decoder == "table" ? "columns" : "decoder",
                 e.what + (e.remedy.empty() ? "" : "; " + e.remedy));
  }
  return source;
}

void check_engine(config::Table& navigation, const std::string& engine, const PluginHost& plugins) {
  if (plugins.has_engine(engine)) return;
  std::string known;
  for (const auto& offer : plugins.engines()) known += (known.empty() ? "" : ", ") + offer.name;
  navigation.report("engine", "no engine is called \"" + engine + "\"; this build has " + known);
}

void check_names(config::Table& root, const Configuration& configuration) {
  std::set<std::string> names;
  auto tables = root.tables("source");
  for (std::size_t i = 0; i < tables.size(); ++i)
    if (!names.insert(configuration.sources[i].options.name).second)
      tables[i].report("name", "is the name of another [[source]] already");
  auto calibrations = root.tables("calibration");
  for (std::size_t i = 0; i < calibrations.size(); ++i) {
    if (calibrations[i].require("source") && !names.contains(configuration.calibrations[i].source))
      calibrations[i].report("source", "is no [[source]] of this file");
  }
}

void check_initial(config::Table& initial, const InitialOptions& options) {
  if (options.lat_deg.has_value() != options.lon_deg.has_value())
    initial.report(options.lat_deg ? "lat_deg" : "lon_deg", "needs both lat_deg and lon_deg");
  if (options.depth_m && options.ellipsoid_height_m)
    initial.report("ellipsoid_height_m", "stands beside depth_m; give one of them");
}

/// The other decoders that have a profile, a [[source]] of its name each.
std::string profiles(const std::string& shown) {
  std::string text;
  for (const auto& decoder : decode::decoders()) {
    decode::ProfileOptions options;
    const auto keys = profile_of(std::string(decoder.name), options);
    if (keys.empty() || decoder.name == shown) continue;
    SourceOptions source{.name = std::string(decoder.name), .decoder = std::string(decoder.name)};
    std::vector<BoundKey> named;
    for (const auto& key : bind(source_keys(), source))
      if (key.name == "name" || key.name == "decoder") named.push_back(key);
    text += "\n" + config::render("[[source]]", named) + config::render("", keys);
  }
  return text;
}

void check_outputs(config::Table& root, const Configuration& configuration) {
  auto tables = root.tables("output");
  for (std::size_t i = 0; i < tables.size(); ++i)
    for (const auto& problem : check_output(configuration.outputs[i], configuration))
      tables[i].report(problem.key, problem.text);
}

EulerAngles euler(double roll_deg, double pitch_deg, double yaw_deg) {
  return {Angle::deg(roll_deg), Angle::deg(pitch_deg), Angle::deg(yaw_deg)};
}

Body body_named(const std::string& name) {
  return name == "ship" ? Body::ship : name == "target" ? Body::target : Body::vehicle;
}

LoadedConfiguration read(config::Document document, const std::string& file, const PluginHost& plugins) {
  LoadedConfiguration loaded;
  Configuration& c = loaded.configuration;
  c.file = file;
  c.text = document.text();
  c.engine_tables = plugins.engine_tables();
  if (document.ok()) {
    auto root = document.root();
    FileOptions options;
    VehicleOptions vehicle;
    root.read(bind(file_keys(), options));
    root.require("version");
    root.table("vehicle").read(bind(vehicle_keys(), vehicle));
    c.vehicle = vehicle.name;
    auto navigation = root.table("navigation");
    navigation.read(bind(navigation_keys(), c.navigation.navigation));
    check_engine(navigation, c.navigation.navigation.engine, plugins);
    navigation.table("aiding").read(bind(aiding_keys(), c.navigation.aiding));
    for (const auto& table : c.engine_tables.tables()) navigation.table(table.path).read(table.keys);
    auto initial = navigation.table("initial");
    initial.read(bind(initial_keys(), c.navigation.initial));
    check_initial(initial, c.navigation.initial);
    for (auto& table : root.tables("source")) c.sources.push_back(read_source(table, plugins));
    if (c.sources.empty()) root.report("source", "there is no [[source]]; give one for each instrument");
    for (auto& table : root.tables("calibration")) {
      table.read(bind(calibration_keys(), c.calibrations.emplace_back()));
    }
    for (auto& table : root.tables("output")) table.read(bind(output_keys(), c.outputs.emplace_back()));
    check_names(root, c);
    check_outputs(root, c);
    document.finish();
  }
  for (const auto& problem : document.problems()) loaded.problems.push_back(problem.line_text());
  return loaded;
}

}  // namespace

LoadedConfiguration load_configuration(const std::string& path, const PluginHost& plugins) {
  return read(config::Document::load(path), path, plugins);
}

LoadedConfiguration parse_configuration(const std::string& text, const std::string& file,
                                        const PluginHost& plugins) {
  return read(config::Document::parse(text, file), file, plugins);
}

Result<std::unique_ptr<Decoder>> decoder_of(const SourceConfiguration& source, const PluginHost& plugins,
                                            const DecoderSettings& settings) {
  if (source.plugin) return plugins.make_decoder(source.options.decoder, settings, source.plugin);
  return decode::make_decoder(source.options.decoder, settings, source.table, source.profile);
}

std::string example_configuration(const PluginHost& plugins) {
  FileOptions file;
  VehicleOptions vehicle{"MDV-1"};
  NavigationSettings navigation;
  const EngineTables engine_tables = plugins.engine_tables();
  SourceOptions gnss{.name = "gnss", .decoder = "nmea0183", .body = "ship"};
  SourceOptions dvl{.name = "dvl", .decoder = "trdi-pd0"};
  SourceOptions rows{.name = "log", .decoder = "table"};
  MountOptions mount;
  decode::TableOptions table{.columns = {"unix_s", "lat_deg", "lon_deg", "heading_deg", "-"}};
  decode::ProfileOptions profile;
  CalibrationOptions calibration{.source = "dvl"};
  std::string text = "# A Leadline configuration: every key with its default.\n";
  text += config::render("", bind(file_keys(), file));
  text += "\n" + config::render("[vehicle]", bind(vehicle_keys(), vehicle));
  text += "\n" + config::render("[navigation]", bind(navigation_keys(), navigation.navigation));
  for (const auto& own : engine_tables.tables())
    text += "\n" + config::render("[navigation." + own.path + "]", own.keys);
  text += "\n# One sigma a sample where the telegram does not say better; a telegram's own wins.\n";
  text += config::render("[navigation.aiding]", bind(aiding_keys(), navigation.aiding));
  text += "\n# When a position is given here the engines start from it, else from the first fix.\n";
  text += config::render("[navigation.initial]", bind(initial_keys(), navigation.initial));
  text +=
      "\n# One [[source]] for each instrument; the first of several alike is preferred while it is alive.\n";
  text += config::render("[[source]]", bind(source_keys(), gnss));
  text += config::render("", profile_of(gnss.decoder, profile));
  text += "\n" + config::render("[[source]]", bind(source_keys(), dvl));
  text += "\n# v_b = Rz(yaw) Ry(pitch) Rx(roll) v_s\n" +
          config::render("[source.mount]", bind(mount_keys(), mount));
  text += "\n" + config::render("[[source]]", bind(source_keys(), rows));
  text += config::render("", bind(decode::table_keys(), table));
  text += profiles(gnss.decoder);
  text += "\n" + config::render("[[calibration]]", bind(calibration_keys(), calibration));
  OutputOptions output{
      .name = "repeater", .link = "udp://127.0.0.1:10110", .sentences = {"GGA", "RMC", "HDT", "DPT"}};
  text += "\n# Sentences repeated to other instruments while the program runs live.\n";
  text += config::render("[[output]]", bind(output_keys(), output));
  return text;
}

DecoderSettings decoder_settings(const SourceOptions& options) {
  DecoderSettings settings;
  settings.checksum_required = options.checksum != "optional";
  settings.heading_magnetic = options.heading == "magnetic";
  if (!options.date.empty()) {
    // Noon: a time of day is dated to within 12 hours of it, which is this very day.
    if (const auto midnight = parse_date(options.date)) settings.date = *midnight + std::chrono::hours(12);
  }
  settings.address = options.address;
  return settings;
}

std::vector<SourceInfo> source_infos(const Configuration& configuration) {
  std::vector<SourceInfo> infos;
  for (const auto& [options, mount, table, profile, plugin] : configuration.sources) {
    SourceInfo info;
    info.id = static_cast<SourceId>(infos.size());
    info.name = options.name;
    info.body = body_named(options.body);
    info.mount = euler(mount.roll_deg, mount.pitch_deg, mount.yaw_deg);
    info.lever = {mount.x_m, mount.y_m, mount.z_m};
    if (options.declination_deg) info.declination = Angle::deg(*options.declination_deg);
    info.time_offset_ns = duration(options.time_offset_s).count();
    info.gps_time = options.time_scale == "gps";
    info.latency_ns = duration(options.latency_s).count();
    for (const auto& calibration : configuration.calibrations) {
      if (calibration.source != options.name) continue;
      info.calibration = euler(calibration.roll_deg, calibration.pitch_deg, calibration.yaw_deg);
      info.scale = calibration.scale;
    }
    infos.push_back(std::move(info));
  }
  return infos;
}

}  // namespace leadline::app
