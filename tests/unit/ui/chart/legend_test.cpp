#include "ui/chart/legend.h"

#include <gtest/gtest.h>

#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

TEST(Legend, ItHasARowForWhatIsShownAndNoOther) {
  const Colours day(Palette::day);
  const LegendRow fused{LegendRow::Sample::line, {Role::track_fused, 2.2}, QStringLiteral("fused")};
  const LegendRow reckoned{
      LegendRow::Sample::line, {Role::track_dr, 1.5, {7.0, 4.0}}, QStringLiteral("dead reckoning")};
  const auto count = [&](const std::vector<LegendRow>& rows, Role role) {
    QRectF box;
    const QImage image = test::drawn({300, 200}, day, Role::sea_deep, 1.0, [&](QPainter& p) {
      box = draw_legend(p, {12, 188}, rows, day);
    });
    EXPECT_EQ(box, legend_box({12, 188}, rows));
    if (!rows.empty()) {
      EXPECT_DOUBLE_EQ(box.bottom(), 188.0);
    }
    int found = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 50; ++x) found += test::is(image, {x, y}, day.of(role), 150) ? 1 : 0;
    return found;
  };
  EXPECT_EQ(count({}, Role::track_fused), 0);
  EXPECT_GE(count({fused}, Role::track_fused), 30);
  EXPECT_EQ(count({fused}, Role::track_dr), 0);
  const int dashes = count({fused, reckoned}, Role::track_dr);
  EXPECT_GT(dashes, 10);
  EXPECT_LT(dashes, 50);  // with gaps
}

}  // namespace
}  // namespace leadline::ui
