#pragma once

// What the tests of the console look at: a canvas or a window with a moment on it, as a picture.

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <thread>

#include "tests/ui/hand_made.h"
#include "ui/chart/chart_canvas.h"
#include "ui/look/look.h"
#include "ui/panels/console_window.h"

namespace leadline::test {

inline const Geodetic kEastSea{Angle::deg(36.91), Angle::deg(129.905)};

/// Paints until nothing is being loaded any more.
inline QImage picture_of(QWidget& widget, const ui::ChartCanvas& chart) {
  QImage picture;
  for (int i = 0; i < 2'000; ++i) {
    QApplication::processEvents();
    picture = widget.grab().toImage();
    if (chart.settled()) return picture;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ADD_FAILURE() << "the chart was not loaded within ten seconds";
  return picture;
}

/// The chart alone, the vehicle in the middle.
inline QImage chart_picture(const HandMade& made, QSize size, double metres_per_px, ui::Palette palette) {
  ui::Look::current().set(palette);
  ui::ChartCanvas chart;
  chart.resize(size);
  chart.set_history(&made.history);
  chart.set_metres_per_px(metres_per_px);
  chart.set_centre(made.snapshot.vehicle->solution.position);
  chart.set_snapshot(made.snapshot);
  return picture_of(chart, chart);
}

/// sRGB luminance, white = 1.
inline double luminance(QRgb c) {
  const auto linear = [](int byte) {
    const double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(qRed(c)) + 0.7152 * linear(qGreen(c)) + 0.0722 * linear(qBlue(c));
}

}  // namespace leadline::test
