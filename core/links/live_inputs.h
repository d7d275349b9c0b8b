#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/flow/source.h"
#include "core/links/arrival_clock.h"
#include "core/links/input_queue.h"
#include "core/links/link_receiver.h"
#include "core/links/overload.h"

namespace leadline::links {

/// Which link a source hears. Sources with the same link share it, and each is given all that it hears.
struct WantedInput {
  SourceId source = kNoSource;
  LinkAddress address;
};

/// Every link of a live run, on one I/O thread, as one stream of chunks in order of arrival for the core
/// thread. While the core is too slow, memory stays bounded: what waits goes to the disk, and of the link
/// that floods it chunks are handed on as refused ("overload"): recorded, not decoded.
class LiveInputs {
 public:
  struct Options {
    InputQueue::Options queue;
    LinkLimits limits;
  };
  /// Error: the spill file of a former program cannot be used. Links that fail heal themselves; see states().
  [[nodiscard]] static Result<std::unique_ptr<LiveInputs>> open(IoLoop& loop,
                                                                const std::vector<WantedInput>& wanted,
                                                                const Options& options);
  ~LiveInputs();

  /// The next chunk; false when nothing came within `at_most`. Its views are good until the next call.
  [[nodiscard]] bool take(Chunk& chunk, std::chrono::milliseconds at_most);
  /// Nothing is heard any more; what waits can still be taken.
  void close();

  [[nodiscard]] const ArrivalClock& clock() const { return clock_; }
  struct State {
    LinkAddress address;
    std::vector<SourceId> sources;
    LinkStatus status;
    std::uint64_t not_decoded = 0;  ///< frames, for overload
  };
  [[nodiscard]] std::vector<State> states() const;
  [[nodiscard]] InputQueue::Status queue() const { return queue_.status(); }

 private:
  struct Line {
    LinkAddress address;
    std::vector<SourceId> sources;
    std::unique_ptr<LinkReceiver> receiver;
    LinkStatus last;  // of a receiver that was closed
  };
  LiveInputs(InputQueue queue, std::vector<Line> lines);

  ArrivalClock clock_;
  InputQueue queue_;
  std::vector<Line> lines_;
  Overload overload_;
  InputFrame frame_;
  std::uint64_t left_behind_;    // frames of a former program still to come
  std::size_t next_source_ = 0;  // of the frame's link that is to be given it
  bool refused_ = false;
};

}  // namespace leadline::links
