#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/configuration.h"
#include "core/flow/engine.h"
#include "core/links/io_loop.h"

namespace leadline::app {

/// What an [[output]] cannot be told, by key; empty: all is well.
struct OutputProblem {
  std::string key, text;
};
[[nodiscard]] std::vector<OutputProblem> check_output(const OutputOptions& output,
                                                      const Configuration& configuration);

/// How one [[output]] fares; a frame is a sentence, or a datagram of them.
struct OutputStatus {
  std::string name, link;
  bool open = false;
  std::uint64_t sent_frames = 0, dropped_frames = 0;
  std::string last_error;  ///< kept when the link is open again
};

/// The [[output]]s of a live run: on Ticks, at most ten a second, each sends its sentences of the newest
/// state of its body. The state is the engine's solution where navigation follows that body, else the ship's
/// own track; altitude, echo sounder and turn rate are those of the first of the body's sources that is
/// alive. What is older than three of its own intervals, but 1 s at least and 5 s at most, counts as unknown
/// and is sent as void: RMC "V", GGA quality 0, HDT empty. Never blocks: what a link does not take is dropped
/// and counted. Attach it behind the recorder.
class Outputs final : public Sink {
 public:
  /// Links open by themselves, again and again. Error: what check_output() would have said.
  [[nodiscard]] static Result<std::unique_ptr<Outputs>> open(links::IoLoop& loop,
                                                             const Configuration& configuration);
  ~Outputs() override;

  void take(const Envelope& envelope) override;
  /// Any thread.
  [[nodiscard]] std::vector<OutputStatus> status() const;
  /// Waits until everything is sent or dropped; false when some is still under way then.
  bool finish(std::chrono::milliseconds at_most);

 private:
  struct Output;
  Outputs();
  std::vector<SourceInfo> sources_;
  std::vector<std::unique_ptr<Output>> outputs_;
};

}  // namespace leadline::app
