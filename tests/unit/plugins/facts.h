#pragma once

#include <vector>

#include "core/flow/engine.h"
#include "core/geo/geodesy.h"

namespace leadline::test {

inline Time at_s(double s) { return from_unix(1'700'000'000.0 + s); }
inline Envelope fact(double t_s, const Message& message) {
  return {.valid = at_s(t_s), .arrival = arrival_at(at_s(t_s)), .source = 0, .message = message};
}
inline GnssFix fix_at(double north_m, double east_m) {
  return {.position = geo::displaced({Angle::deg(59.0), Angle::deg(5.0)}, north_m, east_m),
          .quality = GnssQuality::autonomous};
}

/// What an engine said.
struct Heard final : EngineOutput {
  std::vector<Envelope> messages;
  void publish(Time valid, const Message& message, SourceId source) override {
    messages.push_back({.valid = valid, .source = source, .message = message});
  }
  template <class T>
  [[nodiscard]] std::vector<T> all() const {
    std::vector<T> found;
    for (const auto& e : messages)
      if (const T* value = std::get_if<T>(&e.message)) found.push_back(*value);
    return found;
  }
};

}  // namespace leadline::test
