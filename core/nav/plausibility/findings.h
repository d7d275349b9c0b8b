#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/flow/engine.h"

namespace leadline::nav {

/// What a source can be accused of; frozen values come once a quantity.
enum class Fault : std::uint8_t {
  velocity,        ///< a DVL against positions: sign, axes, turn, scale
  heading_unit,    ///< radians for degrees or the reverse
  heading_offset,  ///< a quarter or half a turn off another heading
  rate,            ///< turn rate: its unit or its sign
  tilt_unit,
  depth_unit,
  altitude_unit,
  frozen,  ///< the first of kQuantities
};

/// Says each finding once, and once more when it is over.
class Findings {
 public:
  static constexpr std::size_t kQuantities = 12;
  explicit Findings(std::size_t sources) : standing_(sources) {}

  [[nodiscard]] static constexpr std::size_t frozen(std::size_t quantity) {
    return static_cast<std::size_t>(Fault::frozen) + quantity;
  }
  [[nodiscard]] bool stands(SourceId source, std::size_t fault) const { return standing_[source][fault]; }
  [[nodiscard]] bool stands(SourceId source, Fault fault) const {
    return stands(source, static_cast<std::size_t>(fault));
  }
  void raise(SourceId source, std::size_t fault, std::string_view text, Arrival now, EngineOutput& out) {
    if (standing_[source][fault]) return;
    standing_[source][fault] = true;
    out.publish(now.host(), Health{Health::Level::warning, text}, source);
  }
  void raise(SourceId source, Fault fault, std::string_view text, Arrival now, EngineOutput& out) {
    raise(source, static_cast<std::size_t>(fault), text, now, out);
  }
  void clear(SourceId source, std::size_t fault, std::string_view text, Arrival now, EngineOutput& out) {
    if (!standing_[source][fault]) return;
    standing_[source][fault] = false;
    out.publish(now.host(), Health{Health::Level::note, text}, source);
  }
  void clear(SourceId source, Fault fault, std::string_view text, Arrival now, EngineOutput& out) {
    clear(source, static_cast<std::size_t>(fault), text, now, out);
  }

 private:
  static constexpr std::size_t kFaults = static_cast<std::size_t>(Fault::frozen) + kQuantities;
  std::vector<std::array<bool, kFaults>> standing_;
};

}  // namespace leadline::nav
