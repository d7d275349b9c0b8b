// The contrast tables of the design, computed from the role table (WCAG 2.1).

#include <gtest/gtest.h>

#include <QColor>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/look/colours.h"

namespace leadline::ui {
namespace {

constexpr std::array<Palette, 3> kPalettes{Palette::day, Palette::dusk, Palette::night};
const char* name(Role role) { return kRoles[static_cast<std::size_t>(role)].name; }

double luminance(const QColor& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double ya = luminance(a), yb = luminance(b);
  return (std::max(ya, yb) + 0.05) / (std::min(ya, yb) + 0.05);
}

struct Row {
  Role mark, ground;
  double floor;
  std::array<double, 3> printed;
};

TEST(Contrast, OfTextsAndMarksIsWhatTheTableSays) {
  using R = Role;
  const Row rows[]{
      {R::text, R::bg_window, 4.5, {12.7, 14.5, 6.9}},
      {R::text, R::bg_panel, 4.5, {15.3, 13.3, 6.6}},
      {R::text, R::bg_tile, 4.5, {17.5, 12.0, 6.4}},
      {R::text, R::bg_raised, 4.5, {18.0, 9.9, 6.0}},
      {R::text_2, R::bg_window, 4.5, {5.8, 8.5, 5.3}},
      {R::text_2, R::bg_panel, 4.5, {7.0, 7.8, 5.2}},
      {R::text_2, R::bg_tile, 4.5, {8.0, 7.0, 5.0}},
      {R::text, R::select, 4.5, {12.6, 7.5, 5.4}},
      {R::stale, R::bg_tile, 3.0, {3.6, 4.3, 3.1}},
      {R::text_off, R::bg_panel, 2.5, {3.3, 3.7, 2.7}},
      {R::line_strong, R::bg_panel, 3.0, {3.9, 4.5, 3.5}},
      {R::alarm_on, R::alarm, 4.5, {6.2, 4.9, 4.8}},
      {R::warning_on, R::warning, 4.5, {7.7, 8.1, 4.9}},
      {R::caution_on, R::caution, 4.5, {13.9, 12.2, 5.0}},
      {R::replay_on, R::replay, 4.5, {7.1, 7.0, 4.9}},
      {R::alarm_mark, R::bg_tile, 3.0, {6.1, 5.2, 3.5}},
      {R::warning_mark, R::bg_tile, 3.0, {4.7, 6.6, 5.0}},
      {R::caution_mark, R::bg_tile, 3.0, {5.5, 10.2, 6.3}},
      {R::normal, R::bg_tile, 4.5, {5.6, 7.2, 4.6}},
      {R::alarm_glyph, R::alarm_icon, 3.0, {6.2, 4.0, 3.5}},
      {R::warning_glyph, R::warning_icon, 3.0, {7.7, 8.1, 5.0}},
      {R::caution_glyph, R::caution_icon, 3.0, {13.9, 12.2, 6.3}},
      {R::replay, R::bg_tile, 3.0, {6.9, 5.7, 4.7}},
      {R::sim, R::bg_tile, 4.5, {5.7, 7.4, 4.9}},
      {R::focus, R::bg_panel, 3.0, {5.3, 9.4, 6.4}},
      {R::focus, R::bg_tile, 3.0, {6.1, 8.5, 6.1}},
  };
  for (const Row& row : rows)
    for (std::size_t p = 0; p < kPalettes.size(); ++p) {
      const Colours colours(kPalettes[p]);
      const double got = contrast(colours.of(row.mark), colours.of(row.ground));
      EXPECT_GE(got, row.floor) << name(row.mark) << " on " << name(row.ground) << ", palette " << p;
      EXPECT_NEAR(got, row.printed[p], 0.06)
          << name(row.mark) << " on " << name(row.ground) << ", palette " << p;
    }
}

struct SymbolRow {
  Role symbol;
  std::array<std::array<double, 3>, 3> printed;  // deep, shallow, land of day, dusk, night
};

TEST(Contrast, OfChartSymbolsOnWaterAndLandIsWhatTheTableSays) {
  using R = Role;
  const SymbolRow rows[]{
      {R::ink, {{{13.2, 9.0, 12.7}, {13.7, 9.0, 10.1}, {6.8, 6.2, 6.3}}}},
      {R::ship, {{{4.9, 3.3, 4.7}, {6.1, 4.0, 4.5}, {5.0, 4.6, 4.7}}}},
      {R::vehicle, {{{5.5, 3.7, 5.2}, {7.2, 4.8, 5.3}, {5.1, 4.7, 4.8}}}},
      {R::target, {{{5.0, 3.4, 4.8}, {9.0, 5.9, 6.6}, {5.2, 4.8, 4.9}}}},
      {R::fix_refused, {{{6.5, 4.4, 6.2}, {8.1, 5.3, 5.9}, {4.6, 4.2, 4.3}}}},
      {R::track_dr, {{{7.3, 4.9, 7.0}, {10.1, 6.6, 7.4}, {5.1, 4.7, 4.8}}}},
      {R::track_smooth, {{{4.8, 3.2, 4.6}, {8.7, 5.7, 6.4}, {4.9, 4.5, 4.6}}}},
      {R::plan, {{{5.5, 3.8, 5.3}, {7.7, 5.1, 5.6}, {5.1, 4.7, 4.8}}}},
      {R::beam, {{{6.2, 4.2, 5.9}, {8.2, 5.4, 6.0}, {3.7, 3.4, 3.5}}}},
  };
  const Role grounds[]{R::sea_deep, R::sea_shallow, R::land};
  for (const auto& row : rows)
    for (std::size_t p = 0; p < kPalettes.size(); ++p)
      for (std::size_t g = 0; g < 3; ++g) {
        const Colours colours(kPalettes[p]);
        const double got = contrast(colours.of(row.symbol), colours.of(grounds[g]));
        EXPECT_GE(got, 3.0) << name(row.symbol) << " on " << name(grounds[g]) << ", palette " << p;
        EXPECT_NEAR(got, row.printed[p][g], 0.06)
            << name(row.symbol) << " on " << name(grounds[g]) << ", palette " << p;
      }
}

// Over a raster a symbol is read against its halo: 85 % of it over black, or over white after the tone curve.
TEST(Contrast, OfChartSymbolsToTheirHaloHoldsOverAnyRaster) {
  using R = Role;
  for (const Palette palette : kPalettes) {
    const Colours colours(palette);
    const QColor halo = colours.of(R::halo);
    for (const Tone& tone : {base_tone(colours), data_tone(colours)})
      for (const double byte : {0.0, 255.0}) {
        const auto over = [&](double h, double tint) {
          return std::clamp(0.85 * h + 0.15 * std::min(1.0, byte / 255.0 * tone.gain * tint), 0.0, 1.0);
        };
        const QColor ground =
            QColor::fromRgbF(over(halo.redF(), tone.tint[0]), over(halo.greenF(), tone.tint[1]),
                             over(halo.blueF(), tone.tint[2]));
        for (const R symbol : {R::ink, R::ship, R::vehicle, R::target, R::fix_refused, R::track_dr,
                               R::track_smooth, R::plan, R::beam})
          EXPECT_GE(contrast(colours.of(symbol), ground), 3.0)
              << name(symbol) << ", palette " << static_cast<int>(palette) << ", byte " << byte;
      }
  }
}

TEST(NightLimits, NoRoleIsBrighterThanTheDarkAdaptedEyeAllows) {
  const Colours night(Palette::night);
  for (std::size_t i = 0; i < kRoles.size(); ++i)
    EXPECT_LE(luminance(night.of(static_cast<Role>(i))), 0.305) << kRoles[i].name;
}

// The limit is 0.82 to two decimals: `ink` has 0.8204.
TEST(DuskLimits, NothingButAlarmTextIsAboveItsLimit) {
  const Colours dusk(Palette::dusk);
  for (std::size_t i = 0; i < kRoles.size(); ++i) {
    const auto role = static_cast<Role>(i);
    if (role == Role::alarm_on || role == Role::alarm_glyph) continue;
    EXPECT_LE(luminance(dusk.of(role)), 0.825) << kRoles[i].name;
  }
}

TEST(Dimmer, DimsLightLinearlyAndStopsAlertsAtOneHalf) {
  const Colours full(Palette::night), dim(Palette::night, 0.25);
  const double text = luminance(dim.of(Role::text)) / luminance(full.of(Role::text));
  const double alarm = luminance(dim.of(Role::alarm_mark)) / luminance(full.of(Role::alarm_mark));
  EXPECT_NEAR(text, 0.25, 0.01);
  EXPECT_NEAR(alarm, 0.50, 0.01);
}

TEST(Dimmer, DimsRastersAsMuchAsText) {
  const Tone full = base_tone(Colours(Palette::day)), dim = base_tone(Colours(Palette::day, 0.25));
  const auto grey = [](double gain) { return QColor::fromRgbF(0.8 * gain, 0.8 * gain, 0.8 * gain); };
  EXPECT_NEAR(luminance(grey(dim.gain)) / luminance(grey(full.gain)), 0.25, 0.02);
}

TEST(Tones, AreThoseOfThePalettes) {
  EXPECT_EQ(base_tone(Colours(Palette::day)), Tone{});
  EXPECT_EQ(base_tone(Colours(Palette::night)), (Tone{0.17, 0.55, {0.92, 1.0, 1.06}}));
  EXPECT_EQ(data_tone(Colours(Palette::dusk)), (Tone{0.66, 0.92, {1, 1, 1}}));
}

}  // namespace
}  // namespace leadline::ui
