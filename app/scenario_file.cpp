#include "app/scenario_file.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/config/document.h"
#include "core/links/link_address.h"

namespace leadline::app {
namespace {

struct FileOptions {
  std::int64_t version = 1;
};
std::span<const Key<FileOptions>> file_keys() {
  static const std::array<Key<FileOptions>, 1> keys{
      {{"version", &FileOptions::version, "of this format", 1, 1}}};
  return keys;
}

/// A name is written into logs and file names.
bool good_name(const std::string& name) {
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

std::optional<sim::Route> read_route(config::Table& root, const char* name, const sim::Water& water) {
  auto table = root.table(name);
  if (!table.given()) return std::nullopt;
  sim::Route route;
  table.read(bind(sim::body_keys(), route.body));
  auto legs = table.tables("leg");
  for (auto& leg : legs) leg.read(bind(sim::leg_keys(), route.legs.emplace_back()));
  for (const auto& problem : sim::check_route(route, water))
    (problem.leg ? legs[*problem.leg] : table).report(problem.key, problem.text);
  return route;
}

sim::SensorSetup read_sensor(config::Table& table) {
  sim::SensorSetup sensor;
  table.read(bind(sim::sensor_keys(), sensor.options));
  table.table("mount").read(bind(mount_keys(), sensor.mount));
  table.table("mount_error").read(bind(mount_keys(), sensor.mount_error));
  if (table.require("name") && !good_name(sensor.options.name))
    table.report("name", "may hold letters, digits, _ and - only, 64 at most");
  if (!sensor.options.link.empty())
    if (const auto link = links::parse_link(sensor.options.link); !link)
      table.report("link", link.error().line());
  auto faults = table.tables("fault");
  for (auto& fault : faults) {
    fault.read(bind(sim::fault_keys(), sensor.faults.emplace_back()));
    fault.require("kind");
  }
  if (!table.require("kind")) return sensor;
  const auto errors = sim::error_model(sensor.options.kind);
  if (!errors) return sensor;  // said already: it is none of the legal words
  sensor.errors = *errors;
  table.read(sim::error_keys(sensor.errors));
  for (const auto& problem : sim::check_sensor(sensor)) table.report(problem.key, problem.text);
  for (std::size_t i = 0; i < faults.size(); ++i)
    if (const auto problem = sim::check_fault(sensor, sensor.faults[i]))
      faults[i].report(problem->key, problem->text);
  return sensor;
}

void check_bodies(std::vector<config::Table>& tables, const sim::Scenario& scenario) {
  const auto exists = [&](const std::string& body) {
    return body == "ship"     ? scenario.ship.has_value()
           : body == "target" ? scenario.target.has_value()
                              : scenario.vehicle.has_value();
  };
  std::set<std::string> names;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const auto& sensor = scenario.sensors[i];
    if (!names.insert(sensor.options.name).second)
      tables[i].report("name", "is the name of another [[sensor]] already");
    if (!exists(sensor.options.body))
      tables[i].report("body", "there is no [" + sensor.options.body + "] in this scenario");
    const auto* const usbl = std::get_if<sim::UsblOptions>(&sensor.errors);
    if (usbl && !exists(usbl->of)) tables[i].report("of", "there is no [" + usbl->of + "] in this scenario");
  }
}

LoadedScenario read(config::Document document) {
  LoadedScenario loaded;
  sim::Scenario& s = loaded.scenario;
  if (document.ok()) {
    auto root = document.root();
    FileOptions file;
    root.read(bind(file_keys(), file));
    root.require("version");
    auto head = root.table("scenario");
    head.read(bind(sim::scenario_keys(), s.options));
    if (!parse_iso8601(s.options.start_utc))
      head.report("start_utc", "is no time; write it as 2026-11-22T12:00:00Z");
    if (!good_name(s.options.engine)) head.report("engine", "is no engine's name");
    if (!good_name(s.options.name)) head.report("name", "may hold letters, digits, _ and - only, 64 at most");
    root.table("water").read(bind(sim::water_keys(), s.water));
    const sim::Water water(s.water);
    s.vehicle = read_route(root, "vehicle", water);
    s.ship = read_route(root, "ship", water);
    s.target = read_route(root, "target", water);
    if (!(s.options.body == "ship" ? s.ship : s.vehicle))
      head.report("body", "there is no [" + s.options.body + "] in this scenario");
    auto sensors = root.tables("sensor");
    for (auto& table : sensors) s.sensors.push_back(read_sensor(table));
    if (s.sensors.empty()) root.report("sensor", "there is no [[sensor]]; give one for each instrument");
    check_bodies(sensors, s);
    document.finish();
  }
  for (const auto& problem : document.problems()) loaded.problems.push_back(problem.line_text());
  return loaded;
}

}  // namespace

LoadedScenario load_scenario(const std::string& path) { return read(config::Document::load(path)); }

LoadedScenario parse_scenario(const std::string& text, const std::string& file) {
  return read(config::Document::parse(text, file));
}

}  // namespace leadline::app
