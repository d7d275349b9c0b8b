#pragma once

#include <array>
#include <optional>

#include "ui/bridge/console_setup.h"
#include "ui/bridge/pulse.h"

namespace leadline::ui {

/// What a fact tells of a body, as far as a figure is fed by it.
enum class Quantity : std::uint8_t {
  position,
  heading,
  bottom_velocity,
  water_velocity,
  course,
  attitude,
  depth,
  pressure,
  altitude,
  bottom_depth,
  other,
};
inline constexpr std::size_t kQuantities = 11;

/// Everything that is remembered of one source. A plain value; no allocation a message.
class SourceBook {
 public:
  /// Any message of this source. frames_kept: ConsoleSetup's.
  void take(const Envelope& envelope, bool frames_kept = true);
  /// How many frames and refusals there were so far.
  void set_counts(std::uint64_t frames, std::uint64_t refused);

  struct Spoken {
    Pulse pulse;  ///< in times of validity
    Arrival heard;
    double value = 0.0;  ///< m above the bottom; of altitude and bottom_depth
  };
  /// Empty: it never told of this.
  [[nodiscard]] const Spoken* spoken(Quantity quantity) const;
  /// Younger than 3 s or three of its periods at `now`.
  [[nodiscard]] bool alive(Quantity quantity, Arrival now) const;
  [[nodiscard]] bool usbl() const { return usbl_; }

  [[nodiscard]] SourceState state(const ConsoleSetup::Source& source, Arrival now) const;

  /// A fix of this source was judged by the engine shown.
  void judged(bool accepted);

 private:
  void fact(Quantity quantity, const Envelope& envelope, double value = 0.0);
  void sigma(std::optional<double> value, const char* unit);
  [[nodiscard]] double period_s() const;

  std::array<Spoken, kQuantities> spoken_{};
  Pulse frames_pulse_;
  RecentCount recent_;
  std::uint64_t frames_ = 0, refused_ = 0;
  bool usbl_ = false;
  std::optional<Arrival> last_;
  std::optional<Duration> latency_;
  Text<24> refusal_;
  std::optional<double> sigma_;
  const char* sigma_unit_ = "";
  int beams_ = 0, satellites_ = 0;
  static constexpr int kFixes = 8;
  std::uint8_t fixes_ = 0, refused_fixes_ = 0;  // the last eight, a bit each
};

}  // namespace leadline::ui
