#include "ui/panels/link_panel.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPainter>
#include <QSaveFile>
#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/look/look.h"
#include "ui/models/figures.h"
#include "ui/panels/raw_view.h"
#include "ui/widgets/button.h"
#include "ui/widgets/link_table.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/table.h"

namespace leadline::ui {
namespace {

constexpr int kButton = 28, kApart = 8;  // the focus ring reaches 4 px beyond either

}  // namespace

LinkPanel::LinkPanel(QWidget* parent)
    : Panel("linkPanel", QStringLiteral("Links"), parent),
      table_(new LinkTable(this)),
      hold_(new Button("holdText", QStringLiteral("pause"), QStringLiteral("Pause"),
                       QStringLiteral("Hold the text still; all is heard and recorded meanwhile  (Alt+P)"),
                       this)),
      clear_(new Button("clearText", QStringLiteral("cross"), QStringLiteral("Clear"),
                        QStringLiteral("Empty this text; what is recorded stays  (Alt+C)"), this)),
      save_(new Button("saveText", {}, QStringLiteral("Save…"),
                       QStringLiteral("Write this text to a file  (Alt+S)"), this)),
      refused_only_(new Button("refusedOnly", QStringLiteral("list"), QStringLiteral("Refused only"),
                               QStringLiteral("Show only what was refused, or all  (Alt+R)"), this)),
      view_(new RawView(this)) {
  hold_->setCheckable(true);
  refused_only_->setCheckable(true);
  hold_->setShortcut(QKeySequence("Alt+P"));
  clear_->setShortcut(QKeySequence("Alt+C"));
  save_->setShortcut(QKeySequence("Alt+S"));
  refused_only_->setShortcut(QKeySequence("Alt+R"));
  connect(table_, &LinkTable::chosen, this,
          [this](int row) { select(rows_[static_cast<std::size_t>(row)].address); });
  connect(hold_, &Button::toggled, this, &LinkPanel::hold);
  connect(clear_, &Button::clicked, this, &LinkPanel::clear);
  connect(save_, &Button::clicked, this, &LinkPanel::ask_where_to_save);
  connect(refused_only_, &Button::toggled, this, [this](bool only) {
    refused_only_->set_icon(only ? QStringLiteral("check") : QStringLiteral("list"));
    show_lines();
  });
  name_subject();
}

const LinkRow* LinkPanel::row() const {
  const auto found = std::ranges::find(rows_, selected_, &LinkRow::address);
  return found == rows_.end() ? nullptr : &*found;
}

void LinkPanel::set_tail(RawTail* tail) {
  tail_ = tail;
  read_held();
  show_lines();
}

void LinkPanel::set(const std::vector<LinkRow>& rows) {
  const bool grown = rows.size() != rows_.size();
  rows_ = rows;
  if (row() == nullptr) selected_ = rows_.empty() ? std::string() : rows_.front().address;
  table_->set(rows_);
  const LinkRow* shown = row();
  table_->select(shown == nullptr ? -1 : static_cast<int>(shown - rows_.data()));
  if (grown) place();
  name_subject();
  if (isVisible()) show_lines();
}

void LinkPanel::select(const std::string& address) {
  const std::string before = std::exchange(selected_, address);
  if (row() == nullptr) selected_ = before;
  if (selected_ == before) return;
  table_->select(static_cast<int>(row() - rows_.data()));
  name_subject();
  read_held();
  show_lines();
}

void LinkPanel::read_held() {
  const LinkRow* shown = row();
  held_lines_ =
      tail_ != nullptr && shown != nullptr ? tail_->lines(shown->sources, false) : std::vector<RawLine>();
}

void LinkPanel::show_lines() {
  const LinkRow* shown = row();
  const bool only = refused_only_->isChecked();
  lines_.clear();
  if (held_.isValid())
    std::ranges::copy_if(held_lines_, std::back_inserter(lines_),
                         [&](const RawLine& line) { return !only || !line.refusal.empty(); });
  else if (tail_ != nullptr && shown != nullptr)
    lines_ = tail_->lines(shown->sources, only);
  view_->setPlaceholderText(only ? QStringLiteral("nothing was refused")
                                 : QStringLiteral("nothing was heard"));
  view_->set(lines_);
}

void LinkPanel::hold(bool held) {
  held ? held_.start() : held_.invalidate();
  read_held();
  const QString words = held ? QStringLiteral("Resume") : QStringLiteral("Pause");
  hold_->setText(words);
  hold_->setAccessibleName(words);
  hold_->setShortcut(QKeySequence("Alt+P"));  // a button forgets its key with its words
  hold_->set_icon(held ? QStringLiteral("play") : QStringLiteral("pause"));
  name_subject();
  show_lines();
}

void LinkPanel::clear() {
  const LinkRow* shown = row();
  if (tail_ == nullptr || shown == nullptr) return;
  for (const SourceId source : shown->sources) tail_->clear(source);
  read_held();
  show_lines();
}

void LinkPanel::name_subject() {
  const LinkRow* shown = row();
  std::string fact = links_open(rows_);
  if (held_.isValid()) fact = "HELD " + age_text(std::chrono::milliseconds(held_.elapsed())) + " · " + fact;
  set_heading(shown == nullptr ? QString() : q(link_names(*shown) + " · " + shown->address), q(fact));
  view_->setAccessibleName(QStringLiteral("Raw text of ") +
                           (shown == nullptr ? QString() : q(link_names(*shown))));
  const QString trouble = shown == nullptr ? QString() : q(link_trouble(*shown));
  if (trouble == view_->accessibleDescription()) return;
  view_->setAccessibleDescription(trouble);
  update(note_place());
}

Result<void> LinkPanel::save(const QString& file) const {
  QSaveFile out(file);
  const auto failed = [&] {
    return Error{out.errorString().toStdString(), file.toStdString(),
                 "choose a folder that can be written, on a disk with room"};
  };
  if (!out.open(QIODevice::WriteOnly)) return failed();
  std::string text;
  for (const RawLine& line : lines_)
    text += iso8601(line.arrival.host(), 3) + '\t' + (line.refusal.empty() ? "" : "refused " + line.refusal) +
            '\t' + line.sender + '\t' + line.text + '\n';
  out.write(text.data(), static_cast<qint64>(text.size()));
  if (!out.commit()) return failed();
  return {};
}

void LinkPanel::ask_where_to_save() {
  const LinkRow* shown = row();
  QString name = shown == nullptr || shown->names.empty() ? QStringLiteral("link") : q(shown->names.front());
  name.replace('/', '-');
  const std::vector<RawLine> as_seen = lines_;  // while the dialog is open more is heard
  const QString file = QFileDialog::getSaveFileName(window(), QStringLiteral("Save raw text"),
                                                    QStringLiteral("raw-%1.txt").arg(name), {}, nullptr,
                                                    QFileDialog::DontUseNativeDialog);
  if (file.isEmpty()) return;
  lines_ = as_seen;
  const auto saved = save(file);
  show_lines();
  if (saved) return;
  QMessageBox box(QMessageBox::NoIcon, QStringLiteral("Save raw text"), q(saved.error().line()),
                  QMessageBox::Close, window());
  box.setObjectName(QStringLiteral("save_failed"));
  box.setTextFormat(Qt::PlainText);
  box.exec();
}

QSize LinkPanel::sizeHint() const { return {900, 380}; }

QSize LinkPanel::minimumSizeHint() const { return {640, 190}; }

void LinkPanel::resizeEvent(QResizeEvent* /*event*/) { place(); }

void LinkPanel::showEvent(QShowEvent* /*event*/) { show_lines(); }

void LinkPanel::place() {
  const QRect in = body();
  const int left = in.left(), w = in.width();
  // Whole rows, of less than half the room; the others are scrolled to.
  const int most = std::max(3, (in.height() - kButton - 2 * kApart) * 45 / 100 / kTableRow) * kTableRow;
  const int rows = std::min(table_->sizeHint().height(), most);
  table_->setGeometry(left, in.top(), w, rows);
  const int y = in.top() + rows + kApart;
  int x = left;
  for (Button* button : {hold_, clear_, save_, refused_only_}) {
    // "Resume" is the longer word of its button.
    const int width = button == hold_ ? 104 : button->sizeHint().width();
    button->setGeometry(x, y, width, kButton);
    x += width + kApart;
  }
  const int top = y + kButton + kApart;
  view_->setGeometry(left, top, w, std::max(0, in.bottom() + 1 - top));
}

QRect LinkPanel::note_place() const {
  const QRect buttons = refused_only_->geometry();
  const int left = buttons.right() + 1 + 2 * kApart;
  return {left, buttons.top(), body().right() - 5 - left, buttons.height()};
}

void LinkPanel::paintEvent(QPaintEvent* event) {
  Panel::paintEvent(event);
  const LinkRow* shown = row();
  if (shown == nullptr) return;
  QPainter painter(this);
  const QRect at = note_place();
  const QFont small = ui::font(12);
  draw_text(painter, {double(at.left()), base_line(at.top() + at.height() / 2.0, small)},
            elided(q(link_trouble(*shown)), small, at.width()), small,
            Look::current().colours().of(Role::text));
}

}  // namespace leadline::ui
