#include "ui/chart/layer_badge.h"

#include <gtest/gtest.h>

#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

using Doubt = BadgeLine::Doubt;

const BadgeLine kBathymetry{QStringLiteral("Bathymetry 5 m"), QStringLiteral("2025-08 · ± 8 m"), Doubt::none,
                            8.0};
const BadgeLine kMosaic{QStringLiteral("Side-scan mosaic 0.25 m"), QStringLiteral("live · ± 0.9 m"),
                        Doubt::none, 0.9};
const BadgeLine kUnknown{
    QStringLiteral("Chart"), QStringLiteral("accuracy unknown"), Doubt::accuracy_unknown, {}};
const BadgeLine kBroken{QStringLiteral("Sentinel-2"), QStringLiteral("file is cut short"), Doubt::broken,
                        2.0};

int caution_px(const std::vector<BadgeLine>& lines, bool folded) {
  const Colours day(Palette::day);
  const ChartView view(test::at_deg(36.9, 129.9), {800, 300}, 1.0);
  const QImage image = test::drawn(view.size(), day, Role::sea_deep, 1.0,
                                   [&](QPainter& p) { draw_layer_badge(p, view, lines, folded, day); });
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += test::is(image, {x, y}, day.of(Role::caution_icon), 20);
  return count;
}

TEST(LayerBadge, FoldedItTellsTheWorst) {
  EXPECT_EQ(worst_of({kBathymetry, kMosaic}).name, kBathymetry.name);
  EXPECT_EQ(worst_of({kBathymetry, kUnknown, kMosaic}).name, kUnknown.name);
  EXPECT_EQ(worst_of({kBroken, kUnknown, kMosaic}).name, kBroken.name);
}

TEST(LayerBadge, DoubtHasACautionIconFoldedOrNot) {
  for (const bool folded : {false, true}) {
    EXPECT_EQ(caution_px({kBathymetry, kMosaic}, folded), 0);
    EXPECT_GT(caution_px({kBathymetry, kUnknown}, folded), 50);
    EXPECT_GT(caution_px({kBathymetry, kBroken}, folded), 50);
  }
}

TEST(LayerBadge, ItNeverReachesTheOrientationBox) {
  BadgeLine wide = kBathymetry;
  wide.detail = QString(400, QLatin1Char('x'));
  const ChartView view(test::at_deg(36.9, 129.9), {800, 600}, 1.0);
  EXPECT_LE(layer_badge_box(view, {wide}, false).right(), 800.0 - 12.0 - 184.0 - 12.0);
  EXPECT_TRUE(layer_badge_box(view, {}, false).isNull());
  EXPECT_LT(layer_badge_box(view, {kBathymetry, kMosaic}, true).height(),
            layer_badge_box(view, {kBathymetry, kMosaic}, false).height());
}

}  // namespace
}  // namespace leadline::ui
