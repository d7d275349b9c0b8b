#include "ui/panels/raw_view.h"

#include <QScrollBar>
#include <QTextBlock>

#include "ui/look/look.h"
#include "ui/models/figures.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

constexpr int kLongest = 400;  ///< characters of a line that are shown; the file has them all

QString shown(const RawLine& line) {
  const QString text = q(line.text);
  return text.size() <= kLongest ? text
                                 : QStringLiteral("%1… %2 bytes").arg(text.left(kLongest)).arg(line.bytes);
}

}  // namespace

RawView::RawView(QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName(QStringLiteral("rawView"));
  setReadOnly(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  setTabChangesFocus(true);
  setUndoRedoEnabled(false);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setFrameShape(QFrame::NoFrame);
  setFont(mono_font(12));
  document()->setDocumentMargin(4);
  setFocusPolicy(Qt::StrongFocus);
  connect(verticalScrollBar(), &QScrollBar::valueChanged, this, [this](int value) {
    if (!ours_) follow_ = value >= verticalScrollBar()->maximum();
  });
  connect(&Look::current(), &Look::lookChanged, this, &RawView::write);
}

void RawView::set(const std::vector<RawLine>& lines) {
  if (lines == lines_) return;
  lines_ = lines;
  write();
}

void RawView::resizeEvent(QResizeEvent* event) {
  ours_ = true;
  QPlainTextEdit::resizeEvent(event);
  if (follow_) scroll_to_end();
  ours_ = false;
}

void RawView::scroll_to_end() { verticalScrollBar()->setValue(verticalScrollBar()->maximum()); }

void RawView::write() {
  const Colours& colours = Look::current().colours();
  QTextCharFormat time, heard, refused;
  time.setForeground(colours.of(Role::text_2));
  heard.setForeground(colours.of(Role::text));
  refused.setForeground(colours.of(Role::warning_mark));
  QScrollBar* down = verticalScrollBar();
  const int at = down->value(), aside = horizontalScrollBar()->value();
  setUpdatesEnabled(false);
  ours_ = true;
  clear();
  QTextCursor cursor(document());
  cursor.beginEditBlock();
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const RawLine& line = lines_[i];
    if (i > 0) cursor.insertBlock();
    cursor.insertText(q(time_text(line.arrival.host(), 3).substr(0, 12)), time);
    if (line.refusal.empty())
      cursor.insertText(QStringLiteral("   ") + shown(line), heard);
    else
      cursor.insertText(QStringLiteral(" × %1 · %2").arg(q(line.refusal), shown(line)), refused);
  }
  cursor.endEditBlock();
  follow_ ? scroll_to_end() : down->setValue(at);
  ours_ = false;
  horizontalScrollBar()->setValue(aside);
  setUpdatesEnabled(true);
}

}  // namespace leadline::ui
