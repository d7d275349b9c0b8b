#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/flow/source_info.h"
#include "core/nav/plausibility/findings.h"

namespace leadline::nav {

/// Says which values stand still while the body moves: the same numbers (or the same two by turns, where a
/// device says them in two sentences) for at least 5 s and 5 samples (10 of those slower than once a second),
/// and either
/// - the value was lively before: three fifths of its second differences were 3 resolutions or more (noise
///   and motion it never lacked), no natural run was a third as long, and something else on the body moves;
/// - or others say that this very quantity changed: headings by 15 deg, depths by 2 m, positions by 10 m, and
///   by 8 resolutions; for a depth below 2 m also the DVL: 0.6 m, 5 resolutions, at 0.1 m/s or more.
/// A resolution is the smallest step ever seen, never below the quantity's floor; a value clamped at 0 is not
/// judged by the first rule. Values that may well be constant (sound speed, echo depth) are never judged.
class FrozenValues {
 public:
  FrozenValues(std::span<const SourceInfo> sources, Findings& findings);

  void take(const Envelope& envelope, EngineOutput& out);
  /// A DVL's step down, level: what a depth that stands still is held against.
  void descent(SourceId source, double down_m) {
    sunk_m_[static_cast<std::size_t>(sources_[source].body)] += down_m;
  }
  /// Any of what a source says of its velocity, heading or position stands still.
  [[nodiscard]] bool standing_still(SourceId source) const { return frozen_[source] > 0; }

 private:
  enum Quantity : std::uint8_t {
    position,
    course,
    heading,
    tilts,
    turn_rate,
    inertial,
    bottom_velocity,
    water_velocity,
    altitude,
    ranges,
    depth,
    usbl
  };
  enum Dimension : std::uint8_t { turn, sink, travel, none };
  struct Traits;
  static const std::array<Traits, Findings::kQuantities> kTraits;
  using Values = std::array<double, 3>;

  struct Slot {
    bool heard = false, frozen = false;
    Values value{}, before{}, anchor{};
    Values quantum{};  ///< smallest step seen; 0: none yet
    std::uint64_t lively = 0;
    std::uint32_t samples = 0, run_samples = 0, lively_at_run = 0, known_at_run = 0, changes = 0;
    Arrival run_began, last, moved_at;
    std::int64_t longest_run_ns = 0;
    double odometer = 0.0;  ///< in the witness dimension of the quantity
    double sunk_at_run_m = 0.0;
    double witnessed_at_run = 0.0;  ///< what all others had then
  };
  struct Sample {
    Quantity quantity;
    Values value;
    double speed_mps = 0.0;
  };

  [[nodiscard]] static std::optional<Sample> sample_of(const Message& message);
  void hear(SourceId source, const Sample& sample, Arrival now, EngineOutput& out);
  void move(Slot& slot, SourceId source, const Sample& sample, Arrival now);
  void step(Slot& slot, const Sample& sample, Arrival now);
  void judge(Slot& slot, SourceId source, const Sample& sample, Arrival now, EngineOutput& out);
  [[nodiscard]] double witnessed(const Slot& slot, SourceId source, Quantity quantity) const;
  [[nodiscard]] const Slot* mover(const Slot& slot, SourceId source, std::size_t& which, SourceId& who) const;

  std::span<const SourceInfo> sources_;
  Findings& findings_;
  std::vector<std::array<Slot, Findings::kQuantities>> slots_;
  std::vector<std::uint8_t> frozen_;                  // how many quantities of a source
  std::array<double, 3> sunk_m_{};                    // by body
  std::array<std::array<double, 4>, 3> witnessed_{};  // by body and dimension, all slots
};

}  // namespace leadline::nav
