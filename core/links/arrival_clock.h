#pragma once

#include <cstdint>
#include <optional>

#include "core/types/time.h"

namespace leadline::links {

/// The clocks of the computer, ns; replaced by made ones in tests.
struct SystemClocks {
  std::int64_t (*elapsed_ns)();  ///< since some start, never back, on through a suspend
  std::int64_t (*wall_ns)();     ///< UTC as the computer has it; may be set to anything
};
[[nodiscard]] SystemClocks system_clocks();

/// The one number a live run orders everything by: UTC at its start plus what has elapsed since, in whole
/// microseconds. Setting the wall clock changes no arrival; it is a label beside it.
class ArrivalClock {
 public:
  explicit ArrivalClock(SystemClocks clocks = system_clocks());

  [[nodiscard]] Arrival now() const;
  [[nodiscard]] Time wall() const { return {clocks_.wall_ns()}; }
  /// The arrival of a packet that the kernel stamped by the wall clock. A stamp in the future or older than a
  /// second is not believed: the clock was set meanwhile.
  [[nodiscard]] Arrival heard_at(std::int64_t kernel_wall_ns) const;
  /// How far the wall clock was set since the start: positive forward.
  [[nodiscard]] Duration wall_step() const;

 private:
  SystemClocks clocks_;
  std::int64_t start_wall_ns_, start_elapsed_ns_;
};

}  // namespace leadline::links
