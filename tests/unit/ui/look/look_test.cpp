#include "ui/look/look.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QFontMetricsF>
#include <QImage>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/look/focus_ring.h"
#include "ui/look/halo_text.h"
#include "ui/look/icon.h"
#include "ui/look/style_sheet.h"

namespace leadline::ui {
namespace {

struct LookTest : testing::Test {
  LookTest() { Look::current().set(Palette::day); }
};

TEST_F(LookTest, FontsAreTheBundledOnesWithFiguresOfOneWidth) {
  for (const bool bold : {false, true}) {
    const QFont f = font(28, bold);
    const QFontMetricsF metrics(f);
    for (char digit = '0'; digit <= '9'; ++digit)
      EXPECT_NEAR(metrics.horizontalAdvance(QChar(digit)), 0.65 * 28, 0.3) << digit;
    // Not the fixed pitch, which names B612 as its second family.
    EXPECT_NEAR(metrics.horizontalAdvance(QLatin1Char('.')), 0.30 * 28, 0.3);
  }
  const QFontMetricsF mono(mono_font(13));
  EXPECT_DOUBLE_EQ(mono.horizontalAdvance(QLatin1Char('i')), mono.horizontalAdvance(QLatin1Char('W')));
}

TEST_F(LookTest, ThePaletteFollowsTheTable) {
  for (const Palette palette : {Palette::day, Palette::dusk, Palette::night}) {
    Look::current().set(palette);
    const QPalette p = QApplication::palette();
    const Colours colours(palette);
    EXPECT_EQ(p.color(QPalette::Window), colours.of(Role::bg_panel));
    EXPECT_EQ(p.color(QPalette::Base), colours.of(Role::bg_tile));
    EXPECT_EQ(p.color(QPalette::Button), colours.of(Role::bg_raised));
    EXPECT_EQ(p.color(QPalette::Highlight), colours.of(Role::select));
    EXPECT_EQ(p.color(QPalette::Shadow), colours.of(Role::bg_window));
    EXPECT_EQ(p.color(QPalette::Inactive, QPalette::Text), colours.of(Role::text));
    EXPECT_EQ(p.color(QPalette::Disabled, QPalette::ButtonText), colours.of(Role::text_off));
  }
}

TEST_F(LookTest, AChangeIsToldOnceAndBeforeTheNextPaint) {
  int told = 0;
  QObject::connect(&Look::current(), &Look::lookChanged, qApp, [&] {
    ++told;
    EXPECT_EQ(QApplication::palette().color(QPalette::Window), Look::current().colours().of(Role::bg_panel));
  });
  Look::current().set(Palette::night, 2);
  Look::current().set(Palette::night, 2);
  EXPECT_EQ(told, 1);
  EXPECT_EQ(Look::current().dimmer_step(), 2);
  EXPECT_DOUBLE_EQ(Look::current().colours().luminance(), 0.5);
  QObject::disconnect(&Look::current(), &Look::lookChanged, qApp, nullptr);
}

TEST_F(LookTest, TheStyleSheetHasNoTokenLeft) {
  const QString sheet = style_sheet(Colours(Palette::night));
  EXPECT_FALSE(sheet.contains(QLatin1Char('@')));
  EXPECT_TRUE(sheet.contains(Colours(Palette::night).of(Role::line_strong).name()));
  EXPECT_TRUE(sheet.contains(QStringLiteral("8px")));
}

TEST_F(LookTest, EveryIconIsDrawnInTheColourAsked) {
  const QStringList files = QDir(QStringLiteral(":/icons")).entryList();
  ASSERT_GE(files.size(), 20);
  const QColor ink = Look::current().colours().of(Role::text_2);
  for (const QString& file : files) {
    const QImage picture = icon(file.section(QLatin1Char('.'), 0, 0), 20, ink).toImage();
    ASSERT_EQ(picture.size(), QSize(20, 20));
    int drawn = 0, foreign = 0;
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x) {
        const QColor pixel = picture.pixelColor(x, y);
        if (pixel.alpha() < 200) continue;
        ++drawn;
        foreign += std::abs(pixel.red() - ink.red()) > 4 || std::abs(pixel.blue() - ink.blue()) > 4;
      }
    EXPECT_GT(drawn, 8) << file.toStdString();
    EXPECT_EQ(foreign, 0) << file.toStdString();
  }
  EXPECT_EQ(icon(QStringLiteral("check"), 20, ink, 2.0).toImage().width(), 40);
}

TEST_F(LookTest, HaloTextStandsUprightOnItsHaloAndIsTheSameFromTheCache) {
  const Colours& colours = Look::current().colours();
  const auto draw = [&](double turned) {
    QImage picture(120, 40, QImage::Format_RGB32);
    picture.fill(colours.of(Role::land));
    QPainter painter(&picture);
    painter.translate(20, 25);
    painter.rotate(turned);
    draw_halo_text(painter, {0, 0}, QStringLiteral("MDV-1"), font(13, true), Role::vehicle, colours);
    return picture;
  };
  const QImage first = draw(0), again = draw(0), turned = draw(77);
  EXPECT_EQ(first, again);
  EXPECT_EQ(first, turned);
  int halo = 0, ink = 0;
  for (int y = 0; y < first.height(); ++y)
    for (int x = 0; x < first.width(); ++x) {
      const QColor p = first.pixelColor(x, y);
      halo += p.lightness() > 240;
      ink += p == colours.of(Role::vehicle);
    }
  EXPECT_GT(halo, 60);
  EXPECT_GT(ink, 40);
}

TEST_F(LookTest, TheRingStandsTwoPixelsClearOfWhateverHasTheKeyboard) {
  QWidget window;
  window.resize(300, 160);
  auto* layout = new QVBoxLayout(&window);
  layout->setContentsMargins(20, 20, 20, 20);
  std::vector<QWidget*> widgets{new QPushButton(QStringLiteral("Press")),
                                new QCheckBox(QStringLiteral("Check")), new QLineEdit};
  for (QWidget* w : widgets) layout->addWidget(w);
  window.show();
  window.activateWindow();
  QApplication::processEvents();
  const QColor focus = Look::current().colours().of(Role::focus);
  for (QWidget* w : widgets) {
    w->setFocus();
    QApplication::processEvents();
    const QImage picture = window.grab().toImage();
    const QRect r = w->geometry();
    const int x = r.center().x(), y = r.center().y();
    for (const QPoint at : {QPoint(x, r.top() - 3), QPoint(x, r.bottom() + 3), QPoint(r.left() - 3, y),
                            QPoint(r.right() + 3, y)})
      EXPECT_EQ(picture.pixelColor(at).name(), focus.name())
          << w->metaObject()->className() << " " << at.x() << "," << at.y();
    EXPECT_NE(picture.pixelColor(x, r.top() - 1).name(), focus.name());
    EXPECT_NE(picture.pixelColor(x, r.top() - 5).name(), focus.name());
  }
  // It follows a widget that moves, and goes with one that hides.
  widgets[2]->setFixedHeight(60);
  QApplication::processEvents();
  QApplication::processEvents();
  const QRect r = widgets[2]->geometry();
  EXPECT_EQ(window.grab().toImage().pixelColor(r.center().x(), r.bottom() + 3).name(), focus.name());
}

TEST_F(LookTest, AChartIsRingedInsideItsEdge) {
  QWidget window;
  window.resize(200, 100);
  auto* chart = new QWidget(&window);
  chart->setGeometry(0, 0, 200, 100);
  chart->setFocusPolicy(Qt::StrongFocus);
  chart->setProperty(kRingInside, true);
  window.show();
  window.activateWindow();
  chart->setFocus();
  QApplication::processEvents();
  const QImage picture = window.grab().toImage();
  const QColor focus = Look::current().colours().of(Role::focus);
  EXPECT_EQ(picture.pixelColor(100, 0).name(), focus.name());
  EXPECT_EQ(picture.pixelColor(199, 50).name(), focus.name());
  EXPECT_NE(picture.pixelColor(100, 10).name(), focus.name());
}

TEST_F(LookTest, ACheckBoxIsOfThePalette) {
  Look::current().set(Palette::night);
  QCheckBox box(QStringLiteral("Graticule"));
  box.setChecked(true);
  box.resize(box.sizeHint());
  const QImage picture = box.grab().toImage();
  int brightest = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) brightest = std::max(brightest, qGray(picture.pixel(x, y)));
  EXPECT_LE(brightest, qGray(Colours(Palette::night).of(Role::text).rgb()) + 2);
}

}  // namespace
}  // namespace leadline::ui
