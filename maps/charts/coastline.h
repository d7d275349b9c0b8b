#pragma once

#include <string>
#include <vector>

#include "core/types/position.h"
#include "core/types/result.h"
#include "maps/charts/local_projection.h"
#include "maps/layers/plane.h"

namespace leadline::maps {

/// The shore of one land mass or one lake: what it encloses lies on the right of its points. Closed, the
/// first point not repeated; runs on over the date line and around the poles.
struct ShoreRing {
  std::vector<Geodetic> points;
  bool water = false;  ///< a lake within land
  Geodetic middle;     ///< all points lie within `reach` of here, seen from the Earth's centre
  Angle reach;
};

/// Natural Earth 1:50m land: some 60,000 points, kilometres off in places, so for small scales only.
struct Coastline {
  std::string name;              ///< "Coastline 1:50 000 000"
  std::vector<ShoreRing> rings;  ///< by falling reach: a lake after its land, an island after its lake
};

/// From `ne_50m_land.json.gz` in a folder (`charts/` beside the program, share/leadline/charts installed).
/// The seams of the file along the date line and around the south pole are taken out. Any thread; 20 ms on an
/// idle processor.
[[nodiscard]] Result<Coastline> load_coastline(const std::string& folder);

/// One ring in a plane, even-odd filled.
struct PlaneRing {
  std::vector<PlanePoint> points;
  std::vector<char> shore;  ///< 1: the edge from points[i] to the next is shore, to be drawn as a line
  PlaneBox bounds;
  bool water = false;
};

/// Land within `cap` (90 to 120 deg, seen from the Earth's centre) of the projection's origin; what lies
/// beyond is drawn in to the cap's circle and is no shore. Holds at any origin: over a pole, on the date
/// line, with land at the antipode. To be filled in order: land, its lakes, their islands. 10 ms.
[[nodiscard]] std::vector<PlaneRing> land_in_plane(const Coastline& coastline,
                                                   const LocalProjection& projection,
                                                   Angle cap = Angle::deg(100.0));

}  // namespace leadline::maps
