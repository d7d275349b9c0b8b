#include "ui/chart/live_layer.h"

#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"
#include "ui/chart/ellipse.h"
#include "ui/chart/fix_marks.h"
#include "ui/chart/motion_lines.h"
#include "ui/chart/offscreen_marks.h"
#include "ui/models/figures.h"
#include "ui/models/freshness.h"

namespace leadline::ui {
namespace {

QString qt(const std::string& text) { return QString::fromStdString(text); }

double drms_m(double var_north_m2, double var_east_m2) {
  return std::sqrt(std::max(0.0, var_north_m2 + var_east_m2));
}

double speed_mps(const Solution& s) {
  return std::hypot(s.vel_north_mps.value_or(0.0), s.vel_east_mps.value_or(0.0));
}

SymbolState symbol_state_of(ValueState state) {
  return state == ValueState::lost    ? SymbolState::lost
         : state == ValueState::stale ? SymbolState::stale
                                      : SymbolState::live;
}

/// What a symbol needs to be drawn, whoever it stands for.
struct Figure {
  Body body;
  std::string name, detail;
  Role role;
  Geodetic position;
  QPointF at;
  SymbolState state;
  double age_s, sigma_m, speed_mps;
  std::optional<SigmaEllipse> ellipse;
  const Solution* solution;  ///< null: a target
};

Figure figure_of(const ChartView& view, const Snapshot& snapshot, const BodyState& body, Body which) {
  const Solution& s = body.solution;
  Figure figure{which,
                body.name,
                {},
                which == Body::ship ? Role::ship : Role::vehicle,
                s.position,
                view.to_screen(s.position),
                symbol_state(snapshot, body),
                seconds(snapshot.now - body.valid),
                drms_m(s.var_north_m2, s.var_east_m2),
                speed_mps(s),
                sigma_ellipse(s.var_north_m2, s.cov_north_east_m2, s.var_east_m2),
                &s};
  if (which == Body::vehicle && s.depth) figure.detail = number_text(s.depth->m, 1) + " m · ";
  figure.detail += "σ " + sigma_text(figure.sigma_m) + " m";
  if (which == Body::ship) figure.detail += " · " + age_text(duration(figure.age_s));
  return figure;
}

Figure figure_of(const ChartView& view, const Snapshot& snapshot, const TargetState& target) {
  const double age_s = seconds(snapshot.now - target.feed.valid);
  const double sigma_m = drms_m(target.var_north_m2, target.var_east_m2);
  return {Body::target, target.name, "σ " + sigma_text(sigma_m) + " m" + " · " + age_text(duration(age_s)),
          Role::target, target.position, view.to_screen(target.position),
          // A target lies still: it is seen now and then, and is not lost between.
          SymbolState::live, age_s, sigma_m, 0.0,
          sigma_ellipse(target.var_north_m2, target.cov_north_east_m2, target.var_east_m2), nullptr};
}

/// Lines ahead of a body, drawn before its symbol; they are obstacles to labels.
void draw_ahead(QPainter& painter, const ChartView& view, const Figure& figure, const Colours& colours,
                std::vector<QLineF>& lines) {
  const Solution& s = *figure.solution;
  if (figure.state == SymbolState::lost) return;
  if (s.vel_north_mps && s.vel_east_mps) {
    // What a velocity is worth is not part of a solution: a tenth of a knot stands for it.
    constexpr double kSigma_mps = 0.05;
    const auto vector = course_vector(view, figure.position, {*s.vel_north_mps, *s.vel_east_mps}, kSigma_mps,
                                      figure.body == Body::ship ? kShipVector_s : kVehicleVector_s);
    if (vector) {
      draw_course_vector(painter, *vector, figure.role, colours);
      lines.push_back(*vector);
    }
  }
  if (!s.heading) return;
  const double angle = view.screen_angle_deg(*s.heading, figure.position);
  const bool ship = figure.body == Body::ship;
  const QLineF heading = heading_line(figure.at, angle, ship ? kShipBow_px : kVehicleTip_px,
                                      ship ? kShipHeadingLine_px : kVehicleHeadingLine_px);
  draw_heading_line(painter, heading, figure.role, colours);
  lines.push_back(heading);
}

void draw_symbol(QPainter& painter, const ChartView& view, const Figure& figure, const Colours& colours) {
  const SymbolLook look{figure.state, false};
  if (figure.body == Body::target) return draw_target(painter, figure.at, look, colours);
  // Without a heading the symbol points up and has no heading line.
  const double angle =
      figure.solution->heading ? view.screen_angle_deg(*figure.solution->heading, figure.position) : 0.0;
  if (figure.body == Body::ship)
    draw_ship(painter, figure.at, angle, look, colours);
  else
    draw_vehicle(painter, figure.at, angle, look, colours);
}

}  // namespace

SymbolState symbol_state(const Snapshot& snapshot, const BodyState& body) {
  const double period_s = body.rate_hz > 0.0 ? 1.0 / body.rate_hz : 0.0;
  return symbol_state_of(freshness(snapshot.now - body.valid, period_s));
}

void LiveLayer::paint(QPainter& painter, const ChartView& view, const Snapshot& snapshot,
                      std::optional<Body> follow, const std::vector<QRectF>& taken, const Colours& colours) {
  // From below to above; labels are placed the other way round, so that the vehicle's has the first choice.
  std::vector<Figure> figures;
  for (const TargetState& target : snapshot.targets) figures.push_back(figure_of(view, snapshot, target));
  if (snapshot.ship) figures.push_back(figure_of(view, snapshot, *snapshot.ship, Body::ship));
  if (snapshot.vehicle) figures.push_back(figure_of(view, snapshot, *snapshot.vehicle, Body::vehicle));

  LabelObstacles obstacles{taken, {}};
  if (snapshot.beam && snapshot.ship) {
    const double age_s = seconds(snapshot.now - snapshot.beam->feed.valid);
    const ValueState state = freshness(duration(age_s), snapshot.beam->feed.period_s);
    if (state != ValueState::stale && state != ValueState::lost) {
      const QPointF ship = view.to_screen(snapshot.ship->solution.position);
      const QPointF vehicle = view.to_screen(snapshot.beam->transponder);
      std::vector<QRectF> symbols = taken;
      for (const Figure& figure : figures) symbols.emplace_back(figure.at - QPointF(16, 16), QSizeF(32, 32));
      obstacles.boxes.push_back(
          draw_usbl_beam(painter, ship, vehicle, "USBL " + qt(age_text(duration(age_s))), colours, symbols));
    }
  }
  const QRectF chart(QPointF(0, 0), QSizeF(view.size()));
  std::vector<OffscreenMark> outside;
  std::vector<Label> labels;
  for (const Figure& figure : figures) {
    if (figure.ellipse && figure.state != SymbolState::lost)
      draw_sigma_ellipse(painter, view, figure.position, *figure.ellipse, figure.role, colours);
  }
  const Geodetic from = follow == Body::ship && snapshot.ship         ? snapshot.ship->solution.position
                        : follow == Body::vehicle && snapshot.vehicle ? snapshot.vehicle->solution.position
                                                                      : view.centre();
  for (const Figure& figure : figures) {
    if (is_offscreen(figure.at, view.size())) {
      outside.push_back({figure.body,
                         figure.at,
                         qt(distance_text(geo::geodesic(from, figure.position).distance_m)),
                         {figure.state, false}});
      continue;
    }
    const double doubt_px =
        grown_sigma_m(figure.sigma_m, figure.speed_mps, duration(figure.age_s)) / view.metres_per_px();
    draw_doubt(painter, figure.at, doubt_px, figure.state, figure.role, colours);
    if (figure.solution != nullptr) draw_ahead(painter, view, figure, colours, obstacles.lines);
  }
  for (const Figure& figure : figures) {
    if (is_offscreen(figure.at, view.size())) continue;
    draw_symbol(painter, view, figure, colours);
    if (figure.state != SymbolState::live) {
      const double doubt_px =
          grown_sigma_m(figure.sigma_m, figure.speed_mps, duration(figure.age_s)) / view.metres_per_px();
      const std::string text = figure.state == SymbolState::stale
                                   ? age_text(duration(figure.age_s))
                                   : "last " + time_text(snapshot.now - duration(figure.age_s));
      obstacles.boxes.push_back(draw_age(painter, figure.at, doubt_px, qt(text), colours));
    }
    labels.push_back({figure.name, figure.at, 16.0, qt(figure.name), figure.role, qt(figure.detail)});
  }
  std::reverse(labels.begin(), labels.end());
  for (const QRectF& box : draw_offscreen_marks(painter, view.size(), outside, taken, colours))
    obstacles.boxes.push_back(box);
  for (const PlacedLabel& label : place_labels(places_, labels, obstacles, chart))
    draw_label(painter, label, colours);
}

}  // namespace leadline::ui
