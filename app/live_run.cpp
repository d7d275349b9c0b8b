#include "app/live_run.h"

#include <fmt/format.h>

#include "app/outputs.h"
#include "app/recording.h"

namespace leadline::app {
namespace {

using namespace std::chrono_literals;

/// Nothing heard: Ticks follow the clock this far behind, so that a frame on its way is not overtaken.
constexpr Duration kBehind = 10ms;
constexpr auto kWait = 10ms;
constexpr Duration kLookEvery = 250ms, kDiskEvery = 10s;
constexpr Duration kNoticedStep = 1s;

Result<std::vector<links::WantedInput>> wanted_inputs(const Configuration& configuration) {
  std::vector<links::WantedInput> wanted;
  for (std::size_t i = 0; i < configuration.sources.size(); ++i) {
    const SourceOptions& options = configuration.sources[i].options;
    if (options.link.empty())
      return Error{"has no link, so nothing can be heard from it",
                   configuration.file + ": source " + options.name,
                   "give it one, like link = \"udp://0.0.0.0:4001\""};
    auto address = links::parse_link(options.link);
    if (!address) return address.error();
    wanted.push_back({static_cast<SourceId>(i), std::move(address).value()});
  }
  return wanted;
}

std::string kib(std::uint64_t bytes) { return fmt::format("{} KiB", (bytes + 1023) >> 10); }

}  // namespace

class LiveRun::Latency final : public Sink {
 public:
  explicit Latency(const links::LiveInputs& inputs) : inputs_(inputs) {}
  void take(const Envelope& envelope) override {
    if (std::holds_alternative<RawFrame>(envelope.message)) heard_ = envelope.arrival;
    const auto* solution = std::get_if<Solution>(&envelope.message);
    if (solution != nullptr && solution->engine == 0 && envelope.arrival == heard_)
      lateness.add(inputs_.clock().now() - envelope.arrival);
  }
  Lateness lateness;

 private:
  const links::LiveInputs& inputs_;
  Arrival heard_;
};

LiveRun::LiveRun() = default;
LiveRun::~LiveRun() = default;

Result<std::unique_ptr<LiveRun>> LiveRun::open(const Options& options, const Configuration& configuration,
                                               const PluginHost& plugins) {
  auto wanted = wanted_inputs(configuration);
  if (!wanted) return wanted.error();
  std::unique_ptr<LiveRun> live(new LiveRun);
  auto graph = make_graph(configuration, plugins, {});
  if (!graph) return graph.error();
  live->graph_ = std::move(graph).value();
  Bus& bus = *live->graph_.bus;
  if (live->graph_.magnetic_error) live->notes_.push_back(live->graph_.magnetic_error->line());
  auto loop = links::IoLoop::start();
  if (!loop) return loop.error();
  live->loop_ = std::move(loop).value();

  links::LiveInputs::Options inputs;
  if (!options.session.empty()) {
    const sessions::RunInfo info =
        run_info(sessions::RunKind::record, live->graph_.engine_names, configuration, plugins);
    auto begun = sessions::SessionChain::begin(options.session, info, {}, options.limits);
    if (!begun) return begun.error();
    live->chain_ = std::move(begun.value().chain);
    for (auto& note : begun.value().notes) live->notes_.push_back(std::move(note));
    bus.attach(*live->chain_);  // the first of the sinks: what was heard is its own before anybody reads it
    inputs.queue.spill_path = options.session + "-input";
  }
  auto outputs = Outputs::open(*live->loop_, configuration);
  if (!outputs) return outputs.error();
  live->outputs_ = std::move(outputs).value();
  bus.attach(*live->outputs_);
  live->watch_ = std::make_unique<SourceWatch>(bus.sources());
  bus.attach(*live->watch_);

  auto opened = links::LiveInputs::open(*live->loop_, wanted.value(), inputs);
  if (!opened) return opened.error();
  live->inputs_ = std::move(opened).value();
  live->told_.resize(live->inputs_->states().size());
  live->latency_ = std::make_unique<Latency>(*live->inputs_);
  bus.attach(*live->latency_);
  if (const auto left = live->inputs_->queue().left_behind_frames; left > 0)
    live->notes_.push_back(
        fmt::format("{} frames that the former run had heard and not yet recorded are taken first", left));
  return live;
}

const Lateness& LiveRun::solution_lateness() const { return latency_->lateness; }

std::vector<links::LiveInputs::State> LiveRun::links() const {
  const std::lock_guard lock(states_mutex_);
  return states_;
}

std::optional<sessions::Recorder::Status> LiveRun::recording() const {
  return chain_ ? std::optional(chain_->status()) : std::nullopt;
}

Result<void> LiveRun::run(const std::function<bool()>& go_on) {
  Bus& bus = *graph_.bus;
  const links::ArrivalClock& clock = inputs_->clock();
  if (inputs_->queue().left_behind_frames == 0) bus.pass_time(clock.now());
  Chunk chunk;
  while (go_on()) {
    if (inputs_->take(chunk, kWait))
      bus.take(chunk);
    else
      bus.pass_time(clock.now() + -kBehind);
    const Arrival now = clock.now();
    if (!next_look_ || now >= *next_look_) {
      look(now);
      next_look_ = now + kLookEvery;
    }
  }
  inputs_->close();
  while (inputs_->take(chunk, 0ms)) bus.take(chunk);
  bus.pass_time(clock.now());
  bus.finish();
  look_at_links();
  return chain_ ? chain_->finish() : Result<void>();
}

void LiveRun::tell(Health::Level level, const std::string& text, SourceId source) {
  graph_.bus->tell(Health{level, text}, source);
}

void LiveRun::alarm(Alarm::Priority priority, const char* reason, const std::string& text) {
  graph_.bus->tell(Alarm{priority, reason, text});
}

void LiveRun::look(Arrival now) {
  look_at_links();
  look_at_clock();
  if (!chain_) return;
  look_at_recorder();
  if (!next_disk_ || now >= *next_disk_) {
    look_at_disk(now);
    next_disk_ = now + kDiskEvery;
  }
}

void LiveRun::look_at_links() {
  const auto states = inputs_->states();
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [address, sources, status, not_decoded] = states[i];
    LinkTold& told = told_[i];
    const SourceId source = sources.front();
    if (status.open && !told.open) {
      tell(Health::Level::note, address.text() + (told.ever ? " is open again" : " is open"), source);
      told.ever = true;
    }
    const bool fell = told.open && !status.open;
    const bool news = !status.last_error.empty() && status.last_error != told.trouble;
    if (fell || news) tell(Health::Level::warning, status.last_error, source);
    told.open = status.open;
    told.trouble = status.last_error;
    if (status.kernel_drops != told.drops)
      tell(Health::Level::warning,
           fmt::format("{}: the kernel dropped {} datagrams: the computer is too slow for what comes, or the "
                       "receive buffer ({}) too small",
                       address.text(), status.kernel_drops - told.drops, kib(status.receive_buffer)),
           source);
    told.drops = status.kernel_drops;
    if (not_decoded != told.not_decoded)
      tell(Health::Level::warning,
           fmt::format("{}: overload: {} frames were recorded and not decoded", address.text(),
                       not_decoded - told.not_decoded),
           source);
    told.not_decoded = not_decoded;
  }
  {
    const std::lock_guard lock(states_mutex_);
    states_ = states;
  }
  const auto queue = inputs_->queue();
  if (queue.lost_frames != lost_told_)
    alarm(Alarm::Priority::alarm, "input lost",
          fmt::format("{} frames were lost: {}", queue.lost_frames - lost_told_, queue.last_error));
  lost_told_ = queue.lost_frames;
}

void LiveRun::look_at_clock() {
  const Duration step = inputs_->clock().wall_step();
  if (std::chrono::abs(step - wall_step_) < kNoticedStep) return;
  tell(Health::Level::warning,
       fmt::format("the computer's clock was set by {:+.1f} s; the recording's time goes on unchanged",
                   seconds(step - wall_step_)));
  wall_step_ = step;
}

void LiveRun::look_at_recorder() {
  const auto next = chain_->look();
  const auto status = chain_->status();
  const std::optional<Error> failure = next ? status.failure : std::optional(next.error());
  if (next && next.value()) tell(Health::Level::note, "the recording goes on in " + *next.value());
  if (failure && !refused_told_)
    alarm(Alarm::Priority::alarm, "not recorded", failure->line());
  else if (!failure && refused_told_)
    tell(Health::Level::note, "the disk takes data again");
  refused_told_ = failure.has_value();
}

void LiveRun::look_at_disk(Arrival now) {
  const auto disk = sessions::disk_of(chain_->path());
  if (!disk) return;
  const auto outlook = forecast_.look(now, *disk);
  if (outlook.short_of_space && !short_told_)
    alarm(Alarm::Priority::warning, "disk",
          fmt::format(
              "the disk has {:.1f} GiB left{}: make room; nothing is deleted by itself",
              static_cast<double>(disk->free_bytes) / (1 << 30),
              outlook.left ? fmt::format(", which lasts {:.1f} h", seconds(*outlook.left) / 3600.0) : ""));
  short_told_ = outlook.short_of_space;
}

}  // namespace leadline::app
