#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/decode/trdi_pd6_lines.h"
#include "core/flow/decoder.h"
#include "core/messages/measurements.h"

namespace leadline::decode {

/// Whose axes BI and WI have: TRDI's (x starboard, y forward, z up) or Water Linked's (x forward, y
/// starboard, z down), whose BS holds the same three numbers with the first two exchanged. That is a mirror
/// image, which no alignment of a TRDI can make: one ping with another BS decides for TRDI for good.
class Pd6Axes {
 public:
  /// named: "trdi" or "waterlinked" as an installation knows it; anything else: by the lines.
  explicit Pd6Axes(std::string_view named = {})
      : exchanged_(named == "waterlinked"), turned_(named == "trdi"), named_(exchanged_ || turned_) {}
  void observe(const Pd6Ping& ping);
  [[nodiscard]] bool forward_first() const { return exchanged_ && !turned_; }

 private:
  bool exchanged_, turned_, named_;
};

enum class Pd6Verdict : std::uint8_t { absent, inconsistent, told };
struct Pd6Choice {
  Pd6Verdict verdict = Pd6Verdict::absent;
  std::size_t line = 0;  ///< 0 instrument, 1 ship, 2 earth
  DvlVelocity velocity;
};

/// The ping's velocity over the bottom from the first of BI, BS, BE that was sent (see trdi_pd6.h). valid is
/// false without lock. tilt_applied of BS: its third component is BE's, or no BE tells otherwise (TRDI's
/// setting when delivered).
[[nodiscard]] Pd6Choice pd6_bottom_velocity(const Pd6Ping& ping, const Pd6Axes& axes,
                                            const DecoderSettings& settings);
/// The same through the water from WI, WS, WE; absent unless good and filled.
[[nodiscard]] Pd6Choice pd6_water_velocity(const Pd6Ping& ping, const Pd6Axes& axes,
                                           const DecoderSettings& settings);

/// The attitude a ping tells; empty when SA was not sent or not filled.
[[nodiscard]] std::optional<DvlVelocity::Applied> pd6_attitude(const Pd6Ping& ping,
                                                               const DecoderSettings& settings);

}  // namespace leadline::decode
