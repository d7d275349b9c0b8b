#include "ui/widgets/availability_boxes.h"

#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {

std::optional<Alarm::Priority> attention(Mode mode) {
  switch (mode) {
    case Mode::A:
    case Mode::B:
      return std::nullopt;
    case Mode::C:
    case Mode::D:
      return Alarm::Priority::caution;
    case Mode::E1:
      return Alarm::Priority::warning;
    case Mode::E0:
      break;
  }
  return Alarm::Priority::alarm;
}

QString letter(Mode mode) {
  switch (mode) {
    case Mode::A:
      return QStringLiteral("A");
    case Mode::B:
      return QStringLiteral("B");
    case Mode::C:
      return QStringLiteral("C");
    case Mode::D:
      return QStringLiteral("D");
    case Mode::E1:
    case Mode::E0:
      break;
  }
  return QStringLiteral("E");
}

AvailabilityBoxes::AvailabilityBoxes(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("availability"));
  setAccessibleName(QStringLiteral("Availability not known"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void AvailabilityBoxes::set(std::optional<Mode> mode) {
  if (mode == mode_) return;
  mode_ = mode;
  setAccessibleName(mode ? QStringLiteral("Availability ") + letter(*mode)
                         : QStringLiteral("Availability not known"));
  update();
}

void AvailabilityBoxes::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  painter.setBrush(Qt::NoBrush);
  for (int i = 0; i < 5; ++i) {
    const QRect box(i * 32, 0, 30, 28);
    const QString name(QChar('A' + i));
    if (!mode_ || letter(*mode_) != name) {
      painter.fillRect(box, colours.of(Role::bg_tile));
      painter.setPen(colours.of(Role::line));
      painter.drawRect(box.adjusted(0, 0, -1, -1));
      const QFont plain = ui::font(13);
      draw_text_centred(painter, {QRectF(box).center().x(), base_line(14, plain)}, name, plain,
                        colours.of(Role::text_off));
      continue;
    }
    QFont strong = ui::font(15, true);
    strong.setPixelSize(16);
    const auto priority = attention(*mode_);
    double x = QRectF(box).center().x();
    if (!priority) {
      painter.fillRect(box, colours.of(Role::bg_raised));
      painter.setPen(QPen(colours.of(Role::text), 2.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
      painter.drawRect(box.adjusted(1, 1, -1, -1));
    } else {
      painter.fillRect(box, colours.of(alert_roles(*priority).fill));
      draw_alert_icon(painter, {box.left() + 22.0, 14}, 10, *priority, AlertMark::acknowledged, colours,
                      AlertGround::fill);
      x -= 6;
    }
    draw_text_centred(painter, {x, base_line(14, strong)}, name, strong,
                      colours.of(priority ? alert_roles(*priority).on : Role::text));
  }
}

}  // namespace leadline::ui
