#include "ui/panels/table_panels.h"

#include "ui/widgets/paint_text.h"
#include "ui/widgets/table.h"

namespace leadline::ui {
namespace {

// A panel without its subject keeps the room of one row, for its reason.
int height_of(const Panel& panel, const QWidget& table) {
  return Panel::kTitle + (panel.absent() ? kTableRow + 4 : table.sizeHint().height()) + Panel::kPad;
}

}  // namespace

SourcesPanel::SourcesPanel(QWidget* parent)
    : Panel("sourcesPanel", QStringLiteral("Sources"), parent), table_(new SourcesTable(this)) {}

void SourcesPanel::set(const SourcesText& text) {
  const int before = sizeHint().height();
  set_heading({}, q(text.fact));
  set_absent(q(text.absent));
  table_->set(text.rows);
  table_->setVisible(!absent());
  table_->setGeometry(body());
  if (sizeHint().height() != before) updateGeometry();
}

QSize SourcesPanel::sizeHint() const { return {408, height_of(*this, *table_)}; }

void SourcesPanel::resizeEvent(QResizeEvent* /*event*/) { table_->setGeometry(body()); }

RangePanel::RangePanel(QWidget* parent)
    : Panel("rangePanel", QStringLiteral("Range and bearing"), parent), table_(new RangeBearingTable(this)) {}

void RangePanel::set(const RangesText& text) {
  const int before = sizeHint().height();
  set_heading({}, q(text.fact));
  set_absent(q(text.absent));
  table_->set(text.rows);
  table_->setVisible(!absent());
  table_->setGeometry(body());
  if (sizeHint().height() != before) updateGeometry();
}

QSize RangePanel::sizeHint() const { return {408, height_of(*this, *table_)}; }

void RangePanel::resizeEvent(QResizeEvent* /*event*/) { table_->setGeometry(body()); }

}  // namespace leadline::ui
