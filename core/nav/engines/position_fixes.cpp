#include "core/nav/engines/position_fixes.h"

#include <algorithm>

#include "core/geo/geodesy.h"
#include "core/geo/utm.h"

namespace leadline::nav {

std::optional<Geodetic> PositionFixes::transponder(const UsblRelative& relative, const SourceInfo& source,
                                                   Time t) {
  const auto ship = ship_.position_at(t);
  const auto attitude = ship_.attitude_at(t).attitude;
  if (!ship || !attitude) return std::nullopt;
  const Vec3<Ned> lever_n = Rotation<Ned, BodyFrame>::zyx(*attitude) * source.lever;
  const Angle turn = relative.axes == UsblAxes::head_up ? attitude->heading + source.mount.heading : Angle();
  const auto level = Rotation<Ned, Instrument>::zyx({Angle(), Angle(), turn});
  const Vec3<Ned> offset = level * Vec3<Instrument>{relative.x_m, relative.y_m, 0.0} + lever_n;
  return geo::displaced(*ship, offset.x, offset.y);
}

std::optional<PositionFix> PositionFixes::take(const Envelope& envelope) {
  ship_.take(envelope);
  if (envelope.source >= sources_.size()) return std::nullopt;
  const SourceInfo& source = sources_[envelope.source];
  PositionFix fix{.t = envelope.valid, .source = source.id, .body = source.body};

  if (const auto* gnss = std::get_if<GnssFix>(&envelope.message)) {
    fix.position = gnss->position;
    fix.height = gnss->height;
    if (fix.height) fix.depth = Depth{-fix.height->m};
    fix.drms_m = drms_m(*gnss, options_.aiding.gnss_drms_m);
    return fix;
  }

  fix.kind = PositionSource::usbl;
  const auto usbl_drms_m = [&](std::optional<double> sd_m) {
    return std::max(sd_m.value_or(options_.aiding.usbl_drms_m), 0.1 * options_.aiding.usbl_drms_m);
  };
  if (const auto* relative = std::get_if<UsblRelative>(&envelope.message)) {
    const auto position = transponder(*relative, source, envelope.valid);
    if (!position) return std::nullopt;
    fix.position = *position;
    if (relative->down_m) fix.depth = Depth{*relative->down_m};
    fix.drms_m = usbl_drms_m(relative->sd_m);
    return fix;
  }
  if (const auto* geographic = std::get_if<UsblGeographic>(&envelope.message)) {
    fix.position = geographic->position;
    fix.depth = geographic->depth;
    fix.drms_m = usbl_drms_m(geographic->sd_m);
    return fix;
  }
  if (const auto* grid = std::get_if<UsblGrid>(&envelope.message)) {
    const auto ship = ship_.position_at(envelope.valid);
    if (!ship) return std::nullopt;
    const auto utm = geo::to_utm(*ship);  // the telegram does not name its zone: it is the ship's
    if (!utm) return std::nullopt;
    const auto position =
        geo::from_utm(utm.value().zone, utm.value().north, grid->easting_m, grid->northing_m);
    if (!position) return std::nullopt;
    fix.position = position.value();
    fix.depth = grid->depth;
    fix.drms_m = usbl_drms_m(grid->sd_m);
    return fix;
  }
  return std::nullopt;
}

}  // namespace leadline::nav
