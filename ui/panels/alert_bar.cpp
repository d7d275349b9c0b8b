#include "ui/panels/alert_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/button.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

constexpr int kCount = 46;  // of one priority: icon and number

bool fills_bar(Alarm::Priority priority) { return priority >= Alarm::Priority::alarm; }

}  // namespace

AlertBar::AlertBar(QWidget* parent)
    : QWidget(parent),
      acknowledge_(new Button("acknowledge", QStringLiteral("check"), QStringLiteral("Acknowledge"),
                              QStringLiteral("Acknowledge this alert, by name  (Ctrl+A)"), this)),
      silence_(new Button("silence", QStringLiteral("speaker-off"), QStringLiteral("Silence 30 s"),
                          QStringLiteral("Silence every alert for 30 s  (Ctrl+S)"), this)),
      all_(new Button("allAlerts", QStringLiteral("list"), QStringLiteral("All alerts"),
                      QStringLiteral("The list of all alerts  (Ctrl+L)"), this)) {
  setObjectName(QStringLiteral("alertBar"));
  setAccessibleName(QStringLiteral("No alerts"));
  acknowledge_->setEnabled(false);
  silence_->setEnabled(false);
  connect(acknowledge_, &Button::clicked, this, [this] { emit acknowledged(); });
  connect(silence_, &Button::clicked, this, [this] { emit silenced(); });
  connect(all_, &Button::clicked, this, [this] { emit allAlertsRequested(); });
  connect(&blink_, &QTimer::timeout, this, [this] {
    lit_ = !lit_;
    update(0, 0, lead_width(), height());
  });
  set_fold(Fold::wide);
}

void AlertBar::set(const AlertBarText& text) {
  if (text == text_) return;
  text_ = text;
  const auto& alert = text_.alert;
  const bool waits = alert && !text_.replay && alert->priority != Alarm::Priority::caution;
  acknowledge_->setEnabled(waits && alert->mark != AlertMark::acknowledged);
  silence_->setEnabled(waits && alert->mark == AlertMark::unacknowledged);
  const bool blinks = waits && alert->mark == AlertMark::unacknowledged && !frozen_;
  if (blinks)
    blink_.start(fills_bar(alert->priority) ? 500 : 1000);
  else
    blink_.stop();
  if (!blinks) lit_ = true;
  setAccessibleName(alert ? QStringLiteral("%1%2: %3, %4, %5")
                                .arg(text_.replay ? QStringLiteral("Recorded ") : QString(),
                                     QString::fromLatin1(alert_word(alert->priority)).toLower(),
                                     q(alert->text), q(alert->cause), q(alert->state))
                          : QStringLiteral("No alerts"));
  update();
}

void AlertBar::set_fold(Fold fold) {
  fold_ = fold;
  setFixedHeight(sizeHint().height());
  place();
  update();
}

void AlertBar::freeze() {
  frozen_ = true;
  blink_.stop();
  lit_ = true;
  update();
}

QSize AlertBar::sizeHint() const { return {800, fold_ == Fold::wide ? 40 : 36}; }

int AlertBar::lead_width() const { return fold_ == Fold::small ? 130 : 142; }

int AlertBar::counts_left() const { return all_->x() - 3 * kCount - 8; }

void AlertBar::place() {
  for (Button* button : {acknowledge_, silence_, all_})
    button->set_icon_only(fold_ == Fold::small || width() < 1100);
  const int y = (height() - 28) / 2;
  const int gap = fold_ == Fold::wide ? 12 : 8;
  int right = width() - 8;
  const auto put = [&](Button* button) {
    const int w = button->sizeHint().width();
    button->setGeometry(right - w, y, w, 28);
    right -= w + gap;
  };
  put(all_);
  right = counts_left() - gap;
  put(silence_);
  put(acknowledge_);
}

void AlertBar::resizeEvent(QResizeEvent* /*event*/) { place(); }

bool AlertBar::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && text_.alert) {
    const auto& alert = *text_.alert;
    QToolTip::showText(
        static_cast<QHelpEvent*>(event)->globalPos(),
        q(alert.text) + QLatin1Char('\n') + q(alert.cause) + QLatin1Char('\n') + q(alert.state), this);
    return true;
  }
  return QWidget::event(event);
}

void AlertBar::paint_message(QPainter& painter) const {
  const Colours& colours = Look::current().colours();
  const auto& alert = *text_.alert;
  const AlertRoles roles = alert_roles(alert.priority);
  const int lead = lead_width(), end = acknowledge_->x() - 10;
  const QRect block(0, 0, lead, height()), message(lead, 0, end - lead, height());
  const bool caution = alert.priority == Alarm::Priority::caution;
  const bool whole = fills_bar(alert.priority);
  if (whole) {
    painter.fillRect(QRect(0, 0, end, height()), colours.of(roles.fill));
  } else if (!caution) {
    painter.fillRect(message, colours.of(Role::bg_tile));
    painter.fillRect(QRect(lead, 0, message.width(), 2), colours.of(roles.mark));
    painter.fillRect(QRect(lead, height() - 2, message.width(), 2), colours.of(roles.mark));
  }
  // Unlit: the same block as an outline, in the ink that the ground then wants.
  const bool filled = lit_ && !caution;
  if (filled && !whole) painter.fillRect(block, colours.of(roles.fill));
  if (!lit_) {
    if (whole) painter.fillRect(block, colours.of(Role::bg_tile));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.of(roles.mark), 2.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.drawRect(block.adjusted(1, 1, -1, -1));
  }
  const QFont strong = ui::font(15, true), body = ui::font(13);
  const double y = height() / 2.0;
  const bool emergency = alert.priority == Alarm::Priority::emergency;
  draw_alert_icon(painter, {26, y}, 20, alert.priority, alert.mark, colours,
                  filled ? AlertGround::fill : AlertGround::panel);
  const QString word = QString::fromLatin1(alert_word(alert.priority));
  const QFont lead_font = emergency ? ui::font(13, true) : strong;
  draw_text(painter, {emergency ? 46.0 : 47.0, base_line(y, lead_font)}, word, lead_font,
            colours.of(filled ? roles.on : Role::text));
  if (whole && lit_) draw_rule(painter, {lead, 6}, {lead, height() - 7}, colours.of(roles.on));

  const QColor ink = colours.of(whole ? roles.on : Role::text);
  // What is wrong comes first, then when and in which state, then why.
  const double left = lead + 16, room = end - 18 - left;
  const QString words = (text_.replay ? QStringLiteral("Recorded: ") : QString()) + q(alert.text);
  const double words_end =
      draw_text(painter, {left, base_line(y, strong)}, elided(words, strong, room), strong, ink);
  const double state_room = end - 18 - words_end - 16;
  if (state_room < 90) return;
  const double state_left = draw_text_right(painter, {end - 18.0, base_line(y, body)},
                                            elided(q(alert.state), body, state_room), body, ink);
  const double cause_room = state_left - words_end - 30;
  if (fold_ == Fold::wide && cause_room > 60)
    draw_text(painter, {words_end + 14, base_line(y, body)}, elided(q(alert.cause), body, cause_room), body,
              ink);
}

void AlertBar::paint_counts(QPainter& painter) const {
  const Colours& colours = Look::current().colours();
  const QFont body = ui::font(13);
  const double y = height() / 2.0;
  int x = counts_left();
  for (const auto priority : {Alarm::Priority::alarm, Alarm::Priority::warning, Alarm::Priority::caution}) {
    const int count =
        text_.counts[static_cast<std::size_t>(Alarm::Priority::alarm) - static_cast<std::size_t>(priority)];
    draw_alert_icon(painter, {x + 9.0, y}, 15, priority, AlertMark::acknowledged, colours);
    const QString words = count > 99 ? QStringLiteral("99+") : QString::number(count);
    draw_text(painter, {x + 22.0, base_line(y, body)}, words, body, colours.of(Role::text));
    x += kCount;
  }
}

void AlertBar::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  painter.fillRect(rect(), colours.of(Role::bg_panel));
  draw_rule(painter, {0, height() - 1}, {width() - 1, height() - 1}, colours.of(Role::line));
  if (text_.alert) {
    paint_message(painter);
  } else {
    const QFont body = ui::font(13);
    draw_text(painter, {17, base_line(height() / 2.0, body)},
              text_.replay ? QStringLiteral("No alerts recorded at this time") : QStringLiteral("No alerts"),
              body, colours.of(Role::text_2));
  }
  paint_counts(painter);
}

}  // namespace leadline::ui
