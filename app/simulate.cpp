#include "app/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <vector>

#include "app/interrupt.h"
#include "app/live_sending.h"
#include "app/magnetic_models.h"
#include "app/scenario_file.h"
#include "app/talk.h"
#include "core/links/link_address.h"
#include "core/sim/simulation.h"
#include "sessions/export/solution_csv.h"

namespace leadline::app {
namespace {

/// A file written through one buffer; remembers whether the disk took it all.
class OutputFile {
 public:
  explicit OutputFile(std::string path)
      : path_(std::move(path)), file_(std::fopen(path_.c_str(), "wb"), std::fclose) {}

  fmt::memory_buffer& buffer() {
    if (buffer_.size() > kBlock) flush();
    return buffer_;
  }
  Result<void> close() {
    flush();
    if (file_ && std::fflush(file_.get()) == 0 && !failed_) return {};
    return Error{"cannot be written", path_, "is the folder writable and the disk not full?"};
  }

 private:
  static constexpr std::size_t kBlock = 1 << 18;
  void flush() {
    if (file_) failed_ |= std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size();
    buffer_.clear();
  }
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  fmt::memory_buffer buffer_;
  bool failed_ = false;
};

void append(fmt::memory_buffer& to, std::string_view text) {
  to.append(text.data(), text.data() + text.size());
}

bool is_line(std::string_view bytes) {
  if (bytes.empty() || bytes.back() != '\n' || bytes.front() == '#') return false;
  const auto end = std::find_if(bytes.begin(), bytes.end(), [](char c) { return c < 0x20 || c > 0x7E; });
  const std::string_view rest = bytes.substr(static_cast<std::size_t>(end - bytes.begin()));
  return (rest == "\r\n" || rest == "\n") && bytes.front() != ' ' && end != bytes.begin();
}

const char* ending_of(const std::string& format) {
  return format == "trdi-pd0"           ? ".pd0"
         : format == "trdi-pd4"         ? ".pd4"
         : format == "trdi-pd6"         ? ".pd6"
         : format == "table"            ? ".csv"
         : format == "waterlinked-json" ? ".json"
         : format == "waterlinked-serial" || format == "navquest" || format == "valeport" ||
                 format == "paroscientific"
             ? ".txt"
         : format == "nortek-dvl" || format == "pni-tcm" || format == "xsens-mtdata2" ? ".bin"
         : format == "evologics-usbl"                                                 ? ".txt"
         : format == "iec61162-450"                                                   ? ".udpbc"
                                                                                      : ".nmea";
}

/// Puts a simulation into its folder.
class FolderOutput final : public sim::SimulationOutput {
 public:
  FolderOutput(const std::string& folder, const sim::Scenario& scenario, sessions::SolutionCsv& truth,
               LiveSending* live)
      : tlog_(folder + "/telegrams.tlog"), truth_(truth), live_(live) {
    for (const auto& sensor : scenario.sensors) {
      names_.push_back(sensor.options.name);
      files_.push_back(std::make_unique<OutputFile>(folder + "/" + sensor.options.name +
                                                    ending_of(sim::format_of(sensor))));
    }
    body_ = scenario.options.body == "ship" ? Body::ship : Body::vehicle;
  }

  void truth(Body body, Time t, const sim::Truth& truth) override {
    Solution s;
    s.engine = body == body_ ? EngineId{0} : static_cast<EngineId>(body == Body::target ? 2 : 1);
    s.position = truth.position;
    s.depth = Depth{truth.depth_m};
    s.roll = truth.attitude.roll, s.pitch = truth.attitude.pitch, s.heading = truth.attitude.heading;
    s.vel_north_mps = truth.v_n.x(), s.vel_east_mps = truth.v_n.y(), s.vel_down_mps = truth.v_n.z();
    truth_.take({.valid = t, .message = s});
  }

  void telegram(std::size_t sensor, Arrival arrival, std::string_view bytes, bool) override {
    if (live_ && !live_->send(sensor, arrival, bytes)) return;  // what was not sent is not kept
    ++frames;
    append(files_[sensor]->buffer(), bytes);
    auto& log = tlog_.buffer();
    fmt::format_to(std::back_inserter(log), "({}.{:06d}) {} ", arrival.ns / 1'000'000'000,
                   arrival.ns % 1'000'000'000 / 1000, names_[sensor]);
    if (is_line(bytes)) return append(log, bytes);
    constexpr char kDigits[] = "0123456789abcdef";
    log.push_back('#');
    for (const char c : bytes) {
      const auto byte = static_cast<std::uint8_t>(c);
      log.push_back(kDigits[byte >> 4]), log.push_back(kDigits[byte & 15]);
    }
    log.push_back('\n');
  }

  bool go_on() override { return !live_ || !interrupted(); }

  Result<void> close() {
    for (auto& file : files_)
      if (auto closed = file->close(); !closed) return closed;
    if (auto closed = truth_.close(); !closed) return closed;
    return tlog_.close();
  }

  std::uint64_t frames = 0;

 private:
  OutputFile tlog_;
  sessions::SolutionCsv& truth_;
  LiveSending* live_;
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<OutputFile>> files_;
  Body body_;
};

Exit failed(const Error& error, Exit exit = Exit::failed) {
  failure(error.line());
  return exit;
}

/// truth.csv first, then one of each further body.
std::vector<std::string> truth_names(const sim::Scenario& scenario) {
  const bool ship = scenario.options.body == "ship";
  std::vector<std::string> names{"truth", ship ? "vehicle_truth" : "ship_truth", "target_truth"};
  if (!scenario.target) names.pop_back();
  if (!(ship ? scenario.vehicle : scenario.ship) && !scenario.target) names.pop_back();
  return names;
}

/// Where whoever listens to the live sensors hears each of them.
std::vector<std::string> receiving_links(const sim::Scenario& scenario) {
  std::vector<std::string> receiving;
  for (const auto& sensor : scenario.sensors) {
    std::string& link = receiving.emplace_back();
    if (sensor.options.link.empty()) continue;
    const auto sending = links::parse_link(sensor.options.link);
    LL_EXPECT(sending.ok());  // checked when the scenario was read
    const auto other = links::receiving_side(sending.value());
    if (other)
      link = other->text();
    else
      note(fmt::format("{} has no link in leadline.toml: name the device at the other end of {} there",
                       sensor.options.name, sensor.options.link));
  }
  return receiving;
}

bool needs_magnetic(const sim::Scenario& scenario) {
  return std::any_of(scenario.sensors.begin(), scenario.sensors.end(), [](const auto& sensor) {
    const auto* const compass = std::get_if<sim::CompassOptions>(&sensor.errors);
    return compass && !compass->declination_deg;
  });
}

}  // namespace

Exit simulate(const SimulateOptions& options) {
  const auto begun = std::chrono::steady_clock::now();
  const LoadedScenario loaded = load_scenario(options.scenario);
  for (const auto& problem : loaded.problems) failure(problem);
  if (!loaded.problems.empty()) return Exit::misused;
  const sim::Scenario& scenario = loaded.scenario;

  if (options.live && std::all_of(scenario.sensors.begin(), scenario.sensors.end(),
                                  [](const auto& sensor) { return sensor.options.link.empty(); }))
    return failed({"no sensor has a link to be sent over", options.scenario,
                   "give each [[sensor]] one: link = \"udp://127.0.0.1:4001\""},
                  Exit::misused);

  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!options.force && fs::exists(options.output + "/telegrams.tlog", ignored))
    return failed({"holds a simulation already", options.output, "give --force to write over it"});
  std::optional<geo::MagneticModel> magnetic;
  if (needs_magnetic(scenario)) {
    auto models = load_magnetic_models();
    if (!models) return failed(models.error());
    magnetic = std::move(models).value();
  }
  const auto names = truth_names(scenario);
  auto truth = sessions::SolutionCsv::create(options.output, names, {});
  if (!truth) return failed(truth.error());

  const auto seed = static_cast<std::uint64_t>(options.seed.value_or(scenario.options.seed));
  sim::Simulation simulation(scenario, seed, magnetic ? &*magnetic : nullptr);
  std::unique_ptr<LiveSending> live;
  if (options.live) {
    catch_interrupts();
    auto opened = LiveSending::open(scenario);
    if (!opened) return failed(opened.error());
    live = std::move(opened).value();
  }
  FolderOutput out(options.output, scenario, truth.value(), live.get());
  OutputFile configuration(options.output + "/leadline.toml");
  append(configuration.buffer(),
         sim::replay_configuration(scenario, simulation.at_start(), receiving_links(scenario)));
  if (const auto closed = configuration.close(); !closed) return failed(closed.error());
  if (live) live->begin();
  simulation.run(out);
  if (live) live->finish();
  if (const auto closed = out.close(); !closed) return failed(closed.error());
  for (std::size_t i = 0; i < names.size(); ++i)  // a truth has no fixes
    fs::remove(options.output + (i == 0 ? "/fixes.csv" : "/" + names[i] + "_fixes.csv"), ignored);

  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  note(fmt::format("{} frames of {} sensors over {} s written to {} in {:.1f} s, seed {}", out.frames,
                   scenario.sensors.size(), scenario.options.duration_s, options.output, wall_s, seed));
  return live && interrupted() ? Exit::interrupted : Exit::done;
}

}  // namespace leadline::app
