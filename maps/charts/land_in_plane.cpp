#include <algorithm>
#include <cmath>

#include "maps/charts/coastline.h"

// Every point beyond the cap is drawn in along its ray to the cap's circle. That keeps how often a ring winds
// around each point inside, so nothing needs to be cut; only a ring whose land holds the antipode comes out
// turned about, as a hole in a plane of land: it is given the circle as its outer edge.

namespace leadline::maps {
namespace {

constexpr double kEarth_m = 6'371'000.0;
constexpr double kArcStep_rad = 3.0 * kRadPerDeg;

Angle apart(Geodetic a, Geodetic b) {
  const double c = sin(a.lat) * sin(b.lat) + cos(a.lat) * cos(b.lat) * cos(a.lon - b.lon);
  return Angle::rad(std::acos(std::clamp(c, -1.0, 1.0)));
}

double doubled_area(const std::vector<PlanePoint>& ring) {
  double sum = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    sum += ring[j].east_m * ring[i].north_m - ring[i].east_m * ring[j].north_m;
  }
  return sum;
}

// A ring while it is drawn in.
class Gathered {
 public:
  explicit Gathered(double radius_m) : radius_m_(radius_m) {}

  // seam: the edge that ends here is none of the shore's.
  void add(PlanePoint p, bool seam) {
    const double r = std::hypot(p.east_m, p.north_m);
    if (!std::isfinite(r)) return;  // within millimetres of the antipode
    const bool outside = r > radius_m_;
    if (outside) p = {p.east_m * radius_m_ / r, p.north_m * radius_m_ / r};
    if (outside && !ring.points.empty() && outside_) arc_to(p);
    if (!ring.shore.empty()) ring.shore.back() = !seam && !outside && !outside_;
    put(p);
    outside_ = outside;
    any_inside = any_inside || !outside;
  }

  // The whole circle after the ring, out and back over one bridge.
  void add_circle() {
    put(ring.points.front());
    for (double at = 0.0; at < 2.0 * kPi; at += kArcStep_rad) {
      put({radius_m_ * std::cos(at), radius_m_ * std::sin(at)});
    }
    put({radius_m_, 0.0});
  }

  PlaneRing ring;
  bool any_inside = false;

 private:
  void arc_to(PlanePoint to) {
    const PlanePoint from = ring.points.back();
    const double start = std::atan2(from.north_m, from.east_m);
    const double turn =
        (Angle::rad(std::atan2(to.north_m, to.east_m)) - Angle::rad(start)).wrapped_pi().rad();
    const int steps = static_cast<int>(std::abs(turn) / kArcStep_rad);
    for (int i = 1; i <= steps; ++i) {
      const double at = start + turn * i / (steps + 1);
      put({radius_m_ * std::cos(at), radius_m_ * std::sin(at)});
    }
  }

  void put(PlanePoint p) {
    ring.points.push_back(p);
    ring.shore.push_back(0);
  }

  double radius_m_;
  bool outside_ = false;
};

}  // namespace

std::vector<PlaneRing> land_in_plane(const Coastline& coastline, const LocalProjection& projection,
                                     Angle cap) {
  LL_EXPECT(cap >= Angle::deg(90.0) && cap <= Angle::deg(120.0));
  const double radius_m = 2.0 * kEarth_m * std::tan(cap.rad() / 2.0);
  std::vector<PlaneRing> land;
  std::vector<PlanePoint> projected;
  for (const ShoreRing& shore : coastline.rings) {
    const std::size_t n = shore.points.size();
    if (n < 3 || apart(shore.middle, projection.origin()) - shore.reach > cap + Angle::deg(2.0)) continue;
    projected.resize(n);
    projection.forward(shore.points, projected);
    const auto on_seam = [&](std::size_t i) { return shore.points[i % n].lon.rad() <= -kPi; };
    Gathered gathered(radius_m);
    for (std::size_t i = 0; i <= n; ++i)
      gathered.add(projected[i % n], i > 0 && on_seam(i - 1) && on_seam(i));
    if (!gathered.any_inside || gathered.ring.points.size() < 4) continue;
    PlaneRing& ring = gathered.ring;
    ring.points.pop_back();  // the first again: its edge is the last
    ring.shore.pop_back();
    // Clockwise is negative; a ring about the antipode encloses most of the cap the other way.
    if (doubled_area(ring.points) > 0.02 * kPi * radius_m * radius_m) gathered.add_circle();
    ring.water = shore.water;
    ring.bounds = {ring.points[0].east_m, ring.points[0].north_m, ring.points[0].east_m,
                   ring.points[0].north_m};
    for (const PlanePoint p : ring.points) {
      ring.bounds.west_m = std::min(ring.bounds.west_m, p.east_m);
      ring.bounds.east_m = std::max(ring.bounds.east_m, p.east_m);
      ring.bounds.south_m = std::min(ring.bounds.south_m, p.north_m);
      ring.bounds.north_m = std::max(ring.bounds.north_m, p.north_m);
    }
    land.push_back(std::move(ring));
  }
  return land;
}

}  // namespace leadline::maps
