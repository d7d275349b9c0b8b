#include "ui/look/focus_ring.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QEvent>
#include <QMenu>
#include <QPainter>

#include "ui/look/look.h"

namespace leadline::ui {
namespace {

class Ring final : public QWidget {
 public:
  explicit Ring(QWidget* window) : QWidget(window) {
    setObjectName(QStringLiteral("focusRing"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  void resizeEvent(QResizeEvent* /*event*/) override {
    // What it encloses is not covered: a chart below repaints without it.
    const int edge = 6;
    setMask(QRegion(rect()) - QRegion(rect().adjusted(edge, edge, -edge, -edge)));
  }
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Look::current().colours().of(Role::focus), 2.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  }
};

/// The window's part in which the widget can be seen.
QRect visible_part(const QWidget& widget) {
  QRect part = widget.window()->rect();
  for (const QWidget* parent = widget.parentWidget(); parent && !parent->isWindow();
       parent = parent->parentWidget())
    if (qobject_cast<const QAbstractScrollArea*>(parent->parentWidget()))
      part &= QRect(parent->mapTo(widget.window(), QPoint()), parent->size());
  return part;
}

}  // namespace

FocusRing::FocusRing(QObject* parent) : QObject(parent) {
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* /*old*/, QWidget* now) { follow(now); });
}

FocusRing::~FocusRing() { delete ring_; }

bool FocusRing::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest:
    case QEvent::ParentChange:
    case QEvent::ZOrderChange:
      // After it has happened: the children of a layout move later.
      QMetaObject::invokeMethod(
          this, [this] { place(); }, Qt::QueuedConnection);
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void FocusRing::unfollow() {
  for (QWidget* w = widget_; w; w = w->isWindow() ? nullptr : w->parentWidget()) w->removeEventFilter(this);
  delete ring_;
  widget_ = nullptr;
}

void FocusRing::follow(QWidget* widget) {
  unfollow();
  if (!widget || widget->isWindow() || qobject_cast<QMenu*>(widget->window())) return;
  widget_ = widget;
  ring_ = new Ring(widget->window());
  for (QWidget* w = widget_; w; w = w->isWindow() ? nullptr : w->parentWidget()) w->installEventFilter(this);
  place();
}

void FocusRing::place() {
  if (!widget_ || !ring_) return;
  if (!widget_->isVisible()) return ring_->hide();
  const QRect own(widget_->mapTo(widget_->window(), QPoint()), widget_->size());
  const bool inside = widget_->property(kRingInside).toBool();
  const QRect around = inside ? own : own.adjusted(-kReach, -kReach, kReach, kReach);
  ring_->setGeometry(around & visible_part(*widget_));
  ring_->show();
  ring_->raise();
}

}  // namespace leadline::ui
