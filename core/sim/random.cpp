#include "core/sim/random.h"

#include <cmath>

#include "core/types/angle.h"

namespace leadline::sim {
namespace {

constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 1099511628211ULL;
  return hash;
}

}  // namespace

Random::Random(std::uint64_t seed, std::string_view name) : increment_(fnv1a(name) << 1U | 1U) {
  (void)next();
  state_ += seed;
  (void)next();
}

std::uint32_t Random::next() {
  const std::uint64_t old = state_;
  state_ = old * kMultiplier + increment_;
  const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
  const auto turn = static_cast<std::uint32_t>(old >> 59U);
  return shifted >> turn | shifted << ((32U - turn) & 31U);
}

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * std::log(uniform())), angle = 2.0 * kPi * uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

Eigen::Vector2d Random::normal2() {
  Eigen::Vector2d drawn;
  for (double& value : drawn) value = normal();
  return drawn;
}

Eigen::Vector3d Random::normal3() {
  Eigen::Vector3d drawn;
  for (double& value : drawn) value = normal();
  return drawn;
}

double GaussMarkov::advance(double dt_s, Random& random) {
  if (tau_s_ <= 0.0 || dt_s <= 0.0) return value_;
  const double kept = std::exp(-dt_s / tau_s_);
  value_ = value_ * kept + sigma_ * std::sqrt(1.0 - kept * kept) * random.normal();
  return value_;
}

}  // namespace leadline::sim
