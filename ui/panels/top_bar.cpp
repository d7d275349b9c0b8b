#include "ui/panels/top_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "ui/look/icon.h"
#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/availability_boxes.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

constexpr int kPad = 17;
constexpr int kBoxes = 5 * 32 - 2;

int height_of(Fold fold) { return fold == Fold::wide ? 48 : fold == Fold::compact ? 44 : 40; }

QString word_of(Operation operation) {
  switch (operation) {
    case Operation::none:
      return {};
    case Operation::live:
      return QStringLiteral("LIVE");
    case Operation::replay:
      return QStringLiteral("REPLAY");
    case Operation::simulation:
      return QStringLiteral("SIMULATION");
    case Operation::calibration:
      return QStringLiteral("CALIBRATION");
  }
  return {};
}

}  // namespace

TopBar::TopBar(QWidget* parent) : QWidget(parent), boxes_(new AvailabilityBoxes(this)) {
  setObjectName(QStringLiteral("topBar"));
  setAccessibleName(QStringLiteral("Mode, dive, availability and time"));
  set_fold(Fold::wide);
}

void TopBar::set(const TopBarText& text) {
  if (text == text_) return;
  text_ = text;
  boxes_->set(text_.mode);
  setAccessibleDescription(QStringLiteral("%1, %2, availability %3 %4, %5")
                               .arg(word_of(text_.operation), q(text_.dive), q(text_.mode_words),
                                    q(text_.mode_since), q(text_.outputs)));
  place_boxes();
  update();
}

void TopBar::set_fold(Fold fold) {
  fold_ = fold;
  setFixedHeight(height_of(fold_));
  place_boxes();
  update();
}

QSize TopBar::sizeHint() const { return {800, height_of(fold_)}; }

TopBar::Places TopBar::places() const {
  const bool wide_word =
      text_.operation == Operation::simulation || text_.operation == Operation::calibration;
  const int mode_width = wide_word ? 132 : 94;
  Places at;
  at.mode = fold_ == Fold::small ? 0 : fold_ == Fold::compact ? 46 : 124;
  at.dive = at.mode + mode_width;
  at.availability = at.dive;
  if (fold_ == Fold::wide) at.availability += std::clamp(width() - 1480, 180, 320);
  if (fold_ == Fold::compact) at.availability += 190;
  const int words = fold_ == Fold::small ? 172 : 190;
  at.free = at.availability + kPad + (fold_ == Fold::wide ? 78 : 0) + kBoxes + 12 + words;
  at.clock = width() - 244;
  at.outputs = fold_ == Fold::small ? at.clock : at.clock - (fold_ == Fold::wide ? 256 : 232);
  at.free = std::min(at.free, at.outputs);
  return at;
}

void TopBar::place_boxes() {
  boxes_->setGeometry(places().availability + kPad + (fold_ == Fold::wide ? 78 : 0), (height() - 28) / 2,
                      kBoxes, 28);
}

void TopBar::resizeEvent(QResizeEvent* /*event*/) { place_boxes(); }

bool TopBar::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const Places at = places();
    const int x = help->x();
    QString words;
    if (x >= at.clock)
      words =
          (text_.operation == Operation::replay ? QStringLiteral("Recorded UTC ") : QStringLiteral("UTC ")) +
          q(text_.date) + QLatin1Char(' ') + q(text_.time);
    else if (x >= at.outputs)
      words = q(text_.outputs) + QLatin1Char('\n') + q(text_.outputs_2);
    else if (x >= at.availability && x < at.free)
      words = QStringLiteral("Availability of a position\n") + q(text_.mode_words) + QLatin1Char(' ') +
              q(text_.mode_since);
    else if (x < at.availability)
      words = q(text_.dive) + QLatin1Char('\n') + q(text_.file);
    QToolTip::showText(help->globalPos(), words, this);
    return true;
  }
  return QWidget::event(event);
}

void TopBar::paint_mode(QPainter& painter, const Places& at) const {
  const Colours& colours = Look::current().colours();
  const QFont strong = ui::font(15, true);
  const double y = base_line(height() / 2.0, strong);
  const QRect block(at.mode, 0, at.dive - at.mode, height() - 1);
  const double middle = QRectF(block).center().x();
  const QString word = word_of(text_.operation);
  const QRectF inner = QRectF(block).adjusted(6.5, 7.5, -6.5, -6.5);
  painter.setBrush(Qt::NoBrush);
  switch (text_.operation) {
    case Operation::live: {
      const double x = middle - text_width(word, strong) / 2 + 8;
      painter.setRenderHint(QPainter::Antialiasing);
      painter.setPen(Qt::NoPen);
      painter.setBrush(colours.of(Role::text));
      painter.drawEllipse(QPointF(x - 16, height() / 2.0), 5, 5);
      painter.setRenderHint(QPainter::Antialiasing, false);
      draw_text(painter, {x, y}, word, strong, colours.of(Role::text));
      return;
    }
    case Operation::none:
      return;
    case Operation::replay:
      painter.fillRect(block, colours.of(Role::replay));
      return draw_text_centred(painter, {middle, y}, word, strong, colours.of(Role::replay_on));
    case Operation::simulation: {
      QPen pen(colours.of(Role::sim), 1.0);
      pen.setDashPattern({4, 3});
      painter.setPen(pen);
      painter.drawRect(inner);
      return draw_text_centred(painter, {middle, y}, word, strong, colours.of(Role::sim));
    }
    case Operation::calibration:
      painter.setPen(QPen(colours.of(Role::text), 1.0));
      painter.drawRect(inner);
      return draw_text_centred(painter, {middle, y}, word, strong, colours.of(Role::text));
  }
}

void TopBar::paint_dive(QPainter& painter, const Places& at) const {
  if (at.availability == at.dive) return;
  const Colours& colours = Look::current().colours();
  const double x = at.dive + kPad, room = at.availability - x - 8, middle = height() / 2.0;
  const QFont strong = ui::font(13, true), small = ui::font(12);
  if (fold_ == Fold::compact)  // the dive's name folds away: the file says more
    return static_cast<void>(draw_text(painter, {x, base_line(middle, small)},
                                       elided(q(text_.file), small, room), small, colours.of(Role::text_2)));
  draw_text(painter, {x, middle - 4}, elided(q(text_.dive), strong, room), strong, colours.of(Role::text));
  draw_text(painter, {x, middle + 14}, elided(q(text_.file), small, room), small, colours.of(Role::text_2));
}

void TopBar::paint_availability(QPainter& painter, const Places& at) const {
  const Colours& colours = Look::current().colours();
  const QFont small = ui::font(12), strong = ui::font(13, true);
  double x = at.availability + kPad;
  const double middle = height() / 2.0;
  if (fold_ == Fold::wide) {
    draw_text(painter, {x, base_line(middle, small)}, QStringLiteral("Availability"), small,
              colours.of(Role::text_2));
    x += 78;
  }
  x += kBoxes + 12;
  const double room = at.free - x - 4;
  const QString words = text_.mode ? q(text_.mode_words) : QStringLiteral("not known yet");
  draw_text(painter, {x, middle - 4}, elided(words, strong, room), strong, colours.of(Role::text));
  draw_text(painter, {x, middle + 14}, elided(q(text_.mode_since), small, room), small,
            colours.of(Role::text_2));
}

void TopBar::paint_outputs(QPainter& painter, const Places& at) const {
  if (at.outputs == at.clock || text_.outputs.empty()) return;
  const Colours& colours = Look::current().colours();
  const QFont small = ui::font(12), strong = ui::font(13, true);
  const QRect block(at.outputs, 0, at.clock - at.outputs, height() - 1);
  Role ink = Role::text, second = Role::text_2;
  const double middle = height() / 2.0, centre = at.outputs + 28;
  if (text_.outputs_alert && *text_.outputs_alert != Alarm::Priority::caution) {
    painter.fillRect(block, colours.of(alert_roles(*text_.outputs_alert).fill));
    ink = second = alert_roles(*text_.outputs_alert).on;
    draw_alert_icon(painter, {centre, middle}, 20, *text_.outputs_alert, AlertMark::acknowledged, colours,
                    AlertGround::fill);
  } else {
    if (text_.outputs_alert) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(colours.of(Role::caution_mark), 2.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
      painter.drawRect(block.adjusted(6, 5, -6, -5));
    }
    const bool replay = text_.operation == Operation::replay;
    draw_icon(painter, {centre, middle}, replay ? QStringLiteral("lock") : QStringLiteral("recording"), 20,
              colours.of(Role::text));
  }
  const double x = at.outputs + 47, room = at.clock - x - 10;
  draw_text(painter, {x, middle - 4}, elided(q(text_.outputs), strong, room), strong, colours.of(ink));
  draw_text(painter, {x, middle + 14}, elided(q(text_.outputs_2), small, room), small, colours.of(second));
}

void TopBar::paint_clock(QPainter& painter, const Places& at) const {
  const Colours& colours = Look::current().colours();
  const QFont big = ui::font(22, true), small = ui::font(12);
  const double middle = height() / 2.0, right = width() - 14;
  const double widest = text_width(QStringLiteral("00:00:00 Z"), big);
  draw_text(painter, {right - widest, base_line(middle, big)}, q(text_.time), big, colours.of(Role::text));
  const double label = right - widest - 13, room = label - at.clock - 6;
  const QString utc =
      text_.operation == Operation::replay ? QStringLiteral("recorded UTC") : QStringLiteral("UTC");
  draw_text_right(painter, {label, middle - 4}, elided(utc, small, room), small, colours.of(Role::text_2));
  draw_text_right(painter, {label, middle + 14}, elided(q(text_.date), small, room), small,
                  colours.of(Role::text_2));
}

void TopBar::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  const Places at = places();
  QPainter painter(this);
  painter.fillRect(rect(), colours.of(Role::bg_panel));
  draw_rule(painter, {0, height() - 1}, {width() - 1, height() - 1}, colours.of(Role::line));
  if (at.mode > 0) {
    draw_icon(painter, {at.mode > 100 ? 26.0 : 23.0, height() / 2.0}, QStringLiteral("leadline"), 28,
              colours.of(Role::text));
    const QFont strong = ui::font(15, true);
    if (at.mode > 100)
      draw_text(painter, {46, base_line(height() / 2.0, strong)}, QStringLiteral("Leadline"), strong,
                colours.of(Role::text));
  }
  for (const int x : {at.mode, at.dive, at.availability, at.free, at.outputs, at.clock})
    if (x > 0) draw_rule(painter, {x, 0}, {x, height() - 2}, colours.of(Role::line));
  paint_mode(painter, at);
  paint_dive(painter, at);
  paint_availability(painter, at);
  paint_outputs(painter, at);
  paint_clock(painter, at);
}

}  // namespace leadline::ui
