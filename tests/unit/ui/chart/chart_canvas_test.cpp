#include "ui/chart/chart_canvas.h"

#include <gtest/gtest.h>

#include <random>

#include "core/geo/geodesy.h"
#include "tests/support/picture.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

using std::chrono::seconds;

const Geodetic kSurvey{Angle::deg(36.91), Angle::deg(129.905)};
constexpr Time kStart{1'700'000'000'000'000'000};

/// A dive whose history can be let grow, with a fix every tenth second.
struct Dive {
  Snapshot snapshot;
  History history;
  bool with_vehicle = false;  ///< its label keeps its place: a fresh chart may put it elsewhere

  Dive() { history.tracks.push_back({0, "fusion", Body::vehicle, {}}); }
  void grow(int count) {
    for (int k = 0; k < count; ++k) {
      const int i = static_cast<int>(history.tracks[0].points.size());
      const Geodetic at = geo::displaced(kSurvey, 2.0 * i, 120.0 * std::sin(i / 40.0));
      history.tracks[0].points.push_back({kStart + seconds(i), at, 1.0F});
      if (i % 10 == 0) history.fixes.push_back({kStart + seconds(i), at, at, true, 0.0, 10.0, 0});
    }
    now(static_cast<int>(history.tracks[0].points.size()) - 1);
  }
  void now(int i) {
    snapshot.now = kStart + seconds(i);
    if (!with_vehicle) return;
    BodyState vehicle;
    vehicle.name = "MDV-1";
    vehicle.valid = snapshot.now;
    vehicle.rate_hz = 1.0;
    vehicle.solution.position = history.tracks[0].points[static_cast<std::size_t>(i)].position;
    vehicle.solution.heading = Angle::deg(10.0);
    vehicle.solution.var_north_m2 = vehicle.solution.var_east_m2 = 1.0;
    snapshot.vehicle = vehicle;
  }
};

QImage shown(ChartCanvas& chart) { return chart.grab().toImage(); }

/// The same moment and view on a canvas that has seen nothing before.
QImage fresh(const Dive& dive, const ChartCanvas& like) {
  ChartCanvas chart;
  chart.resize(like.size());
  chart.show();
  chart.set_history(&dive.history);
  chart.set_metres_per_px(like.view().metres_per_px());
  chart.set_centre(kSurvey);  // the projection's origin
  chart.set_centre(like.view().centre());
  chart.set_snapshot(dive.snapshot);
  return shown(chart);
}

class ChartCanvasTest : public testing::Test {
 protected:
  void SetUp() override {
    Look::current().set(Palette::day);
    chart_.resize(500, 400);
    chart_.show();
    chart_.set_centre(kSurvey);
    chart_.set_history(&dive_.history);
  }
  Dive dive_;
  ChartCanvas chart_;
};

TEST_F(ChartCanvasTest, ShowAllShowsTheTracksThatCameSinceTheLastPicture) {
  dive_.grow(3);
  chart_.set_snapshot(dive_.snapshot);
  shown(chart_);
  dive_.grow(200);  // few enough to be added, not painted anew
  chart_.set_snapshot(dive_.snapshot);
  chart_.show_all();
  const QImage picture = shown(chart_);
  const QRgb line = Look::current().colours().of(Role::track_fused).rgb();
  int found = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) found += picture.pixel(x, y) == line;
  EXPECT_GT(found, 100);
  // What was added lies over the fixes that were there; a line painted anew lies under them.
  EXPECT_LE(test::compare(picture, fresh(dive_, chart_)).different_share, 0.006);
}

TEST_F(ChartCanvasTest, AfterAnyHistoryItShowsWhatAFreshOneShows) {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> what(0, 7), some(1, 60);
  dive_.grow(50);
  chart_.set_metres_per_px(1.5);
  for (int step = 0; step < 80; ++step) {
    const int size = static_cast<int>(dive_.history.tracks[0].points.size());
    switch (what(random)) {
      case 0:
        dive_.grow(some(random));
        break;
      case 1:
        dive_.grow(some(random) * 20);
        break;
      case 2:
        dive_.now(size - 1 - some(random) % size);
        break;
      case 3:
        dive_.now(size - 1);
        break;
      case 4:
        chart_.zoom_by(some(random) % 2 == 0 ? 1.5 : 1.0 / 1.5);
        break;
      case 5:
        chart_.set_centre(dive_.history.tracks[0].points[static_cast<std::size_t>(size / 2)].position);
        break;
      case 6:
        chart_.show_all();
        break;
      default:
        break;
    }
    chart_.set_snapshot(dive_.snapshot);
    const auto found = test::compare(shown(chart_), fresh(dive_, chart_));
    // What was added segment by segment has caps where a line painted anew has joints.
    ASSERT_LE(found.different_share, 0.006) << "step " << step;
  }
}

TEST_F(ChartCanvasTest, FollowsAndTurnsWithoutPaintingEverythingEachTime) {
  dive_.with_vehicle = true;
  dive_.grow(30);
  chart_.set_metres_per_px(1.0);
  chart_.set_follow(Body::vehicle);
  for (int i = 0; i < 20; ++i) {
    dive_.grow(1);
    chart_.set_snapshot(dive_.snapshot);
    const QPointF at = chart_.view().to_screen(dive_.snapshot.vehicle->solution.position);
    EXPECT_NEAR(at.x(), 250.0, 1.0);
    EXPECT_NEAR(at.y(), 200.0, 1.0);
    EXPECT_EQ(chart_.view().up(), Angle{});
  }
}

}  // namespace
}  // namespace leadline::ui
