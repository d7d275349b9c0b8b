#pragma once

#include "ui/models/tile_text.h"
#include "ui/widgets/fold.h"
#include "ui/widgets/panel.h"

namespace leadline::ui {

class CompassRose;
class ValueTile;

/// Which rows the panel of one body has; their places stand whether their figures have come or not.
struct OwnDataRows {
  bool rose = true;            ///< beside heading and speed
  bool depth_altitude = true;  ///< Depth, Altitude
  bool attitude = true;        ///< Roll, Pitch, Current
};

/// VEHICLE or SHIP: the figures of one body.
class OwnDataPanel final : public Panel {
  Q_OBJECT

 public:
  enum class Kind : std::uint8_t { vehicle, ship };

  explicit OwnDataPanel(Kind kind, OwnDataRows rows = {}, QWidget* parent = nullptr);

  void set(const OwnDataText& text);
  void set_rows(OwnDataRows rows);
  void set_fold(Fold fold);  ///< folded: no rose
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Roll and pitch on one row, the current on the next.
  [[nodiscard]] bool narrow() const { return fold_ != Fold::wide; }
  [[nodiscard]] bool has_rose() const { return rows_.rose && fold_ == Fold::wide; }
  void place();

  OwnDataRows rows_;
  Fold fold_ = Fold::wide;
  ValueTile *position_, *heading_, *speed_, *depth_, *altitude_, *roll_, *pitch_, *current_;
  CompassRose* rose_;
};

}  // namespace leadline::ui
