#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/flow/engine.h"
#include "core/flow/source_info.h"

namespace leadline {

/// Says which sources have fallen silent: nothing heard for 2 s, or for three times the longest of a source's
/// last intervals where that is longer (10 s before the first interval); and when they are heard again. On
/// Ticks only.
class SourceWatch final : public Engine {
 public:
  explicit SourceWatch(const std::vector<SourceInfo>& sources);

  void take(const Envelope& envelope, EngineOutput& out) override;
  [[nodiscard]] bool silent(SourceId source) const { return watched_[source].silent; }

 private:
  static constexpr std::size_t kIntervals = 12;
  struct Watched {
    SourceId id = kNoSource;
    bool heard = false, silent = false;
    bool paced = false;  ///< an interval is known
    Arrival last;        ///< when it was heard; before that, when the watch began
    std::array<std::int64_t, kIntervals> intervals_ns{};
    std::size_t next = 0;
  };

  void hear(Watched& watched, Arrival at, EngineOutput& out);
  static void look(Watched& watched, Arrival now, EngineOutput& out);

  std::vector<Watched> watched_;
  bool began_ = false;
};

}  // namespace leadline
