#include "maps/charts/coastline.h"

#include <cpl_vsi.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <tuple>

#include "core/geo/geodesy.h"
#include "maps/charts/gdal_session.h"

namespace leadline::maps {
namespace {

constexpr double kSeam_deg = 179.999;  // the file's points beside the date line are meant to lie on it
constexpr double kPole_deg = -89.99;   // the file's closing edge around the south pole
constexpr double kJoin_deg = 0.05;     // shores that meet on the date line do so within this latitude
constexpr const char* kFile = "ne_50m_land.json.gz";

struct Point {
  double lon, lat;  // deg, as in the file
};
using Ring = std::vector<Point>;

// A piece of shore between two points of the date line; `ring` tells which of the file's it was cut from.
struct Piece {
  Ring points;
  std::size_t ring;
};

bool on_seam(Point p) { return std::abs(p.lon) >= kSeam_deg; }

bool artificial(Point a, Point b) {
  return (on_seam(a) && on_seam(b)) || (a.lat < kPole_deg && b.lat < kPole_deg);
}

void turn_clockwise(Ring& ring) {
  double doubled_area = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    doubled_area += ring[j].lon * ring[i].lat - ring[i].lon * ring[j].lat;
  }
  if (doubled_area > 0.0) std::reverse(ring.begin(), ring.end());
}

std::optional<std::string> unpacked(const std::string& path) {
  const auto close = [](VSILFILE* file) { VSIFCloseL(file); };
  const std::unique_ptr<VSILFILE, decltype(close)> file(VSIFOpenL(("/vsigzip/" + path).c_str(), "rb"), close);
  if (!file) return std::nullopt;
  std::string text;
  std::array<char, 1 << 16> part;
  while (const std::size_t read = VSIFReadL(part.data(), 1, part.size(), file.get()))
    text.append(part.data(), read);
  return text;
}

// The rings of one "coordinates" value, polygon or several, in `take(ring, is_hole)`; where it ends, nullptr
// when it is broken. GDAL's own reader takes several times as long.
template <class Take>
const char* read_rings(const char* at, const char* end, const Take& take) {
  Ring ring;
  int depth = 0, hole = 0;
  bool after_point = false;
  for (; at < end; ++at) {
    if (*at == '[') {
      ++depth;
      after_point = false;
    } else if (*at == ']') {
      --depth;
      if (!ring.empty() && after_point) {
        if (ring.size() < 4) return nullptr;
        ring.pop_back();  // the first again
        take(std::move(ring), hole++ > 0);
        ring.clear();
      } else if (ring.empty()) {
        hole = 0;  // a polygon ends
      }
      after_point = !ring.empty();
      if (depth == 0) return at + 1;
    } else if (*at == '-' || (*at >= '0' && *at <= '9')) {
      Point p{};
      auto read = std::from_chars(at, end, p.lon);
      if (read.ec != std::errc()) return nullptr;
      at = std::find_if(read.ptr, end, [](char c) { return c == '-' || (c >= '0' && c <= '9'); });
      read = std::from_chars(at, end, p.lat);
      if (read.ec != std::errc() || std::abs(p.lon) > 180.001 || std::abs(p.lat) > 90.001) return nullptr;
      at = read.ptr - 1;
      ring.push_back(p);
    }
  }
  return nullptr;
}

ShoreRing shore_ring(const Ring& ring, bool water) {
  ShoreRing out;
  out.water = water;
  std::vector<Eigen::Vector3d> directions;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Point p : ring) {
    const Geodetic at{Angle::deg(p.lat), geo::normal_longitude(Angle::deg(on_seam(p) ? 180.0 : p.lon))};
    if (!out.points.empty() && out.points.back() == at) continue;
    out.points.push_back(at);
    directions.emplace_back(cos(at.lat) * cos(at.lon), cos(at.lat) * sin(at.lon), sin(at.lat));
    sum += directions.back();
  }
  const Eigen::Vector3d m = sum.normalized();
  out.middle = {Angle::rad(std::asin(std::clamp(m.z(), -1.0, 1.0))), Angle::rad(std::atan2(m.y(), m.x()))};
  double least = 1.0;
  for (const auto& d : directions) least = std::min(least, d.dot(m));
  out.reach = Angle::rad(std::acos(std::clamp(least, -1.0, 1.0)));
  return out;
}

// The pieces of a ring that is cut by the date line, in order; empty when it is not cut.
std::vector<Piece> cut(const Ring& ring, std::size_t number) {
  const std::size_t n = ring.size();
  const auto is_cut = [&](std::size_t i) { return artificial(ring[i % n], ring[(i + 1) % n]); };
  std::size_t first = 0;
  while (first < n && !is_cut(first)) ++first;
  std::vector<Piece> pieces;
  if (first == n) return pieces;
  bool open = false;
  for (std::size_t i = first; i < first + n; ++i) {
    if (is_cut(i)) {
      open = false;
      continue;
    }
    if (!open) pieces.push_back({{ring[i % n]}, number});
    open = true;
    pieces.back().points.push_back(ring[(i + 1) % n]);
  }
  return pieces;
}

// For each piece the one that goes on where it ends: across the date line at the same latitude, else the
// next of its own ring. A permutation, so that following it always comes round.
std::vector<std::size_t> successors(const std::vector<Piece>& pieces) {
  const std::size_t n = pieces.size(), none = n;
  std::vector<std::tuple<double, std::size_t, std::size_t>> meetings;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const Point end = pieces[a].points.back(), start = pieces[b].points.front();
      const double apart = std::abs(end.lat - start.lat);
      if (end.lon * start.lon < 0.0 && apart < kJoin_deg) meetings.emplace_back(apart, a, b);
    }
  }
  std::sort(meetings.begin(), meetings.end());
  std::vector<std::size_t> next(n, none);
  std::vector<bool> taken(n, false);
  const auto join = [&](std::size_t a, std::size_t b) {
    if (next[a] != none || taken[b]) return;
    next[a] = b;
    taken[b] = true;
  };
  for (const auto& [apart, a, b] : meetings) join(a, b);
  for (std::size_t a = 0; a < n; ++a) {
    std::size_t b = a + 1;
    if (b == n || pieces[b].ring != pieces[a].ring) {
      for (b = a; b > 0 && pieces[b - 1].ring == pieces[a].ring;) --b;
    }
    join(a, b);
  }
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) join(a, b);
  }
  return next;
}

void stitch(const std::vector<Piece>& pieces, std::vector<ShoreRing>& rings) {
  const auto next = successors(pieces);
  std::vector<bool> used(pieces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Ring whole;
    for (std::size_t at = i; !used[at]; at = next[at]) {
      used[at] = true;
      whole.insert(whole.end(), pieces[at].points.begin(), pieces[at].points.end());
    }
    if (whole.size() > 2) rings.push_back(shore_ring(whole, false));
  }
}

}  // namespace

Result<Coastline> load_coastline(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / kFile).string();
  const std::string remedy = "install the program's share/leadline/charts again";
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) return Error{"there is no coast line", path, remedy};
  const GdalSession session;
  const auto text = unpacked(path);
  Coastline coastline{"Coastline 1:50 000 000", {}};
  std::vector<Piece> pieces;
  std::size_t number = 0;
  const auto take = [&](Ring ring, bool water) {
    turn_clockwise(ring);
    const auto parts = cut(ring, number++);
    if (parts.empty()) coastline.rings.push_back(shore_ring(ring, water));
    pieces.insert(pieces.end(), parts.begin(), parts.end());
  };
  constexpr std::string_view kKey = "\"coordinates\":";
  bool whole = text && text->find_last_not_of(" \r\n") != std::string::npos &&
               text->at(text->find_last_not_of(" \r\n")) == '}';
  for (std::size_t at = 0; whole && (at = text->find(kKey, at)) != std::string::npos;) {
    const char* next = read_rings(text->data() + at + kKey.size(), text->data() + text->size(), take);
    whole = next != nullptr;
    if (whole) at = static_cast<std::size_t>(next - text->data());
  }
  if (!whole) return Error{"the coast line is damaged", path, remedy};
  stitch(pieces, coastline.rings);
  if (coastline.rings.empty()) return Error{"the coast line holds no land", path, remedy};
  std::sort(coastline.rings.begin(), coastline.rings.end(),
            [](const ShoreRing& a, const ShoreRing& b) { return a.reach > b.reach; });
  return coastline;
}

}  // namespace leadline::maps
