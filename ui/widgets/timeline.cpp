#include "ui/widgets/timeline.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/availability_boxes.h"
#include "ui/widgets/clock_text.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/timeline_painter.h"

namespace leadline::ui {
namespace {

constexpr Duration kShortest = std::chrono::seconds(10);

}  // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("timeline"));
  setAccessibleName(QStringLiteral("Timeline"));
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize Timeline::sizeHint() const { return {400, kTimelineHeight}; }

void Timeline::set_data(const TimelineData& newer) {
  const bool whole = span_ == data_.run || span_ == TimeSpan{};
  data_ = newer;
  if (whole) span_ = data_.run;
  redraw();
}

void Timeline::set_now(Time now) {
  if (now == now_) return;
  now_ = now;
  setAccessibleDescription(clock_text(now_));
  update();
}

void Timeline::set_loop(std::optional<TimeSpan> loop) {
  if (loop == loop_) return;
  loop_ = loop;
  update();
}

void Timeline::set_span(TimeSpan span) {
  const Duration run = data_.run.until - data_.run.from;
  const Duration length = std::clamp(span.until - span.from, std::min(kShortest, run), run);
  const Time from = std::clamp(span.from, data_.run.from, data_.run.until - length);
  span_ = {from, from + length};
  redraw();
}

void Timeline::redraw() {
  still_ = QPixmap();
  update();
}

void Timeline::seek(Time time) {
  time = std::clamp(time, data_.run.from, std::max(data_.run.from, data_.run.until));
  set_now(time);
  emit sought(time);
}

QString Timeline::words_at(double x) const {
  const TimeScale scale(span_, rect());
  const Time t = scale.at(x);
  QStringList lines{clock_text(t)};
  for (const auto& part : data_.availability)
    if (part.span.contains(t)) lines << QStringLiteral("availability ") + letter(part.mode);
  for (const auto& gap : data_.gaps)
    if (gap.span.contains(t)) lines << QStringLiteral("gap: ") + q(gap.text);
  for (const auto& alert : data_.alerts)
    if (std::abs(scale.x(alert.at) - x) < 7)
      lines << QString::fromLatin1(alert_word(alert.priority)).toLower() + QStringLiteral(": ") +
                   q(alert.text);
  for (const auto& event : data_.events)
    if (std::abs(scale.x(event.at) - x) < 7) lines << q(event.text);
  while (lines.size() > 8) lines.removeLast();
  return lines.join(QLatin1Char('\n'));
}

bool Timeline::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), words_at(help->x()), this);
    return true;
  }
  return QWidget::event(event);
}

void Timeline::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  const double ratio = devicePixelRatioF();
  if (still_.isNull() || still_.size() != (QSizeF(size()) * ratio).toSize()) {
    still_ = QPixmap((QSizeF(size()) * ratio).toSize());
    still_.setDevicePixelRatio(ratio);
    QPainter painter(&still_);
    draw_timeline(painter, rect(), data_, span_, colours);
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, still_);
  if (loop_) draw_loop(painter, rect(), *loop_, span_, colours);
  draw_play_head(painter, rect(), scrubbed_.value_or(now_), span_, colours);
}

void Timeline::resizeEvent(QResizeEvent* /*event*/) { redraw(); }

void Timeline::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) redraw();
  QWidget::changeEvent(event);
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  scrubbed_ = TimeScale(span_, rect()).at(event->x());
  seek(*scrubbed_);
  update();
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (!scrubbed_) return;
  const Time to = TimeScale(span_, rect()).at(event->x());
  if (to == *scrubbed_) return;
  scrubbed_ = to;
  seek(to);
  update();
}

void Timeline::mouseReleaseEvent(QMouseEvent* /*event*/) {
  scrubbed_.reset();
  update();
}

void Timeline::wheelEvent(QWheelEvent* event) {
  if (event->angleDelta().y() == 0) return;
  const double factor = std::pow(0.8, event->angleDelta().y() / 120.0);
  const Time fixed = TimeScale(span_, rect()).at(event->position().x());
  const auto scaled = [&](Time t) { return fixed + duration(seconds(t - fixed) * factor); };
  set_span({scaled(span_.from), scaled(span_.until)});
  event->accept();
}

void Timeline::keyPressEvent(QKeyEvent* event) {
  using std::chrono::seconds;
  const Duration step = event->modifiers().testFlag(Qt::ControlModifier) ? Duration(seconds(60))
                        : event->modifiers().testFlag(Qt::ShiftModifier) ? Duration(seconds(10))
                                                                         : Duration(seconds(1));
  const Duration page = (span_.until - span_.from) / 10;
  switch (event->key()) {
    case Qt::Key_Left:
      return seek(now_ - step);
    case Qt::Key_Right:
      return seek(now_ + step);
    case Qt::Key_PageUp:
      return seek(now_ - page);
    case Qt::Key_PageDown:
      return seek(now_ + page);
    case Qt::Key_Home:
      return seek(span_.from);
    case Qt::Key_End:
      return seek(span_.until);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace leadline::ui
