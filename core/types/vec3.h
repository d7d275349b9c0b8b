#pragma once

#include <Eigen/Core>

namespace leadline {

// Frames. The letter is the one used inside kernels.
struct Ned {};         ///< n: north, east, down at the vehicle
struct BodyFrame {};   ///< b: forward, starboard, down at the body's reference point
struct Instrument {};  ///< s: forward, starboard, down as the instrument is built, before its mount

/// A vector that knows its frame; mixing frames does not compile. Components in SI.
/// At doors only: kernels take eigen() and keep the field's letters.
template <class Frame>
struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;

  [[nodiscard]] Eigen::Vector3d eigen() const { return {x, y, z}; }
  [[nodiscard]] static Vec3 from(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

  constexpr Vec3 operator+(const Vec3& o) const { return {x + o.x, y + o.y, z + o.z}; }
  constexpr Vec3 operator-(const Vec3& o) const { return {x - o.x, y - o.y, z - o.z}; }
  constexpr Vec3 operator-() const { return {-x, -y, -z}; }
  constexpr Vec3 operator*(double k) const { return {x * k, y * k, z * k}; }
  constexpr bool operator==(const Vec3&) const = default;
};

}  // namespace leadline
