#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace leadline::ui {

/// A widget with this dynamic property set to true is ringed inside its edge, as the chart is.
inline constexpr char kRingInside[] = "ringInside";

/// The ring around whatever has the keyboard: 2 px `focus`, 2 px clear of the widget. It lies above its
/// window's widgets and takes no events, so that no widget has to leave room for it.
class FocusRing final : public QObject {
  Q_OBJECT

 public:
  explicit FocusRing(QObject* parent);
  ~FocusRing() override;

  static constexpr int kReach = 4;  ///< px beyond the widget

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow(QWidget* widget);
  void unfollow();
  void place();

  QPointer<QWidget> widget_, ring_;
};

}  // namespace leadline::ui
