#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "app/configuration.h"
#include "app/console.h"
#include "app/export.h"
#include "app/info.h"
#include "app/list.h"
#include "app/plugins.h"
#include "app/record.h"
#include "app/replay.h"
#include "app/simulate.h"
#include "app/talk.h"

namespace {

using namespace leadline::app;
using leadline::PluginHost;

int status(Exit exit) { return static_cast<int>(exit); }

Exit check_config(const std::string& path, const PluginHost& plugins) {
  const auto loaded = load_configuration(path, plugins);
  for (const auto& problem : loaded.problems) failure(problem);
  if (!loaded.problems.empty()) return Exit::misused;
  fmt::print("{}: ok, {} sources, engine {}\n", path, loaded.configuration.sources.size(),
             loaded.configuration.navigation.navigation.engine);
  return Exit::done;
}

int run(int argc, char** argv) {
  CLI::App program{"Leadline: the operator's ground station for underwater vehicles."};
  program.set_version_flag("--version", std::string("leadline ") + LEADLINE_VERSION);
  program.fallthrough();
  program.require_subcommand(0, 1);
  program.footer("Example: leadline replay dvl=winriver01.PD0 --config boat.toml --csv out");

  bool quiet = false, verbose = false, example_config = false;
  std::string config_to_check;
  ReplayOptions replaying;
  replaying.progress = isatty(STDERR_FILENO) == 1;
  program.add_flag("--quiet", quiet, "say errors only");
  program.add_flag("--verbose", verbose, "say every change of availability");
  program.add_flag("--progress,!--no-progress", replaying.progress, "a bar; default: on a terminal");
  program
      .add_option("--plugin-path", replaying.plugin_paths,
                  "a folder with more plugins; may be given several times")
      ->type_name("DIR")
      ->allow_extra_args(false);
  program.add_flag("--force", replaying.force, "replace an output that exists");
  program.add_option("--check-config", config_to_check, "check a configuration and leave")->type_name("FILE");
  program.add_flag("--example-config", example_config, "print a complete configuration and leave");

  auto* replay_verb = program.add_subcommand("replay", "logs through decoders and engines, headless");
  replay_verb
      ->add_option("INPUT", replaying.inputs,
                   "a log, or source=FILE for one instrument's bytes; several are one timeline")
      ->required();
  replay_verb->add_option("--config", replaying.config, "the configuration (TOML); a session carries its own")
      ->type_name("FILE");
  replay_verb->add_option("--engine", replaying.engines, "which engine; may be given several times")
      ->type_name("NAME")
      ->allow_extra_args(false);
  replay_verb->add_option("--session", replaying.session, "keep everything in this session file")
      ->type_name("FILE");
  replay_verb
      ->add_option("--csv", replaying.csv, "write <engine>.csv, fixes.csv, ship.csv, summary.json there")
      ->type_name("DIR");
  replay_verb->add_option("--speed", replaying.speed, "max, or a factor of real time")
      ->type_name("max|N")
      ->capture_default_str();
  replay_verb->footer(
      "Example: leadline replay s330=s330.txt gyr1=gyr1.txt --config ship.toml --engine fusion --csv out");

  ConsoleOptions showing;
  auto* console_verb = program.add_subcommand("console", "the operator's console; also without a verb");
  console_verb
      ->add_option("--config", showing.config,
                   "live on the links of its sources; with a session that is there, its names only")
      ->type_name("FILE");
  console_verb
      ->add_option("--session", showing.session,
                   "show this session, paused at its end; one that is not there yet records the live run")
      ->type_name("FILE");
  console_verb->add_option("--screenshot", showing.screenshot, "save a picture and leave; needs no display")
      ->type_name("PNG");
  console_verb
      ->add_option("--after", showing.after_s,
                   "seconds of session time from its start; default its end, live 3 s")
      ->check(CLI::NonNegativeNumber)
      ->type_name("S");
  console_verb->add_option("--size", showing.size, "of the window")->type_name("WxH")->capture_default_str();
  console_verb->add_option("--palette", showing.palette, "day, dusk or night; default the last one")
      ->check(CLI::IsMember({"day", "dusk", "night"}));
  console_verb
      ->add_option("--chart", showing.charts,
                   "a GeoTIFF or MBTiles below everything; may be given several times")
      ->type_name("FILE")
      ->allow_extra_args(false);
  console_verb->footer(
      "Example: leadline console --session dive.leadline --palette night --screenshot dive.png");

  RecordOptions recording;
  auto* record_verb = program.add_subcommand("record", "a live run without a window, stored in a session");
  record_verb->add_option("--config", recording.config, "a configuration whose sources have links")
      ->required()
      ->type_name("F");
  record_verb
      ->add_option("--session", recording.session,
                   "a session file to begin or, with a gap mark, to continue; a new one each 24 h or 2 GiB")
      ->required()
      ->type_name("F");
  record_verb->add_option("--duration", recording.duration_s, "seconds; default until SIGINT or SIGTERM")
      ->check(CLI::NonNegativeNumber)
      ->type_name("S");
  record_verb->footer("Example: leadline record --config ship.toml --session dive.leadline");

  std::vector<std::string> files;
  bool json = false;
  auto* info_verb = program.add_subcommand("info", "what a log holds, every byte accounted for");
  info_verb->add_option("FILE", files, "logs")->required();
  info_verb->add_flag("--json", json, "as JSON");
  info_verb->footer("Example: leadline info --json winriver01.PD0");

  ExportOptions exporting;
  auto* export_verb = program.add_subcommand("export", "a session for other tools");
  export_verb->add_option("SESSION", exporting.session, "a session file")->required();
  export_verb->add_option("--format", exporting.format, "csv or tlog")
      ->required()
      ->check(CLI::IsMember({"csv", "tlog"}));
  export_verb->add_option("--output", exporting.output, "tlog: a file, default stdout; csv: a folder")
      ->type_name("F");
  export_verb->footer("Example: leadline export dive.leadline --format tlog --output dive.tlog");

  SimulateOptions simulating;
  auto* simulate_verb =
      program.add_subcommand("simulate", "truth and every sensor's telegrams of a scenario");
  simulate_verb->add_option("SCENARIO", simulating.scenario, "a scenario (TOML)")->required();
  simulate_verb
      ->add_option("--output", simulating.output, "write telegrams.tlog, truth.csv, leadline.toml there")
      ->required()
      ->type_name("DIR");
  simulate_verb->add_option("--seed", simulating.seed, "of the noise, instead of the scenario's")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  simulate_verb->add_flag("--live", simulating.live,
                          "send each sensor's telegrams over its link in real time");
  simulate_verb->footer("Example: leadline simulate tests/data/scenarios/deep-survey.toml --output sim");

  std::string what;
  auto* list_verb = program.add_subcommand("list", "what this build offers");
  list_verb->add_option("WHAT", what, "engines, decoders or links")
      ->required()
      ->check(CLI::IsMember({"engines", "decoders", "links"}));
  list_verb->add_flag("--json", json, "as JSON");
  list_verb->footer("Example: leadline list decoders");

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return program.exit(e);  // --help, --version
    set_loudness(Loudness::normal);
    failure(fmt::format(
        "{}; see `leadline {}--help`", e.what(),
        program.get_subcommands().empty() ? "" : program.get_subcommands().front()->get_name() + " "));
    return status(Exit::misused);
  }
  set_loudness(quiet ? Loudness::quiet : verbose ? Loudness::verbose : Loudness::normal);

  if (example_config) {
    fmt::print("{}", example_configuration(load_plugins(replaying.plugin_paths)));
    return 0;
  }
  if (!config_to_check.empty())
    return status(check_config(config_to_check, load_plugins(replaying.plugin_paths)));
  if (replay_verb->parsed()) return status(replay(replaying));
  recording.plugin_paths = replaying.plugin_paths;
  if (record_verb->parsed()) return status(record(recording));
  if (info_verb->parsed()) return status(info(files, json));
  if (list_verb->parsed()) return status(list(what, load_plugins(replaying.plugin_paths), json));
  simulating.force = replaying.force;
  if (simulate_verb->parsed()) return status(simulate(simulating));
  exporting.force = replaying.force;
  if (export_verb->parsed()) return status(export_session(exporting));
  showing.plugin_paths = replaying.plugin_paths;
  return status(console(showing));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {  // out of memory and the like: nothing of ours throws
    fmt::print(stderr, "error: {}\n", e.what());
    return status(Exit::failed);
  }
}
