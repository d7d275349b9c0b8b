#include "core/nav/plausibility/plausibility_watch.h"

#include <cmath>
#include <cstdio>

#include "core/geo/geodesy.h"
#include "core/nav/motion/dvl_velocity.h"

namespace leadline::nav {
namespace {

constexpr std::uint32_t kTicksInASecond = 10;
constexpr double kLongestStep_s = 3.0;

bool finite(const Geodetic& p) { return std::isfinite(p.lat.rad()) && std::isfinite(p.lon.rad()); }

bool finite(const Message& message) {
  if (const auto* m = std::get_if<GnssFix>(&message)) return finite(m->position);
  if (const auto* m = std::get_if<Course>(&message))
    return std::isfinite(m->speed_mps) && (!m->course || std::isfinite(m->course->rad()));
  if (const auto* m = std::get_if<Heading>(&message)) return std::isfinite(m->heading.rad());
  if (const auto* m = std::get_if<Attitude>(&message))
    return std::isfinite(m->roll.rad()) && std::isfinite(m->pitch.rad());
  if (const auto* m = std::get_if<DvlVelocity>(&message))
    return std::isfinite(m->x_mps) && std::isfinite(m->y_mps) && std::isfinite(m->z_mps);
  if (const auto* m = std::get_if<UsblRelative>(&message))
    return std::isfinite(m->x_m) && std::isfinite(m->y_m);
  if (const auto* m = std::get_if<UsblGeographic>(&message)) return finite(m->position);
  if (const auto* m = std::get_if<UsblGrid>(&message))
    return std::isfinite(m->easting_m) && std::isfinite(m->northing_m);
  return true;
}

bool about(double value, double wanted) { return std::abs(std::log(value / wanted)) <= 0.2; }

double far_from_deg(double a_deg, double b_deg) {
  return std::abs(Angle::deg(a_deg - b_deg).wrapped_pi().deg());
}

}  // namespace

struct PlausibilityWatch::Vessel {
  BodyAttitude attitude;
  SourceId heading_source = kNoSource;
  Preferred gnss, usbl;
  std::optional<Geodetic> origin, place;
};

struct PlausibilityWatch::Dvl {
  DisplacementCheck gnss, usbl;
  bool heard = false;
  Time last;
  bool by_gnss = false;  ///< who found the standing finding
};

PlausibilityWatch::PlausibilityWatch(std::span<const SourceInfo> sources, const Options& options,
                                     const geo::MagneticModel* magnetic)
    : sources_(sources),
      findings_(sources.size()),
      frozen_(sources, findings_),
      units_(sources, findings_),
      fixes_(sources, options, magnetic),
      dvls_(sources.size()) {
  for (const Body body : {Body::vehicle, Body::ship, Body::target})
    vessels_.push_back(
        {.attitude = BodyAttitude(body, magnetic), .gnss = {}, .usbl = {}, .origin = {}, .place = {}});
}

PlausibilityWatch::~PlausibilityWatch() = default;

void PlausibilityWatch::take(const Envelope& envelope, EngineOutput& out) {
  if (std::holds_alternative<RawFrame>(envelope.message)) return;
  if (std::holds_alternative<Tick>(envelope.message)) {
    if (++ticks_ % kTicksInASecond == 0) units_.sample(envelope.arrival, out);
    return;
  }
  if (envelope.source >= sources_.size() || !finite(envelope.message)) return;
  const SourceInfo& source = sources_[envelope.source];
  frozen_.take(envelope, out);
  units_.take(envelope);
  // Without a DVL and USBL there is nothing to lay over the positions.
  displacements_ = displacements_ || std::holds_alternative<DvlVelocity>(envelope.message) ||
                   std::holds_alternative<UsblRelative>(envelope.message) ||
                   std::holds_alternative<UsblGeographic>(envelope.message) ||
                   std::holds_alternative<UsblGrid>(envelope.message);
  if (!displacements_) return;
  Vessel& vessel = vessels_[static_cast<std::size_t>(source.body)];
  vessel.attitude.take(envelope, source);
  if (std::holds_alternative<Heading>(envelope.message) &&
      (vessel.heading_source == kNoSource || envelope.source < vessel.heading_source))
    vessel.heading_source = envelope.source;
  if (const auto* velocity = std::get_if<DvlVelocity>(&envelope.message)) {
    ping(envelope, *velocity);
  } else if (const auto position = fixes_.take(envelope); position && finite(position->position)) {
    fix(*position, envelope.arrival, out);
  }
}

void PlausibilityWatch::ping(const Envelope& envelope, const DvlVelocity& velocity) {
  if (velocity.reference != DvlReference::bottom || !velocity.valid) return;
  const SourceInfo& source = sources_[envelope.source];
  Vessel& vessel = vessels_[static_cast<std::size_t>(source.body)];
  Dvl& dvl = dvls_[source.id];
  dvl.heard = true;
  // A heading or a velocity that stands still, or headings in a wrong unit, would be blamed on the axes.
  const SourceId compass = vessel.heading_source;
  if (frozen_.standing_still(source.id) ||
      (compass != kNoSource &&
       (frozen_.standing_still(compass) || findings_.stands(compass, Fault::heading_unit)))) {
    dvl.gnss.reset();
    dvl.usbl.reset();
    return;
  }
  const auto estimate = vessel.attitude.at(envelope.valid, vessel.place.value_or(Geodetic{}));
  if (!estimate.attitude) return;
  const Vec3<Ned> v = velocity_ned(velocity, source, *estimate.attitude);
  const double heading_rad = estimate.attitude->heading.wrapped_2pi().rad();
  dvl.gnss.velocity(envelope.valid, {v.x, v.y}, heading_rad);
  dvl.usbl.velocity(envelope.valid, {v.x, v.y}, heading_rad);
  units_.descent(source.id, envelope.valid, v.z);
  if (const double dt_s = seconds(envelope.valid - dvl.last); dt_s > 0.0 && dt_s <= kLongestStep_s)
    frozen_.descent(source.id, v.z * dt_s);
  dvl.last = envelope.valid;
}

void PlausibilityWatch::fix(const PositionFix& fix, Arrival now, EngineOutput& out) {
  Vessel& vessel = vessels_[static_cast<std::size_t>(fix.body)];
  const bool gnss = fix.kind == PositionSource::gnss;
  if (!gnss && fix.depth) units_.usbl_depth(fix.source, fix.depth->m);
  if (!vessel.origin) vessel.origin = fix.position;
  vessel.place = fix.position;
  if (!(gnss ? vessel.gnss : vessel.usbl).takes(fix.source, fix.t)) return;
  std::optional<DisplacementCheck::Complex> p;
  for (std::size_t i = 0; i < dvls_.size(); ++i) {
    if (!dvls_[i].heard || sources_[i].body != fix.body) continue;
    if (!p) {
      const auto from_origin = geo::difference(*vessel.origin, fix.position);
      p = {from_origin.north_m, from_origin.east_m};
      const auto attitude = vessel.attitude.at(fix.t, fix.position).attitude;
      const SourceInfo& antenna = sources_[fix.source];
      if (gnss && attitude) {
        const Vec3<Ned> lever_n = Rotation<Ned, BodyFrame>::zyx(*attitude) * antenna.lever;
        *p -= DisplacementCheck::Complex{lever_n.x, lever_n.y};
      }
    }
    Dvl& dvl = dvls_[i];
    DisplacementCheck& check = gnss ? dvl.gnss : dvl.usbl;
    const auto id = static_cast<SourceId>(i);
    if (frozen_.standing_still(fix.source)) {
      check.reset();
      continue;
    }
    switch (check.fix(fix.t, *p, fix.drms_m / std::sqrt(2.0))) {
      case DisplacementCheck::Verdict::open:
        break;
      case DisplacementCheck::Verdict::well:
        if (dvl.by_gnss == gnss)
          findings_.clear(id, Fault::velocity, "its velocity agrees with the positions again", now, out);
        break;
      case DisplacementCheck::Verdict::misread:
        if (!findings_.stands(id, Fault::velocity)) dvl.by_gnss = gnss;
        judge(id, check.found(), fix, now, out);
    }
  }
}

void PlausibilityWatch::judge(SourceId source, const DisplacementCheck::Misreading& found,
                              const PositionFix& fix, Arrival now, EngineOutput& out) {
  const char* reference = fix.kind == PositionSource::gnss ? "GNSS" : "USBL";
  const double turn_deg = found.turn_deg, away_deg = std::abs(turn_deg);
  char text[200];

  // A compass in radians read as degrees turns the DVL by what is missing of the heading.
  const SourceId compass = vessels_[static_cast<std::size_t>(fix.body)].heading_source;
  const auto radians = compass == kNoSource ? std::nullopt : units_.reads_as_radians(compass);
  const double read_deg = radians.value_or(Angle()).deg();
  if (radians && !found.mirrored && found.heading_span_rad <= 1.0 * kRadPerDeg && about(found.scale, 1.0) &&
      far_from_deg(read_deg * kDegPerRad, read_deg + turn_deg) <= 12.0) {
    std::snprintf(
        text, sizeof text,
        "its heading reads %.2f deg while the DVL's way by %s needs %.0f deg: it is most likely in radians "
        "and read as "
        "degrees",
        read_deg, reference, Angle::deg(read_deg + turn_deg).wrapped_2pi().deg());
    return findings_.raise(compass, Fault::heading_unit, text, now, out);
  }
  if (found.scale < 0.6 || found.scale > 1.6) {
    const char* unit = about(found.scale, 0.3048)            ? "feet read as metres"
                       : about(found.scale, 1.0 / 0.3048)    ? "metres read as feet"
                       : about(found.scale, 1852.0 / 3600.0) ? "knots read as m/s"
                       : about(found.scale, 3600.0 / 1852.0) ? "m/s read as knots"
                                                             : "a wrong unit or scale";
    std::snprintf(text, sizeof text, "its speed is %.2f times that of %s over %.0f m%s: most likely %s",
                  1.0 / found.scale, reference, found.travelled_m, away_deg >= 45.0 ? ", and turned" : "",
                  unit);
  } else if (found.mirrored && away_deg < 45.0) {
    std::snprintf(
        text, sizeof text,
        "its sideways velocity is opposite to the way by %s over %.0f m: the sign of its starboard axis is "
        "wrong",
        reference, found.travelled_m);
  } else if (found.mirrored && away_deg > 135.0) {
    std::snprintf(
        text, sizeof text,
        "its forward velocity is opposite to the way by %s over %.0f m: the sign of its forward axis is "
        "wrong",
        reference, found.travelled_m);
  } else if (found.mirrored) {
    std::snprintf(text, sizeof text,
                  "its forward and starboard axes are swapped%s against the way by %s over %.0f m",
                  turn_deg < 0.0 ? " and reversed" : "", reference, found.travelled_m);
  } else if (away_deg > 135.0) {
    std::snprintf(
        text, sizeof text,
        "moves backward while %s moves forward (%.0f deg apart over %.0f m): wrong sign or mounted at 180 "
        "deg "
        "(velocity_sign, mount.yaw_deg), or the heading is 180 deg off",
        reference, away_deg, found.travelled_m);
  } else {
    std::snprintf(
        text, sizeof text,
        "moves %.0f deg to %s of the way by %s over %.0f m: its axes are swapped or it is mounted turned "
        "(mount.yaw_deg, about %+.0f), or the heading is off by that",
        away_deg, turn_deg > 0.0 ? "port" : "starboard", reference, found.travelled_m, turn_deg);
  }
  findings_.raise(source, Fault::velocity, text, now, out);
}

}  // namespace leadline::nav
