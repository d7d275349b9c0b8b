#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/configuration.h"
#include "app/graph.h"
#include "app/lateness.h"
#include "core/flow/source_watch.h"
#include "core/links/live_inputs.h"
#include "sessions/recorder/disk_forecast.h"
#include "sessions/recorder/session_chain.h"

namespace leadline::app {

class Outputs;

/// A configuration at work on its links: links in, recorder first, decoders, engines, outputs. What happens
/// to links and disk is told as Health and Alarm messages and recorded.
class LiveRun {
 public:
  struct Options {
    std::string session;  ///< empty: nothing is recorded
    sessions::SessionChain::Limits limits;
  };
  /// Error: a source without link, an engine that is not there, a session that cannot be written.
  [[nodiscard]] static Result<std::unique_ptr<LiveRun>> open(const Options& options,
                                                             const Configuration& configuration,
                                                             const PluginHost& plugins);
  ~LiveRun();

  /// Behind the recorder; before run().
  void attach(Sink& sink) { graph_.bus->attach(sink); }
  /// What was found when it was opened: sentences for the operator.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  /// The core thread's work: until go_on() is false, asked many times a second. Then everything under way is
  /// decoded, recorded and ended.
  [[nodiscard]] Result<void> run(const std::function<bool()>& go_on);

  [[nodiscard]] const Bus& bus() const { return *graph_.bus; }
  [[nodiscard]] const std::vector<std::string>& engine_names() const { return graph_.engine_names; }
  /// As they were a moment ago; any thread.
  [[nodiscard]] std::vector<links::LiveInputs::State> links() const;
  [[nodiscard]] links::InputQueue::Status queue() const { return inputs_->queue(); }
  /// From the arrival of a frame to the solution it made being handed to the sinks.
  [[nodiscard]] const Lateness& solution_lateness() const;
  [[nodiscard]] std::optional<sessions::Recorder::Status> recording() const;
  [[nodiscard]] std::string session_path() const { return chain_ ? chain_->path() : std::string(); }

 private:
  class Latency;
  struct LinkTold {
    bool open = false, ever = false;
    std::uint64_t drops = 0, not_decoded = 0;
    std::string trouble;
  };

  LiveRun();
  void look(Arrival now);
  void look_at_links();
  void look_at_clock();
  void look_at_disk(Arrival now);
  void look_at_recorder();
  void tell(Health::Level level, const std::string& text, SourceId source = kNoSource);
  void alarm(Alarm::Priority priority, const char* reason, const std::string& text);

  std::unique_ptr<links::IoLoop> loop_;  // outlives whatever is on it
  std::unique_ptr<sessions::SessionChain> chain_;
  Graph graph_;
  std::unique_ptr<SourceWatch> watch_;
  std::unique_ptr<Latency> latency_;
  std::unique_ptr<Outputs> outputs_;
  std::unique_ptr<links::LiveInputs> inputs_;
  std::vector<std::string> notes_;

  mutable std::mutex states_mutex_;
  std::vector<links::LiveInputs::State> states_;  // guarded

  std::vector<LinkTold> told_;
  sessions::DiskForecast forecast_;
  std::optional<Arrival> next_look_, next_disk_;
  Duration wall_step_{0};
  bool short_told_ = false, refused_told_ = false;
  std::uint64_t lost_told_ = 0;
};

}  // namespace leadline::app
