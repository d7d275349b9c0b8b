// A chart with all its furniture, graticule and labels, as the operator sees them together.

#include <gtest/gtest.h>

#include "tests/support/picture.h"
#include "tests/unit/ui/chart/drawn.h"
#include "tests/unit/ui/chart/grounds.h"
#include "ui/chart/ellipse.h"
#include "ui/chart/fix_marks.h"
#include "ui/chart/graticule.h"
#include "ui/chart/labels.h"
#include "ui/chart/layer_badge.h"
#include "ui/chart/legend.h"
#include "ui/chart/motion_lines.h"
#include "ui/chart/offscreen_marks.h"
#include "ui/chart/orientation_box.h"
#include "ui/chart/scale_bar.h"
#include "ui/chart/watermark.h"

namespace leadline::ui {
namespace {

const std::vector<BadgeLine> kLayers{
    {QStringLiteral("Bathymetry 5 m"), QStringLiteral("2025-08 · ± 8 m · shift 0.0 m"),
     BadgeLine::Doubt::none, 8.0},
    {QStringLiteral("Side-scan mosaic 0.25 m"), QStringLiteral("live · ± 0.9 m"), BadgeLine::Doubt::none,
     0.9},
    {QStringLiteral("Overview Sentinel-2"),
     QStringLiteral("accuracy unknown"),
     BadgeLine::Doubt::accuracy_unknown,
     {}}};

const std::vector<LegendRow> kLegend{
    {LegendRow::Sample::line, {Role::track_fused, 2.2}, QStringLiteral("fused")},
    {LegendRow::Sample::line, {Role::track_dr, 1.5, {7.0, 4.0}}, QStringLiteral("dead reckoning")},
    {LegendRow::Sample::line, {Role::plan, 2.6}, QStringLiteral("active leg")},
    {LegendRow::Sample::fixes, {}, QStringLiteral("fix used, refused")}};

struct Case {
  const char* name;
  Palette palette;
  Orientation orientation;
  double up_deg;
  test::Ground ground;
  bool replay, folded;
  Geodetic centre;
  double metres_per_px;
};

QImage picture(const Case& shown) {
  const Colours colours(shown.palette);
  const ChartView view(shown.centre, {1000, 560}, shown.metres_per_px, Angle::deg(shown.up_deg));
  QImage image = test::ground(shown.ground, view.size(), colours);
  QPainter p(&image);
  const GraticuleStep step = graticule_step(view);
  draw_graticule(p, view, step, image.rect(), colours);
  if (shown.replay) draw_replay_watermark(p, image.rect(), colours);

  const Geodetic ship = view.to_geodetic({640, 400}), vehicle = view.to_geodetic({480, 250}),
                 target = view.to_geodetic({610, 300});
  const QPointF ship_px = view.to_screen(ship), vehicle_px = view.to_screen(vehicle);
  LabelObstacles obstacles;
  obstacles.boxes = {orientation_box(view, {shown.orientation, Motion::true_motion, QStringLiteral("MDV-1")}),
                     layer_badge_box(view, kLayers, shown.folded), scale_bar_box(view)};
  obstacles.boxes.push_back(legend_box({12, obstacles.boxes.back().top() - 4.0}, kLegend));

  const QRectF beam = draw_usbl_beam(p, ship_px, vehicle_px, QStringLiteral("USBL 3 s"), colours,
                                     {QRectF(view.to_screen(target) - QPointF(30, 26), QSizeF(60, 52))});
  obstacles.boxes.push_back(beam);
  draw_sigma_ellipse(p, view, target,
                     {22.0 * view.metres_per_px(), 14.0 * view.metres_per_px(), Angle::deg(60)}, Role::target,
                     colours);
  draw_target(p, view.to_screen(target), {}, colours);
  const auto moves = [&](Geodetic at, double heading, geo::NorthEast velocity, double tip, double length,
                         double seconds, Role role) {
    const QPointF px = view.to_screen(at);
    if (const auto vector = course_vector(view, at, velocity, 0.01, seconds)) {
      draw_course_vector(p, *vector, role, colours);
      obstacles.lines.push_back(*vector);
    }
    const QLineF line = heading_line(px, view.screen_angle_deg(Angle::deg(heading), at), tip, length);
    draw_heading_line(p, line, role, colours);
    obstacles.lines.push_back(line);
  };
  moves(ship, 308.0, {0.20, -0.12}, kShipBow_px, kShipHeadingLine_px, kShipVector_s, Role::ship);
  moves(vehicle, 71.9, {0.372, 1.370}, kVehicleTip_px, kVehicleHeadingLine_px, kVehicleVector_s,
        Role::vehicle);
  draw_ship(p, ship_px, view.screen_angle_deg(Angle::deg(308.0), ship), {}, colours);
  draw_vehicle(p, vehicle_px, view.screen_angle_deg(Angle::deg(71.9), vehicle), {}, colours);
  draw_brackets(p, vehicle_px, Role::ink, colours);
  obstacles.lines.emplace_back(ship_px, vehicle_px);

  LabelPlaces places;
  const std::vector<Label> labels{
      {"vehicle", vehicle_px, 26.0, QStringLiteral("MDV-1"), Role::vehicle,
       QStringLiteral("1512.4 m · σ 0.6 m")},
      {"ship", ship_px, 16.0, QStringLiteral("HAEYANG 7"), Role::ship, QStringLiteral("σ 0.9 m · 0.2 s")},
      {"target", view.to_screen(target), 30.0, QStringLiteral("T1"), Role::target,
       QStringLiteral("σ 23 m · 41 s")}};
  const auto marks = draw_offscreen_marks(
      p, view.size(), {{Body::target, {1900, 420}, QStringLiteral("3.8 km"), {}}}, obstacles.boxes, colours);
  obstacles.boxes.insert(obstacles.boxes.end(), marks.begin(), marks.end());
  for (const PlacedLabel& label : place_labels(places, labels, obstacles, image.rect()))
    draw_label(p, label, colours);

  draw_graticule_figures(p, view, step, obstacles.boxes, colours);
  draw_orientation_box(p, view, {shown.orientation, Motion::true_motion, QStringLiteral("MDV-1")}, colours);
  draw_layer_badge(p, view, kLayers, shown.folded, colours);
  const QRectF bar = draw_scale_bar(p, view, colours);
  draw_legend(p, {12, bar.top() - 4.0}, kLegend, colours);
  return image;
}

class FurnitureSheet : public testing::TestWithParam<Case> {};

TEST_P(FurnitureSheet, LooksAsItDid) {
  const QImage image = picture(GetParam());
  test::look_at(image, GetParam().name);
  leadline::test::expect_picture(image, GetParam().name);
}

const Geodetic kDive{Angle::deg(36.9087), Angle::deg(129.9042)};
INSTANTIATE_TEST_SUITE_P(Charts, FurnitureSheet,
                         testing::Values(Case{"furniture_day", Palette::day, Orientation::north_up, 0.0,
                                              test::Ground::shallow, false, false, kDive, 1.0584},
                                         Case{"furniture_dusk_replay", Palette::dusk, Orientation::course_up,
                                              74.8, test::Ground::mosaic, true, true, kDive, 1.0584},
                                         Case{"furniture_night_pole", Palette::night, Orientation::north_up,
                                              0.0, test::Ground::imagery, false, false,
                                              Geodetic{Angle::deg(89.4), Angle::deg(10.0)}, 300.0}),
                         [](const auto& shown) { return std::string(shown.param.name); });

}  // namespace
}  // namespace leadline::ui
