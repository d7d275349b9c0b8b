#include "ui/widgets/tile_strip.h"

#include <QPainter>

#include "ui/look/look.h"
#include "ui/widgets/value_tile.h"

namespace leadline::ui {
namespace {

constexpr int kGap = 4;

}  // namespace

TileStrip::TileStrip(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("tileStrip"));
  setAccessibleName(QStringLiteral("Own data"));
  setFixedHeight(56);
  const char* const names[]{"stripPosition", "stripHeading", "stripDepth", "stripAltitude"};
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    tiles_[i] = new ValueTile({}, this);
    tiles_[i]->setObjectName(QString::fromLatin1(names[i]));
  }
}

void TileStrip::set(const OwnDataText& text) {
  tiles_[0]->set(text.position);
  tiles_[1]->set(text.heading);
  tiles_[2]->set(text.depth);
  tiles_[3]->set(text.altitude);
}

void TileStrip::paintEvent(QPaintEvent* /*event*/) {
  QPainter(this).fillRect(rect(), Look::current().colours().of(Role::bg_window));
}

void TileStrip::resizeEvent(QResizeEvent* /*event*/) {
  const int position = width() * 27 / 100;
  const int other = (width() - position - 3 * kGap) / 3;
  tiles_[0]->setGeometry(0, 0, position, height());
  for (int i = 0; i < 3; ++i) {
    const int x = position + kGap + i * (other + kGap);
    tiles_[static_cast<std::size_t>(i + 1)]->setGeometry(x, 0, i == 2 ? width() - x : other, height());
  }
}

}  // namespace leadline::ui
