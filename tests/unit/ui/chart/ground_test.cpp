#include "ui/chart/ground.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/picture.h"
#include "ui/chart/track_path.h"

namespace leadline::ui {
namespace {

const Geodetic kSurvey{Angle::deg(36.91), Angle::deg(129.905)};

/// A wander as a vehicle makes it: mostly ahead, now and then a turn.
std::vector<maps::PlanePoint> wander(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> turn(0.0, 0.03), noise(0.0, 0.05);
  std::vector<maps::PlanePoint> points(count);
  double heading = 1.0, east = 0.0, north = 0.0;
  for (auto& p : points) {
    heading += turn(random);
    east += 0.5 * std::sin(heading);
    north += 0.5 * std::cos(heading);
    p = {east + noise(random), north + noise(random)};
  }
  return points;
}

const TrackPens kPens{QPen(Qt::white, 4.6, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin),
                      QPen(Qt::black, 2.2, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin)};

QImage fresh(const ChartView& view, const Ground::Paint& paint) {
  Ground ground;
  ground.update(view, paint);
  QImage picture(view.size(), QImage::Format_RGB32);
  QPainter painter(&picture);
  ground.draw(painter);
  return picture;
}

TEST(TrackPath, IsDrawnAsTheWholePolylineWouldBe) {
  const auto points = wander(20'000, 3);
  TrackPath path;
  path.append(points);
  for (const double metres_per_px : {0.2, 1.0, 7.0, 60.0}) {
    ChartView view(kSurvey, {600, 500}, metres_per_px, Angle::deg(20.0));
    for (const std::size_t shown : {points.size(), std::size_t{12'345}, std::size_t{2}}) {
      const maps::PlanePoint last = points[shown - 1];
      view.centre_on(view.projection().reverse(last));
      const auto canvas = [&] {
        QImage image(view.size(), QImage::Format_RGB32);
        image.fill(Qt::gray);
        return image;
      };
      QImage actual = canvas(), expected = canvas();
      {
        QPainter painter(&actual);
        painter.setRenderHint(QPainter::Antialiasing);
        path.paint(painter, view, QRect(QPoint(0, 0), view.size()), shown, kPens);
      }
      {
        QPainter painter(&expected);
        painter.setRenderHint(QPainter::Antialiasing);
        QPolygonF line;
        for (std::size_t i = 0; i < shown; ++i) line << view.to_screen(points[i]);
        for (const QPen& pen : {kPens.halo, kPens.line}) painter.setPen(pen), painter.drawPolyline(line);
      }
      // Half a pixel aside at most: where the one has its line the other has it at or beside that pixel.
      const auto missed = [](const QImage& of, const QImage& in) {
        long long count = 0;
        for (int y = 1; y + 1 < of.height(); ++y)
          for (int x = 1; x + 1 < of.width(); ++x) {
            if (qGreen(of.pixel(x, y)) > 60) continue;
            bool found = false;
            for (int dy = -1; dy <= 1; ++dy)
              for (int dx = -1; dx <= 1; ++dx) found |= qGreen(in.pixel(x + dx, y + dy)) < 125;
            count += found ? 0 : 1;
          }
        return count;
      };
      EXPECT_EQ(missed(actual, expected), 0) << metres_per_px << " m/px, " << shown << " points";
      EXPECT_EQ(missed(expected, actual), 0) << metres_per_px << " m/px, " << shown << " points";
    }
  }
}

TEST(TrackPath, CostsWhatIsSeenOfIt) {
  TrackPath path;
  path.append(wander(200'000, 5));
  EXPECT_GE(path.vertices(0.01), 150'000U);
  EXPECT_LE(path.vertices(10.0), 12'000U);
  EXPECT_LE(path.vertices(1'000.0), 300U);
}

TEST(Ground, AfterAnyWayItShowsWhatAFreshOneShows) {
  const auto points = wander(5'000, 9);
  TrackPath path;
  path.append(points);
  const auto view_paint = [&](const ChartView& view) {
    return [&path, &view](QPainter& painter, const QRect& exposed) {
      painter.fillRect(exposed, Qt::gray);
      path.paint(painter, view, exposed, path.size(), kPens);
    };
  };
  ChartView view(kSurvey, {320, 240}, 2.0);
  view.centre_on(view.projection().reverse(points[2'000]));
  Ground ground;
  std::mt19937 random(11);
  std::uniform_int_distribution<int> step(-90, 90), what(0, 9);
  for (int i = 0; i < 60; ++i) {
    const int choice = what(random);
    if (choice == 0)
      view.zoom(choice % 2 ? 1.3 : 0.8, {100, 100});
    else if (choice == 1)
      view.turn(Angle::deg(step(random)));
    else if (choice == 2)
      view.resize({300 + step(random), 240});
    else if (choice == 3)
      ground.invalidate(view.plane_box({20, 30, 50, 60}));
    else if (choice == 4)
      view.pan({1000 * step(random), 3});
    else if (choice == 5)
      view.centre_on(view.projection().reverse(points[2'500]));
    else
      view.pan({step(random), step(random)});
    ground.update(view, view_paint(view));
    QImage picture(view.size(), QImage::Format_RGB32);
    QPainter painter(&picture);
    ground.draw(painter);
    painter.end();
    ASSERT_TRUE(test::compare(picture, fresh(view, view_paint(view))).same()) << "step " << i;
  }
}

TEST(Ground, PaintsOnlyWhatComesIntoSight) {
  Ground ground;
  ChartView view(kSurvey, {1000, 800}, 2.0);
  const Ground::Paint paint = [](QPainter& painter, const QRect& exposed) {
    painter.fillRect(exposed, Qt::gray);
  };
  ground.update(view, paint);
  EXPECT_EQ(ground.take_painted_px(), 800'000);
  ground.update(view, paint);
  EXPECT_EQ(ground.take_painted_px(), 0);
  view.pan({3, -2});
  ground.update(view, paint);
  EXPECT_EQ(ground.take_painted_px(), 3 * 800 + 2 * 997);
}

TEST(Ground, WhatIsAddedLiesOnTheSamePlace) {
  const auto points = wander(400, 21);
  ChartView view(kSurvey, {320, 240}, 1.0);
  TrackPath path;
  path.append(std::span(points).first(300));
  std::size_t shown = 300;
  const auto paint = [&](QPainter& painter, const QRect& exposed) {
    painter.fillRect(exposed, Qt::gray);
    path.paint(painter, view, exposed, shown, kPens);
  };
  Ground ground;
  ground.update(view, paint);
  for (; shown < 400; ++shown) {
    path.append(std::span(points).subspan(shown, 1));
    view.pan({shown % 3 == 0 ? 1 : 0, 1});
    ground.update(view, paint);
    ground.add(QRect(0, 0, 320, 240), [&](QPainter& painter, const QRect&) {
      path.paint_added(painter, view, shown - 1, shown + 1, kPens);
    });
  }
  QImage picture(view.size(), QImage::Format_RGB32);
  QPainter painter(&picture);
  ground.draw(painter);
  painter.end();
  const test::PictureDifference found = test::compare(picture, fresh(view, paint));
  EXPECT_LE(found.different_share, 0.01);  // joints are caps until they are painted anew
}

}  // namespace
}  // namespace leadline::ui
