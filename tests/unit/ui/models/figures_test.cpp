#include "ui/models/figures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace leadline::ui {
namespace {

TEST(Figures, MinusIsTheTrueMinusAndZeroHasNone) {
  EXPECT_EQ(number_text(-1.64, 1), "\u22121.6");
  EXPECT_EQ(number_text(-0.04, 1), "0.0");
  EXPECT_EQ(number_text(1512.44, 1), "1512.4");
  EXPECT_EQ(number_text(0.999, 2), "1.00");
  EXPECT_EQ(signed_text(0.8, 1), "+0.8");
  EXPECT_EQ(signed_text(-0.01, 1), "+0.0");
  EXPECT_EQ(signed_text(-1.6, 1), "\u22121.6");
}

TEST(Figures, WhatIsUnknownIsThreeStrokesAndNeverZero) {
  EXPECT_EQ(number_text(std::nan(""), 1), "\u2212 \u2212 \u2212");
  EXPECT_EQ(signed_text(INFINITY, 1), kUnknown);
  EXPECT_EQ(heading_text(Angle::rad(std::nan(""))), kUnknown);
  EXPECT_EQ(sigma_text(std::nan("")), kUnknown);
  EXPECT_EQ(rate_text(std::nan("")), kUnknown);
  EXPECT_EQ(distance_text(INFINITY), kUnknown);
  EXPECT_EQ(latency_text(std::nan("")), kUnknown);
  EXPECT_EQ(position_text({Angle::rad(std::nan("")), {}}).first, kUnknown);
}

TEST(Figures, ADecimalBelowATenthOfSigmaIsNotShown) {
  EXPECT_EQ(decimals_for(0.3, 1), 1);
  EXPECT_EQ(decimals_for(1.0, 2), 1);
  EXPECT_EQ(decimals_for(1.1, 2), 0);
  EXPECT_EQ(decimals_for(0.1, 2), 2);
  EXPECT_EQ(decimals_for(0.01, 2), 2);
  EXPECT_EQ(decimals_for(40.0, 1), 0);
  EXPECT_EQ(decimals_for({}, 2), 2);
  EXPECT_EQ(decimals_for(0.0, 1), 1);
}

TEST(Figures, SigmaHasOneFigureBelowOneAndNoDecimalFromTen) {
  EXPECT_EQ(sigma_text(0.3), "0.3");
  EXPECT_EQ(sigma_text(0.012), "0.01");
  EXPECT_EQ(sigma_text(0.0994), "0.1");
  EXPECT_EQ(sigma_text(0.0021), "0.002");
  EXPECT_EQ(sigma_text(0.0001), "<0.001");
  EXPECT_EQ(sigma_text(2.34), "2.3");
  EXPECT_EQ(sigma_text(9.96), "10");
  EXPECT_EQ(sigma_text(23.4), "23");
}

TEST(Figures, HeadingsHaveThreeDigitsAndComeRound) {
  EXPECT_EQ(heading_text(Angle::deg(71.9)), "071.9");
  EXPECT_EQ(heading_text(Angle::deg(0.0)), "000.0");
  EXPECT_EQ(heading_text(Angle::deg(359.96)), "000.0");
  EXPECT_EQ(heading_text(Angle::deg(359.94)), "359.9");
  EXPECT_EQ(heading_text(Angle::deg(-10.0)), "350.0");
  EXPECT_EQ(heading_text(Angle::deg(359.6), 0), "000");
  EXPECT_EQ(heading_text(Angle::deg(7.4), 0), "007");
}

TEST(Figures, AgesAreCutAndChangeTheirFormWithSize) {
  const auto text = [](double s) { return age_text(duration(s)); };
  EXPECT_EQ(text(0.2), "0.2 s");
  EXPECT_EQ(text(0.29), "0.2 s");
  EXPECT_EQ(text(9.99), "9.9 s");
  EXPECT_EQ(text(14.9), "14 s");
  EXPECT_EQ(text(59.99), "59 s");
  EXPECT_EQ(text(60.0), "1:00");
  EXPECT_EQ(text(161.0), "2:41");
  EXPECT_EQ(text(3600.0), "1:00:00");
  EXPECT_EQ(text(93'784.0), "26:03:04");
  EXPECT_EQ(text(-0.3), "0.0 s") << "a device a little ahead of us";
}

TEST(Figures, TimesAreCutToWhatIsShown) {
  const Time t = *parse_iso8601("2026-09-14T14:02:37.987Z");
  EXPECT_EQ(time_text(t), "14:02:37 Z");
  EXPECT_EQ(time_text(t, 1), "14:02:37.9 Z");
  EXPECT_EQ(date_text(t), "2026-09-14");
}

TEST(Figures, RatesLatenciesDistancesAndScales) {
  EXPECT_EQ(rate_text(0.125), "0.125 Hz");
  EXPECT_EQ(rate_text(5.0), "5.0 Hz");
  EXPECT_EQ(rate_text(9.96), "10 Hz");
  EXPECT_EQ(rate_text(50.2), "50 Hz");
  EXPECT_EQ(rate_text(0.9999), "1.0 Hz");
  EXPECT_EQ(latency_text(0.041), "41 ms");
  EXPECT_EQ(latency_text(1.1), "1.1 s");
  EXPECT_EQ(latency_text(-0.3), "\u2212300 ms");
  EXPECT_EQ(latency_text(161.0), "2:41");
  EXPECT_EQ(latency_text(0.9999), "1.0 s");
  EXPECT_EQ(latency_text(-7200.0), "\u22122:00:00");
  EXPECT_EQ(latency_text(1e12), "years");
  EXPECT_EQ(distance_text(420.3), "420 m");
  EXPECT_EQ(distance_text(9'999.4), "9999 m");
  EXPECT_EQ(distance_text(9'999.6), "10.0 km");
  EXPECT_EQ(distance_text(12'345.0), "12.3 km");
  EXPECT_EQ(scale_text(4000.0), "1 : 4 000");
  EXPECT_EQ(scale_text(500.0), "1 : 500");
  EXPECT_EQ(scale_text(1.24e6), "1 : 1 200 000") << "two figures count";
}

}  // namespace
}  // namespace leadline::ui
