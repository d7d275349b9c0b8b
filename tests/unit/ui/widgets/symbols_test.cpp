// What is told by shape: alert icons, availability, the compass rose and its signs.

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <cmath>

#include "tests/support/picture.h"
#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/availability_boxes.h"
#include "ui/widgets/compass_rose.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

using Priority = Alarm::Priority;

QImage blank(int w, int h, const Colours& colours) {
  QImage image(w, h, QImage::Format_RGB32);
  image.fill(colours.of(Role::bg_tile));
  return image;
}

struct Symbols : testing::Test {
  Symbols() { Look::current().set(Palette::day); }
  const Colours colours{Palette::day};

  [[nodiscard]] QImage icon_of(Priority priority, AlertMark mark) const {
    QImage image = blank(40, 30, colours);
    QPainter painter(&image);
    draw_alert_icon(painter, {20, 15}, 22, priority, mark, colours);
    return image;
  }
  [[nodiscard]] QImage rose_of(const RoseAngles& angles) const {
    QImage image = blank(161, 161, colours);
    QPainter painter(&image);
    draw_compass_rose(painter, {80, 80}, angles, Role::vehicle, colours);
    return image;
  }
  /// Mean position of a colour relative to the rose's centre; x right, y down.
  [[nodiscard]] QPointF middle_of(const QImage& image, Role role) const {
    const QRgb wanted = colours.of(role).rgb();
    QPointF sum;
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixel(x, y) == wanted) {
          sum += QPointF(x - 80, y - 80);
          ++found;
        }
    return found ? sum / found : QPointF();
  }
};

TEST_F(Symbols, AlertsLookAsTheyDidWhenLookedAt) {
  for (const Palette palette : {Palette::day, Palette::dusk, Palette::night}) {
    const Colours c(palette);
    QImage sheet = blank(4 * 48 + 16, 8 * 36 + 40, c);
    QPainter painter(&sheet);
    int row = 0;
    for (const Priority priority :
         {Priority::emergency, Priority::alarm, Priority::warning, Priority::caution}) {
      int column = 0;
      for (const AlertMark mark :
           {AlertMark::unacknowledged, AlertMark::silenced, AlertMark::acknowledged, AlertMark::rectified}) {
        const QPointF at(32 + 48 * column, 22 + 36 * row);
        draw_alert_icon(painter, at, 24, priority, mark, c);
        const QRect fill(8 + 48 * column, 158 + 36 * row, 48, 36);
        painter.fillRect(fill, c.of(alert_roles(priority).fill));
        draw_alert_icon(painter, QRectF(fill).center(), 20, priority, mark, c, AlertGround::fill);
        ++column;
      }
      ++row;
    }
    painter.end();
    const char* const names[]{"day", "dusk", "night"};
    leadline::test::expect_picture(sheet, std::string("states_alerts_") + names[static_cast<int>(palette)]);
  }
}

TEST_F(Symbols, APriorityIsToldByShapeInAGreyPrint) {
  std::vector<QImage> shapes;
  for (const Priority priority :
       {Priority::emergency, Priority::alarm, Priority::warning, Priority::caution}) {
    QImage image = icon_of(priority, AlertMark::acknowledged);
    QImage shape(image.size(), QImage::Format_Grayscale8);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        shape.setPixelColor(x, y,
                            image.pixelColor(x, y) == colours.of(Role::bg_tile) ? colours.of(Role::bg_tile)
                                                                                : colours.of(Role::text));
    shapes.push_back(shape);
  }
  for (std::size_t a = 0; a < shapes.size(); ++a)
    for (std::size_t b = a + 1; b < shapes.size(); ++b) {
      int apart = 0;
      for (int y = 0; y < shapes[a].height(); ++y)
        for (int x = 0; x < shapes[a].width(); ++x) apart += shapes[a].pixel(x, y) != shapes[b].pixel(x, y);
      EXPECT_GT(apart, 40) << a << " and " << b;
    }
}

TEST_F(Symbols, AStateIsToldByItsGlyphAndACautionIsNeverAudible) {
  for (const Priority priority : {Priority::alarm, Priority::warning}) {
    EXPECT_NE(icon_of(priority, AlertMark::unacknowledged), icon_of(priority, AlertMark::silenced));
    EXPECT_NE(icon_of(priority, AlertMark::silenced), icon_of(priority, AlertMark::acknowledged));
    EXPECT_NE(icon_of(priority, AlertMark::acknowledged), icon_of(priority, AlertMark::rectified));
  }
  EXPECT_EQ(icon_of(Priority::caution, AlertMark::unacknowledged),
            icon_of(Priority::caution, AlertMark::acknowledged));
}

TEST_F(Symbols, AvailabilityAsksForAttentionFromCOn) {
  EXPECT_FALSE(attention(Mode::A) || attention(Mode::B));
  EXPECT_EQ(attention(Mode::C), Priority::caution);
  EXPECT_EQ(attention(Mode::D), Priority::caution);
  EXPECT_EQ(attention(Mode::E1), Priority::warning);
  EXPECT_EQ(attention(Mode::E0), Priority::alarm);
  AvailabilityBoxes boxes;
  boxes.resize(boxes.sizeHint());
  const auto filled = [&](Mode mode, Role role) {
    boxes.set(mode);
    const QImage picture = boxes.grab().toImage();
    int found = 0;
    for (int x = 0; x < picture.width(); ++x)
      found += picture.pixelColor(x, 3).name() == colours.of(role).name();
    return found;
  };
  EXPECT_EQ(filled(Mode::B, Role::caution), 0);
  EXPECT_GE(filled(Mode::C, Role::caution), 28);
  EXPECT_GE(filled(Mode::E1, Role::warning), 28);
  EXPECT_GE(filled(Mode::E0, Role::alarm), 28);
  EXPECT_EQ(boxes.accessibleName(), QStringLiteral("Availability E"));
}

TEST_F(Symbols, AHeadingOf071PointsEastNorthEast) {
  RoseAngles angles;
  angles.heading_deg = 71.9;
  const QImage rose = rose_of(angles);
  const QRgb own = colours.of(Role::vehicle).rgb();
  double farthest = 0;
  QPointF tip;
  for (int y = 0; y < rose.height(); ++y)
    for (int x = 0; x < rose.width(); ++x) {
      const QPointF from_centre(x - 80, y - 80);
      const double r = std::hypot(from_centre.x(), from_centre.y());
      if (rose.pixel(x, y) == own && r > farthest) {
        farthest = r;
        tip = from_centre;
      }
    }
  EXPECT_GT(farthest, 25);
  const double bearing = std::atan2(tip.x(), -tip.y()) * 180 / M_PI;
  EXPECT_NEAR(bearing, 71.9, 3.0);
}

TEST_F(Symbols, TheSetHeadingIsABugOutsideTheRing) {
  RoseAngles angles;
  angles.set_heading_deg = 250.0;
  const QPointF bug = middle_of(rose_of(angles), Role::plan);
  EXPECT_NEAR(std::atan2(bug.x(), -bug.y()) * 180 / M_PI + 360, 250, 3);
  EXPECT_GT(std::hypot(bug.x(), bug.y()), 66);
}

TEST_F(Symbols, TheCurrentPointsTowardWhereItSets) {
  RoseAngles angles;
  const QImage without = rose_of(angles);
  angles.current_to_deg = 180.0;
  const QImage with = rose_of(angles);
  int above = 0, below = 0, wide_near = 0, wide_far = 0;
  for (int y = 0; y < with.height(); ++y)
    for (int x = 0; x < with.width(); ++x)
      if (with.pixel(x, y) != without.pixel(x, y)) {
        (y < 80 ? above : below) += 1;
        if (std::abs(x - 80) > 4) (y - 80 < 36 ? wide_near : wide_far) += 1;
      }
  EXPECT_EQ(above, 0);
  EXPECT_GT(below, 40);
  EXPECT_GT(wide_far, wide_near);  // the head is at its far end
}

TEST_F(Symbols, AStaleHeadingIsAnOutlineAndALostOneIsNotDrawn) {
  RoseAngles angles;
  angles.heading_deg = 10.0;
  const auto ink = [&](ValueState state) {
    angles.state = state;
    const QImage rose = rose_of(angles);
    int found = 0;
    for (int y = 0; y < rose.height(); ++y)
      for (int x = 0; x < rose.width(); ++x) found += rose.pixel(x, y) == colours.of(Role::vehicle).rgb();
    return found;
  };
  EXPECT_GT(ink(ValueState::live), 500);
  EXPECT_GT(ink(ValueState::stale), 30);
  EXPECT_LT(ink(ValueState::stale), ink(ValueState::live) / 2);
  EXPECT_EQ(ink(ValueState::lost), 0);
}

}  // namespace
}  // namespace leadline::ui
