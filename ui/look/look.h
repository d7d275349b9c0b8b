#pragma once

#include <QFont>
#include <QObject>

#include "ui/look/colours.h"

namespace leadline::ui {

/// The application's one look, as QApplication has one palette. GUI thread.
class Look final : public QObject {
  Q_OBJECT

 public:
  /// Registers fonts, style, palette and style sheet with the QApplication at the first call.
  static Look& current();

  [[nodiscard]] const Colours& colours() const { return colours_; }
  /// The whole application changes before its next paint. step: 0..4 of the dimmer (1, 0.7, 0.5, 0.35, 0.25).
  void set(Palette palette, int dimmer_step = 0);
  [[nodiscard]] int dimmer_step() const { return dimmer_step_; }

 signals:
  void lookChanged();

 private:
  Look();

  Colours colours_{Palette::day};
  int dimmer_step_ = 0;
};

/// B612 at a pixel size of the type scale (28 22 18 15 13 12 11); hinting off.
[[nodiscard]] QFont font(int px, bool bold = false);
/// B612 Mono, for telegrams and hex.
[[nodiscard]] QFont mono_font(int px);

}  // namespace leadline::ui
