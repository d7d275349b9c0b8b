// Every symbol and state on water, imagery and mosaic, in the three palettes; and without colour.

#include <gtest/gtest.h>

#include <QFontMetricsF>
#include <QImage>
#include <functional>

#include "tests/support/picture.h"
#include "tests/unit/ui/chart/drawn.h"
#include "tests/unit/ui/chart/grounds.h"
#include "ui/chart/ellipse.h"
#include "ui/chart/fix_marks.h"
#include "ui/chart/halo.h"
#include "ui/chart/motion_lines.h"
#include "ui/chart/symbols.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

using test::Ground;

constexpr SymbolLook kStale{SymbolState::stale, false}, kLost{SymbolState::lost, false},
    kSimulated{SymbolState::live, true};
const QSize kBand(1160, 232);

const char* palette_name(Palette palette) {
  return palette == Palette::day ? "day" : palette == Palette::dusk ? "dusk" : "night";
}

/// One band of the sheet, in two rows.
class Band {
 public:
  Band(QPainter& painter, const Colours& colours)
      : p_(painter), c_(colours), view_(test::at_deg(36.91, 129.905), {200, 200}, 1.0) {}

  void paint() {
    ship(0, 0, {}, "ship");
    hull(1, 0, {}, "true scale");
    vehicle(2, 0, {}, "vehicle");
    target(3.2, 0, {}, "target, σ");
    ship(4.4, 0, kStale, "stale");
    vehicle(5.6, 0, kStale, "stale, doubt grows");
    target(6.8, 0, kStale, "stale");
    ship(7.8, 0, kLost, "lost");
    vehicle(9.9, 0, kLost, "lost");
    target(12, 0, kLost, "lost");

    ship(0, 1, kSimulated, "simulated");
    vehicle(1, 1, kSimulated, "simulated");
    target(2, 1, kSimulated, "simulated");
    hull(3, 1, kStale, "stale");
    hull(4, 1, kLost, "lost");
    hull(5, 1, kSimulated, "simulated");
    place(6.3, 1, "fixes used");
    for (const QPointF at :
         {QPointF(-36, 12), QPointF(-20, 2), QPointF(-4, 7), QPointF(12, -8), QPointF(30, -9)})
      draw_fix_used(p_, at_ + at, c_);
    place(7.6, 1, "refused");
    draw_fix_used(p_, at_ + QPointF(22, 22), c_);
    draw_fix_refused(p_, at_ + QPointF(-8, -10), at_ + QPointF(22, 22), c_);
    place(9.3, 1, "USBL beam");
    draw_usbl_beam(p_, at_ + QPointF(-62, 26), at_ + QPointF(66, -26), QStringLiteral("USBL 3 s"), c_);
    place(11, 1, "selected");
    draw_target(p_, at_, {}, c_);
    draw_brackets(p_, at_, Role::ink, c_);
    place(12.2, 1, "alarm");
    draw_vehicle(p_, at_, 52.0, {}, c_);
    draw_brackets(p_, at_, Role::alarm_mark, c_);
  }

 private:
  void place(double column, int row, const char* caption) {
    at_ = {40.0 + 80.0 * column, row == 0 ? 66.0 : 168.0};
    const QString text = QString::fromUtf8(caption);
    const double width = QFontMetricsF(font(12)).horizontalAdvance(text);
    draw_halo_text(p_, {std::round(at_.x() - width / 2.0), at_.y() + 52.0}, text, font(12), Role::ink, c_);
  }
  void motion(double angle_deg, double tip_px, double heading_px, QPointF vector, Role role) {
    draw_course_vector(p_, {at_, at_ + vector}, role, c_);
    draw_heading_line(p_, heading_line(at_, angle_deg, tip_px, heading_px), role, c_);
  }
  void age(SymbolLook look, double doubt_px, Role role) {
    draw_doubt(p_, at_, doubt_px, look.state, role, c_);
    if (look.state == SymbolState::stale) draw_age(p_, at_, doubt_px, QStringLiteral("14 s"), c_);
    if (look.state == SymbolState::lost) draw_age(p_, at_, doubt_px, QStringLiteral("last 13:59:56 Z"), c_);
  }
  void ship(double column, int row, SymbolLook look, const char* caption) {
    place(column, row, caption);
    age(look, 26.0, Role::ship);
    if (look == SymbolLook{}) motion(20.0, kShipBow_px, 30.0, {28, -36}, Role::ship);
    draw_ship(p_, at_, 20.0, look, c_);
  }
  void hull(double column, int row, SymbolLook look, const char* caption) {
    place(column, row, caption);
    if (look == SymbolLook{}) motion(20.0, 27.0, 30.0, {}, Role::ship);
    draw_hull(p_, at_, 20.0, {54.0, 14.0, 27.0}, 1.0, look, c_);
  }
  void vehicle(double column, int row, SymbolLook look, const char* caption) {
    place(column, row, caption);
    age(look, 28.0, Role::vehicle);
    if (look == SymbolLook{}) motion(52.0, kVehicleTip_px, 26.0, {44, -20}, Role::vehicle);
    draw_vehicle(p_, at_, 52.0, look, c_);
  }
  void target(double column, int row, SymbolLook look, const char* caption) {
    place(column, row, caption);
    age(look, 24.0, Role::target);
    if (look == SymbolLook{}) {
      const QPointF origin = view_.to_screen(view_.centre());
      p_.save();
      p_.translate(at_ - origin);
      draw_sigma_ellipse(p_, view_, view_.centre(), {28.0, 17.0, Angle::deg(60.0)}, Role::target, c_);
      p_.restore();
    }
    draw_target(p_, at_, look, c_);
  }

  QPainter& p_;
  const Colours& c_;
  ChartView view_;
  QPointF at_;
};

QImage sheet(const Colours& colours) {
  QImage image(kBand.width(), kBand.height() * 4, QImage::Format_RGB32);
  QPainter painter(&image);
  for (const Ground kind : test::kGrounds) {
    painter.save();
    painter.translate(0, kBand.height() * static_cast<int>(kind));
    painter.drawImage(0, 0, test::ground(kind, kBand, colours));
    Band(painter, colours).paint();
    painter.restore();
  }
  return image;
}

// Before any test of the binary: texts are cached as they are first drawn.
class FontsFirst : public testing::Environment {
  void SetUp() override { Look::current(); }
};
const testing::Environment* const kFontsFirst = testing::AddGlobalTestEnvironment(new FontsFirst);

class SymbolSheet : public testing::TestWithParam<Palette> {};

TEST_P(SymbolSheet, LooksAsItDid) {
  const Colours colours(GetParam());
  const QImage image = sheet(colours);
  const std::string name = std::string("symbols_") + palette_name(GetParam());
  test::look_at(image, name);
  test::look_at(image.convertToFormat(QImage::Format_Grayscale8), name + "_grey");
  leadline::test::expect_picture(image, name);
}

// The ink of a symbol in a grey picture of its ground: its pixels, but for those as light as the halo.
using Mask = std::vector<double>;
Mask mask(const std::function<void(QPainter&, double)>& paint, double turned, Ground kind,
          const Colours& colours) {
  const QSize size(40, 40);
  const QImage plain = test::ground(kind, size, colours);
  QImage with = plain;
  QPainter painter(&with);
  painter.translate(20, 20);
  paint(painter, turned);
  painter.end();
  // In halves between the halo and the strongest ink, as an eye that knows neither palette would.
  int strongest = 0;
  std::vector<int> from_halo;
  const int halo = qGray(colours.of(Role::halo).rgb());
  for (int y = 0; y < size.height(); ++y) {
    for (int x = 0; x < size.width(); ++x) {
      const bool touched = with.pixel(x, y) != plain.pixel(x, y);
      from_halo.push_back(touched ? std::abs(qGray(with.pixel(x, y)) - halo) : 0);
      strongest = std::max(strongest, from_halo.back());
    }
  }
  Mask out;
  for (const int g : from_halo) out.push_back(2 * g > strongest ? 1.0 : 0.0);
  return out;
}

double correlation(const Mask& a, const Mask& b) {
  double mean_a = 0.0, mean_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i];
    mean_b += b[i];
  }
  mean_a /= static_cast<double>(a.size());
  mean_b /= static_cast<double>(b.size());
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

// On any ground and at any heading a grey print still says what is what: each symbol is most like itself on
// deep water, and clearly less like every other.
TEST_P(SymbolSheet, WithoutColourShapesTellBodiesAndFixesApart) {
  const Colours colours(GetParam());
  const std::vector<std::pair<const char*, std::function<void(QPainter&, double)>>> symbols{
      {"ship", [&](QPainter& p, double a) { draw_ship(p, {}, a, {}, colours); }},
      {"vehicle", [&](QPainter& p, double a) { draw_vehicle(p, {}, a, {}, colours); }},
      {"target", [&](QPainter& p, double) { draw_target(p, {}, {}, colours); }},
      {"fix used", [&](QPainter& p, double) { draw_fix_used(p, {}, colours); }},
      {"fix refused", [&](QPainter& p, double) { draw_fix_refused(p, {}, {}, colours); }}};
  // As each looks on deep water, at every heading.
  std::vector<std::vector<Mask>> known(symbols.size());
  for (std::size_t j = 0; j < symbols.size(); ++j)
    for (double a = 0.0; a < 360.0; a += 18.0)
      known[j].push_back(mask(symbols[j].second, a, Ground::deep, colours));
  double worst_same = 1.0, worst_other = 0.0, least_lead = 1.0;
  for (const Ground kind : test::kGrounds) {
    for (const double heading : {0.0, 72.0, 200.0, 308.0}) {
      for (std::size_t i = 0; i < symbols.size(); ++i) {
        const Mask seen = mask(symbols[i].second, heading, kind, colours);
        const double same = correlation(seen, mask(symbols[i].second, heading, Ground::deep, colours));
        double other = 0.0;
        for (std::size_t j = 0; j < symbols.size(); ++j) {
          if (j == i) continue;
          for (const Mask& turned : known[j]) other = std::max(other, correlation(seen, turned));
        }
        EXPECT_GT(same, 0.60) << symbols[i].first << " on ground " << static_cast<int>(kind);
        EXPECT_GT(same - other, 0.10) << symbols[i].first << " on ground " << static_cast<int>(kind);
        worst_same = std::min(worst_same, same);
        worst_other = std::max(worst_other, other);
        least_lead = std::min(least_lead, same - other);
      }
    }
  }
  RecordProperty("least_like_itself", std::to_string(worst_same));
  RecordProperty("most_like_another", std::to_string(worst_other));
  RecordProperty("least_lead", std::to_string(least_lead));
}

INSTANTIATE_TEST_SUITE_P(Palettes, SymbolSheet, testing::Values(Palette::day, Palette::dusk, Palette::night),
                         [](const auto& shown) { return std::string(palette_name(shown.param)); });

}  // namespace
}  // namespace leadline::ui
