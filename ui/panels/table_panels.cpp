#include "ui/panels/table_panels.h"

#include "ui/widgets/paint_text.h"
#include "ui/widgets/table.h"

namespace leadline::ui {

TablePanel::TablePanel(const char* object_name, const QString& name, QWidget* table, QWidget* parent)
    : Panel(object_name, name, parent), table_(table) {
  table_->setParent(this);
}

QSize TablePanel::sizeHint() const {
  return {408, Panel::kTitle + (absent() ? kTableRow + 4 : table_->sizeHint().height()) + Panel::kPad};
}

void TablePanel::arrange(const std::string& fact, const std::string& why_absent) {
  set_heading({}, q(fact));
  set_absent(q(why_absent));
  table_->setVisible(!absent());
  table_->setGeometry(body());
  if (sizeHint().height() == height_) return;
  height_ = sizeHint().height();
  updateGeometry();
}

void TablePanel::resizeEvent(QResizeEvent* /*event*/) { table_->setGeometry(body()); }

SourcesPanel::SourcesPanel(QWidget* parent) : SourcesPanel(new SourcesTable, parent) {}

SourcesPanel::SourcesPanel(SourcesTable* table, QWidget* parent)
    : TablePanel("sourcesPanel", QStringLiteral("Sources"), table, parent), table_(table) {}

void SourcesPanel::set(const SourcesText& text) {
  table_->set(text.rows);
  arrange(text.fact, text.absent);
}

RangePanel::RangePanel(QWidget* parent) : RangePanel(new RangeBearingTable, parent) {}

RangePanel::RangePanel(RangeBearingTable* table, QWidget* parent)
    : TablePanel("rangePanel", QStringLiteral("Range and bearing"), table, parent), table_(table) {}

void RangePanel::set(const RangesText& text) {
  table_->set(text.rows);
  arrange(text.fact, text.absent);
}

}  // namespace leadline::ui
