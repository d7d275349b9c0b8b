#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

namespace leadline::sim {

/// PCG-XSH-RR 64/32 (O'Neill 2014) with Box-Muller: the same numbers with every library, one stream for each
/// name, so that a sensor more or less does not move the noise of the others.
class Random {
 public:
  Random(std::uint64_t seed, std::string_view name);

  [[nodiscard]] std::uint32_t next();
  /// Open interval (0, 1).
  [[nodiscard]] double uniform() { return (next() + 0.5) / 4294967296.0; }
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  [[nodiscard]] bool chance(double share) { return uniform() < share; }
  /// Mean 0, sigma 1.
  [[nodiscard]] double normal();
  /// Drawn one after the other: as arguments of one call their order would be the compiler's.
  [[nodiscard]] Eigen::Vector2d normal2();
  [[nodiscard]] Eigen::Vector3d normal3();
  [[nodiscard]] std::uint8_t byte() { return static_cast<std::uint8_t>(next() >> 24U); }

 private:
  std::uint64_t state_ = 0, increment_ = 1;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

/// A first-order Gauss-Markov process, stationary from its start. tau_s 0: a random constant.
class GaussMarkov {
 public:
  GaussMarkov(double sigma, double tau_s, Random& random)
      : sigma_(sigma), tau_s_(tau_s), value_(sigma * random.normal()) {}

  /// The value dt_s later.
  double advance(double dt_s, Random& random);
  [[nodiscard]] double value() const { return value_; }

 private:
  double sigma_, tau_s_, value_;
};

}  // namespace leadline::sim
