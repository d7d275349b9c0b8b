#include "ui/panels/own_data_panel.h"

#include "ui/widgets/compass_rose.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/value_tile.h"

namespace leadline::ui {
namespace {

constexpr int kRoseWidth = 158, kHeadingHeight = 66,
              kRoseHeight = kHeadingHeight + Panel::kGap + kNoteTileHeight;

ValueTile* tile(const QString& prefix, const char* name, int px, QWidget* parent) {
  auto* made = new ValueTile({px, false}, parent);
  made->setObjectName(prefix + QString::fromLatin1(name));
  return made;
}

}  // namespace

OwnDataPanel::OwnDataPanel(Kind kind, OwnDataRows rows, QWidget* parent)
    : Panel(kind == Kind::vehicle ? "vehiclePanel" : "shipPanel",
            kind == Kind::vehicle ? QStringLiteral("Vehicle") : QStringLiteral("Ship"), parent),
      rows_(rows) {
  const QString prefix = kind == Kind::vehicle ? QStringLiteral("vehicle") : QStringLiteral("ship");
  position_ = tile(prefix, "Position", 28, this);
  heading_ = tile(prefix, "Heading", 28, this);
  speed_ = tile(prefix, "Speed", 28, this);
  depth_ = tile(prefix, "Depth", 28, this);
  altitude_ = tile(prefix, "Altitude", 28, this);
  roll_ = tile(prefix, "Roll", 18, this);
  pitch_ = tile(prefix, "Pitch", 18, this);
  current_ = tile(prefix, "Current", 18, this);
  rose_ = new CompassRose(kind == Kind::vehicle ? Role::vehicle : Role::ship, this);
  rose_->setObjectName(prefix + QStringLiteral("Rose"));
  place();
}

void OwnDataPanel::set(const OwnDataText& text) {
  set_heading(q(text.subject), q(text.fact));
  set_absent(q(text.absent));
  const auto show = [&](ValueTile* t, const std::optional<TileText>& figure) {
    t->set(absent() ? std::nullopt : figure);
  };
  show(position_, text.position);
  show(heading_, text.heading);
  show(speed_, text.speed);
  show(depth_, text.depth);
  show(altitude_, text.altitude);
  show(roll_, text.roll);
  show(pitch_, text.pitch);
  show(current_, text.current);
  rose_->set(absent() ? std::nullopt : text.rose);
}

void OwnDataPanel::set_rows(OwnDataRows rows) {
  rows_ = rows;
  place();
  updateGeometry();
}

void OwnDataPanel::set_fold(Fold fold) {
  fold_ = fold;
  place();
  updateGeometry();
}

QSize OwnDataPanel::sizeHint() const {
  int height = kTitle + kPositionTileHeight + kGap + (has_rose() ? kRoseHeight : kNoteTileHeight) + kPad;
  if (rows_.depth_altitude) height += kGap + kTileHeight;
  if (rows_.attitude) height += (kGap + kSmallTileHeight) * (narrow() ? 2 : 1);
  return {408, height};
}

QSize OwnDataPanel::minimumSizeHint() const { return {320, sizeHint().height()}; }

void OwnDataPanel::resizeEvent(QResizeEvent* /*event*/) { place(); }

void OwnDataPanel::place() {
  const QRect in = body();
  int y = in.top();
  const int left = in.left(), w = in.width(), half = (w - kGap) / 2;
  position_->setGeometry(left, y, w, kPositionTileHeight);
  y += kPositionTileHeight + kGap;
  rose_->setVisible(has_rose());
  if (has_rose()) {
    rose_->setGeometry(left, y, kRoseWidth, kRoseHeight);
    const int x = left + kRoseWidth + kGap;
    heading_->setGeometry(x, y, left + w - x, kHeadingHeight);
    speed_->setGeometry(x, y + kHeadingHeight + kGap, left + w - x, kNoteTileHeight);
    y += kRoseHeight + kGap;
  } else {
    heading_->setGeometry(left, y, half, kNoteTileHeight);
    speed_->setGeometry(left + half + kGap, y, w - half - kGap, kNoteTileHeight);
    y += kNoteTileHeight + kGap;
  }
  for (ValueTile* t : {depth_, altitude_}) t->setVisible(rows_.depth_altitude);
  if (rows_.depth_altitude) {
    // A depth has more digits than an altitude.
    const int depth = narrow() ? w * 53 / 100 : half;
    depth_->setGeometry(left, y, depth, kTileHeight);
    altitude_->setGeometry(left + depth + kGap, y, w - depth - kGap, kTileHeight);
    y += kTileHeight + kGap;
  }
  for (ValueTile* t : {roll_, pitch_, current_}) t->setVisible(rows_.attitude);
  if (rows_.attitude) {
    const int angle = narrow() ? half : (w - 2 * kGap) * 3 / 10;
    roll_->setGeometry(left, y, angle, kSmallTileHeight);
    pitch_->setGeometry(left + angle + kGap, y, angle, kSmallTileHeight);
    if (narrow()) y += kSmallTileHeight + kGap;
    const int x = narrow() ? left : left + 2 * (angle + kGap);
    current_->setGeometry(x, y, left + w - x, kSmallTileHeight);
  }
}

}  // namespace leadline::ui
