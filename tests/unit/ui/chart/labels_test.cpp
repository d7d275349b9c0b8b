#include "ui/chart/labels.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/ui/chart/drawn.h"
#include "ui/chart/motion_lines.h"

namespace leadline::ui {
namespace {

const QRectF kChart(0, 0, 1448, 760);

// std::mt19937 alone gives the same numbers everywhere; the distributions do not.
double random(std::mt19937& numbers, double low, double high) {
  return low + (high - low) * (static_cast<double>(numbers()) / 4294967296.0);
}

Label label(const std::string& key, QPointF at) {
  return {key, at, 16.0, QString::fromStdString(key), Role::vehicle, QStringLiteral("1512.4 m · σ 0.6 m")};
}

LabelObstacles furniture() {
  return {{{12, 12, 410, 84},
           {1252, 12, 184, 70},
           {12, 590, 158, 110},
           {10, 705, 240, 32},
           {1216, 590, 220, 156}},
          {}};
}

struct Scene {
  std::vector<Label> labels;
  LabelObstacles obstacles = furniture();
};

Scene scene(std::mt19937& numbers) {
  Scene made;
  const int count = 2 + static_cast<int>(numbers() % 11);
  // Half of them crowd together, as at a recovery.
  const QPointF crowd(random(numbers, 200, 1200), random(numbers, 100, 650));
  for (int i = 0; i < count; ++i) {
    const bool near = i % 2 == 0;
    const QPointF at = near ? crowd + QPointF(random(numbers, -90, 90), random(numbers, -60, 60))
                            : QPointF(random(numbers, 0, 1448), random(numbers, 0, 760));
    made.labels.push_back(label("MDV-" + std::to_string(i), at));
    made.obstacles.lines.push_back(heading_line(at, random(numbers, 0, 360), 14.0, 44.0));
  }
  return made;
}

TEST(Labels, NeverOverlapInFiveHundredScenes) {
  std::mt19937 numbers(7);
  int placed_count = 0, leaders = 0;
  for (int i = 0; i < 500; ++i) {
    const Scene made = scene(numbers);
    LabelPlaces places;
    const auto placed = place_labels(places, made.labels, made.obstacles, kChart);
    for (std::size_t a = 0; a < placed.size(); ++a) {
      ++placed_count;
      leaders += placed[a].leader.isNull() ? 0 : 1;
      EXPECT_TRUE(kChart.contains(placed[a].box));
      for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(placed[a].box.intersects(placed[b].box)) << i;
      for (const QRectF taken : made.obstacles.boxes) EXPECT_FALSE(placed[a].box.intersects(taken)) << i;
      for (const QLineF line : made.obstacles.lines) {
        for (double s = 0.0; s <= 1.0; s += 0.05)
          EXPECT_FALSE(placed[a].box.adjusted(0.1, 0.1, -0.1, -0.1).contains(line.pointAt(s))) << i;
      }
      if (placed[a].leader.isNull()) {
        const QRectF near = placed[a].box.adjusted(-16, -16, 16, 16);
        EXPECT_TRUE(near.contains(placed[a].label.at)) << i;
      }
    }
  }
  EXPECT_GT(placed_count, 3000);
  RecordProperty("labels", placed_count);
  RecordProperty("leaders", leaders);
  EXPECT_LT(leaders, placed_count / 3);
}

TEST(Labels, PlacesAreTriedInTurn) {
  const std::vector<Label> one{label("MDV-1", {700, 400})};
  const auto where = [&](std::vector<QRectF> boxes) {
    LabelPlaces places;
    return place_labels(places, one, {std::move(boxes), {}}, kChart).front();
  };
  const QRectF right_below(720, 415, 40, 10), right_above(720, 375, 40, 10), left_below(640, 415, 40, 10),
      left_above(640, 375, 40, 10);
  const auto corner = [](const PlacedLabel& placed) {
    const QPointF off = placed.box.center() - placed.label.at;
    return std::string(off.x() > 0 ? "right" : "left") + (off.y() > 0 ? " below" : " above");
  };
  EXPECT_EQ(corner(where({})), "right below");
  EXPECT_EQ(corner(where({right_below})), "right above");
  EXPECT_EQ(corner(where({right_below, right_above})), "left below");
  EXPECT_EQ(corner(where({right_below, right_above, left_below})), "left above");
  EXPECT_FALSE(where({right_below, right_above, left_below, left_above}).leader.isNull());
}

TEST(Labels, ALabelStaysWhileItsPlaceIsFree) {
  LabelPlaces places;
  std::vector<Label> one{label("MDV-1", {700, 400})};
  const QRectF passing(720, 415, 40, 10);
  const auto blocked = place_labels(places, one, {{passing}, {}}, kChart).front();
  const auto after = place_labels(places, one, {}, kChart).front();
  EXPECT_EQ(after.box, blocked.box);  // right below is free again, and yet
  one.front().at += QPointF(3, -2);
  EXPECT_EQ(place_labels(places, one, {}, kChart).front().box, blocked.box.translated(3, -2));
}

TEST(Labels, ANewcomerPushesNobodyAway) {
  LabelPlaces places;
  const Label old = label("MDV-1", {700, 400});
  const auto before = place_labels(places, {old}, {}, kChart).front();
  const auto both = place_labels(places, {label("ship", {706, 430}), old}, {}, kChart);
  EXPECT_EQ(both.size(), 2U);
  const auto mine =
      std::find_if(both.begin(), both.end(), [](const auto& p) { return p.label.key == "MDV-1"; });
  const bool free = !before.box.intersects(QRectF(706 - 11.2, 430 - 11.2, 22.4, 22.4));
  EXPECT_EQ(mine->box == before.box, free);
}

TEST(Labels, SmallMovesDoNotMakeThemJump) {
  std::mt19937 numbers(11);
  int labels = 0, jumps = 0, worst = 0;
  for (int i = 0; i < 60; ++i) {
    Scene made = scene(numbers);
    const Scene start = made;
    LabelPlaces places;
    std::map<std::string, QPointF> offset;
    std::map<std::string, int> jumped;
    for (int frame = 0; frame < 40; ++frame) {
      for (std::size_t k = 0; k < made.labels.size(); ++k) {
        const QPointF by(random(numbers, -1.5, 1.5), random(numbers, -1.5, 1.5));
        made.labels[k].at = start.labels[k].at + by;
        made.obstacles.lines[k] = start.obstacles.lines[k].translated(by);
      }
      for (const PlacedLabel& placed : place_labels(places, made.labels, made.obstacles, kChart)) {
        const QPointF off = placed.box.center() - placed.label.at;
        const auto known = offset.find(placed.label.key);
        if (known != offset.end() && QLineF(off, known->second).length() > 1e-6) ++jumped[placed.label.key];
        offset[placed.label.key] = off;
      }
    }
    labels += static_cast<int>(made.labels.size());
    for (const auto& [key, count] : jumped) {
      jumps += count;
      worst = std::max(worst, count);
    }
  }
  RecordProperty("labels", labels);
  RecordProperty("jumps", jumps);
  RecordProperty("worst", worst);
  EXPECT_LE(worst, 4);
  EXPECT_LT(jumps, labels / 2);
}

TEST(Labels, ALeaderGoesWhenThereIsRoomAgain) {
  LabelPlaces places;
  const std::vector<Label> one{label("MDV-1", {700, 400})};
  const QRectF all_round(600, 340, 200, 120);
  EXPECT_FALSE(place_labels(places, one, {{all_round}, {}}, kChart).empty());
  const auto after = place_labels(places, one, {}, kChart).front();
  EXPECT_TRUE(after.leader.isNull());
}

TEST(Labels, WhatIsOffTheChartHasNone) {
  LabelPlaces places;
  EXPECT_TRUE(place_labels(places, {label("MDV-1", {-20, 400})}, {}, kChart).empty());
}

}  // namespace
}  // namespace leadline::ui
