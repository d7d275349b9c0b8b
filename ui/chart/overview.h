#pragma once

#include <QPixmap>

#include "ui/chart/background.h"

namespace leadline::ui {

/// Where on the coast this is: a small map with a cross hair and its own scale bar, as close as still shows
/// some land. Kept as a picture until the place, the look or the loaded coast line change.
class Overview {
 public:
  static constexpr QSize kSize{220, 156};
  void paint(QPainter& painter, QPoint top_left, const Background& background, Geodetic centre,
             const Colours& colours);
  void forget() { picture_ = {}; }

 private:
  QPixmap picture_;
  Geodetic centre_;
  std::optional<Colours> colours_;
};

}  // namespace leadline::ui
