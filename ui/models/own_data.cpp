#include "ui/models/own_data.h"

#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"
#include "ui/models/freshness.h"

namespace leadline::ui {
namespace {

constexpr double kStillMps = 0.05;  // below it there is no course

/// The older of a solution and what feeds one of its figures.
struct Parents {
  Time valid;
  ValueState state = ValueState::live;
};

ValueState state_of(const Snapshot& s, Time valid, double period_s) {
  return freshness(s.now - valid, period_s);
}

Parents parents_of(const Snapshot& s, const BodyState& body, const Feed& feed) {
  const double solution_period_s = body.position ? body.position->period_s : 0.0;
  return {std::min(body.valid, feed.valid),
          worse(state_of(s, body.valid, solution_period_s), state_of(s, feed.valid, feed.period_s))};
}

/// What every tile says of its feed; a lost value moves into the note.
TileText tile(const Snapshot& s, const char* label, std::string value, const char* unit,
              std::optional<double> sigma, const Feed& feed, const Parents& parents) {
  TileText t;
  t.label = label, t.unit = unit, t.source = feed.source;
  t.age = age_text(s.now - parents.valid);
  t.state = parents.state;
  t.replay = s.replay;
  if (sigma && *sigma > 0.0 && std::isfinite(*sigma)) t.sigma = sigma_text(*sigma);
  t.was_source = feed.was;
  if (value == kUnknown) return t;
  if (t.state == ValueState::lost)
    t.note = "last " + value + (*unit == 0 || std::string_view(unit).substr(0, 2) == "°" ? "" : " ") + unit +
             " at " + time_text(parents.valid);
  else
    t.value = std::move(value);
  return t;
}

std::optional<double> degrees(std::optional<Angle> angle) {
  return angle ? std::optional(angle->deg()) : std::nullopt;
}

/// One sigma that the source of a feed states, in `unit`.
std::optional<double> source_sigma(const Snapshot& s, const Feed& feed, const char* unit) {
  const auto source = std::find_if(s.sources.begin(), s.sources.end(),
                                   [&](const SourceState& x) { return x.name == feed.source; });
  return source != s.sources.end() && source->sigma_unit == unit ? source->sigma : std::nullopt;
}

TileText position_tile(const Snapshot& s, const BodyState& body, PositionFormat format) {
  const Feed& feed = *body.position;
  const Parents parents{body.valid, state_of(s, body.valid, feed.period_s)};
  const PositionText text = position_text(body.solution.position, format);
  const double drms_m = std::sqrt(body.solution.var_north_m2 + body.solution.var_east_m2);
  TileText t = tile(s, "Position", text.first, "", {}, feed, parents);
  if (t.state == ValueState::lost)
    t.note = "last " + text.first + " " + text.second + " at " + time_text(parents.valid);
  else if (!t.value.empty())
    t.value_2 = text.second;
  if (drms_m > 0.0 && std::isfinite(drms_m)) t.sigma = sigma_text(drms_m) + " m";
  return t;
}

/// Speed and course over ground of a solution.
struct Ground {
  double speed_mps;
  std::optional<Angle> course;
};
std::optional<Ground> ground_of(const Solution& s) {
  if (!s.vel_north_mps || !s.vel_east_mps) return std::nullopt;
  Ground ground{std::hypot(*s.vel_north_mps, *s.vel_east_mps), {}};
  if (ground.speed_mps >= kStillMps)
    ground.course = Angle::rad(std::atan2(*s.vel_east_mps, *s.vel_north_mps));
  return ground;
}

OwnDataText own_data(const Snapshot& s, const BodyState& body, bool ship, PositionFormat format) {
  OwnDataText text;
  const Solution& solution = body.solution;
  text.subject = body.name;
  text.fact = "engine " + body.engine + "   " + rate_text(body.rate_hz);
  if (body.engine == "ship") text.fact = "own track   " + rate_text(body.rate_hz);
  if (body.position) text.position = position_tile(s, body, format);
  const auto ground = ground_of(solution);
  if (body.heading && solution.heading) {
    const Feed& feed = *body.heading;
    const Parents parents = parents_of(s, body, feed);
    const auto sigma = degrees(solution.sd_heading);
    TileText& t = text.heading.emplace(tile(
        s, "Heading", heading_text(*solution.heading, decimals_for(sigma, 1)), "° T", sigma, feed, parents));
    if (!t.sigma.empty()) t.sigma += "°";
    RoseAngles& rose = text.rose.emplace();
    rose.state = t.state, rose.replay = s.replay;
    rose.heading_deg = solution.heading->wrapped_2pi().deg();
    if (ground && ground->course) rose.course_deg = ground->course->wrapped_2pi().deg();
  }
  if (body.velocity && ground) {
    const double unit = ship ? kKnotsPerMps : 1.0;
    auto sigma = source_sigma(s, *body.velocity, "m/s");
    if (sigma) *sigma *= unit;
    TileText& t = text.speed.emplace(
        tile(s, "Speed over ground", number_text(ground->speed_mps * unit, decimals_for(sigma, ship ? 1 : 2)),
             ship ? "kn" : "m/s", sigma, *body.velocity, parents_of(s, body, *body.velocity)));
    if (ground->course && t.state != ValueState::lost)
      t.note = "COG " + heading_text(*ground->course) + "° T";
  }
  if (body.depth && solution.depth)
    text.depth = tile(s, "Depth", number_text(solution.depth->m, decimals_for(solution.sd_down_m, 1)), "m",
                      solution.sd_down_m, *body.depth, parents_of(s, body, *body.depth));
  if (body.altitude) {
    const Feed& feed = body.altitude->feed;
    text.altitude = tile(s, "Altitude", number_text(body.altitude->above_bottom_m, 1), "m", {}, feed,
                         {feed.valid, state_of(s, feed.valid, feed.period_s)});
  }
  if (body.attitude) {
    const Parents parents = parents_of(s, body, *body.attitude);
    const auto sigma = source_sigma(s, *body.attitude, "°");
    const auto small = [&](const char* label, Angle angle) {
      TileText t = tile(s, label, signed_text(angle.deg(), decimals_for(sigma, 1)), "°", sigma,
                        *body.attitude, parents);
      t.source.clear();
      return t;
    };
    if (solution.roll) text.roll = small("Roll", *solution.roll);
    if (solution.pitch) text.pitch = small("Pitch", *solution.pitch);
  }
  return text;
}

bool has_sources(const Snapshot& s, Body body) {
  return std::any_of(s.sources.begin(), s.sources.end(),
                     [&](const SourceState& x) { return x.body == body; });
}

OwnDataText panel(const Snapshot& s, const std::optional<BodyState>& body, Body which,
                  PositionFormat format) {
  if (body) return own_data(s, *body, which == Body::ship, format);
  OwnDataText text;
  const std::string name = which == Body::ship ? "ship" : "vehicle";
  text.absent =
      has_sources(s, which) ? "no position of the " + name + " yet" : "no " + name + " in this configuration";
  return text;
}

std::string words(std::uint64_t count, const char* what) { return std::to_string(count) + " " + what; }

SourceRow source_row(const Snapshot& s, const SourceState& source) {
  SourceRow row;
  row.name = source.name;
  row.rate = source.rate_hz > 0.0 ? rate_text(source.rate_hz) : "";
  if (source.last) {
    row.age = age_text(s.now - *source.last);
    row.state = state_of(s, *source.last, source.period_s);
  } else {
    row.state = ValueState::lost;
  }
  if (source.latency_s) row.latency = latency_text(*source.latency_s);
  if (source.fixes_refused > 0) {
    row.quality = words(static_cast<std::uint64_t>(source.fixes_refused), "of ") +
                  std::to_string(source.fixes_judged) + " refused";
    if (source.fixes_refused >= 3) row.alert = Alarm::Priority::warning;
  } else if (source.beams > 0) {
    row.quality = words(static_cast<std::uint64_t>(source.beams), source.beams == 1 ? "beam" : "beams");
  } else if (source.sigma) {
    row.quality =
        "σ " + sigma_text(*source.sigma) + (source.sigma_unit == "°" ? "" : " ") + source.sigma_unit;
  } else if (source.satellites > 0) {
    row.quality = words(static_cast<std::uint64_t>(source.satellites), "satellites");
  }
  row.tool_tip = source.decoder + " · " + words(source.frames, source.frames == 1 ? "frame" : "frames");
  if (source.refused > 0)
    row.tool_tip += " · " + words(source.refused, "refused, last: ") + source.last_refusal;
  if (source.latency_s && std::abs(*source.latency_s) > 60.0) {
    row.alert = std::max(row.alert.value_or(Alarm::Priority::caution), Alarm::Priority::caution);
    row.tool_tip += " · its clock is " + latency_text(std::abs(*source.latency_s)) + " off";
  }
  return row;
}

/// An end of a range: who, where, how deep, how sure.
struct End {
  std::string name;
  Geodetic position;
  std::optional<double> depth_m;
  double drms_m;
  ValueState state;
};

RangeRow range_row(const End& from, const End& to) {
  RangeRow row;
  row.from = from.name, row.to = to.name;
  row.state = worse(from.state, to.state);
  row.tool_tip = "σ " + sigma_text(std::hypot(from.drms_m, to.drms_m)) + " m";
  if (row.state == ValueState::lost) return row;
  const auto line = geo::geodesic(from.position, to.position);
  row.horizontal = distance_text(line.distance_m);
  if (line.distance_m >= 0.1) row.bearing = heading_text(line.azimuth) + "° T";
  if (from.depth_m && to.depth_m)
    row.slant = distance_text(std::hypot(line.distance_m, *to.depth_m - *from.depth_m));
  return row;
}

}  // namespace

OwnDataText vehicle_text(const Snapshot& s, PositionFormat format) {
  return panel(s, s.vehicle, Body::vehicle, format);
}

OwnDataText ship_text(const Snapshot& s, PositionFormat format) {
  return panel(s, s.ship, Body::ship, format);
}

SourcesText sources_text(const Snapshot& s) {
  SourcesText text;
  std::size_t live = 0, heard = 0;
  for (const SourceState& source : s.sources) {
    text.rows.push_back(source_row(s, source));
    live += text.rows.back().state <= ValueState::ageing ? 1 : 0;
    heard += source.last ? 1 : 0;
  }
  if (text.rows.empty())
    text.absent = "no sources in this configuration";
  else
    text.fact = std::to_string(s.replay ? heard : live) + " of " + std::to_string(text.rows.size()) +
                (s.replay ? " recorded" : " live");
  return text;
}

RangesText ranges_text(const Snapshot& s) {
  RangesText text;
  const auto end_of = [&](const BodyState& body, bool ship) {
    return End{ship ? "Ship" : body.name, body.solution.position,
               ship                  ? std::optional(0.0)
               : body.solution.depth ? std::optional(body.solution.depth->m)
                                     : std::nullopt,
               std::sqrt(body.solution.var_north_m2 + body.solution.var_east_m2),
               state_of(s, body.valid, body.position ? body.position->period_s : 0.0)};
  };
  std::optional<End> ship, vehicle;
  if (s.ship) ship = end_of(*s.ship, true);
  if (s.vehicle) vehicle = end_of(*s.vehicle, false);
  if (ship && vehicle) text.rows.push_back(range_row(*ship, *vehicle));
  for (const auto& from : {vehicle, ship})
    for (const TargetState& target : s.targets)
      if (from)
        text.rows.push_back(range_row(*from, {target.name, target.position,
                                              target.depth ? std::optional(target.depth->m) : std::nullopt,
                                              std::sqrt(target.var_north_m2 + target.var_east_m2),
                                              state_of(s, target.feed.valid, target.feed.period_s)}));
  if (text.rows.empty()) text.absent = "nothing to measure between: only one thing has a position";
  if (!ship && !vehicle) text.absent = "nothing has a position yet";
  return text;
}

}  // namespace leadline::ui
