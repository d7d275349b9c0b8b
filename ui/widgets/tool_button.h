#pragma once

#include <QAbstractButton>
#include <QString>

namespace leadline::ui {

/// A tool of the rail: 40 x 40, icon 20. In hand (checked): `select` with a bar at its left.
class ToolButton final : public QAbstractButton {
  Q_OBJECT

 public:
  ToolButton(const char* name, const QString& icon, const QString& words, const QString& key,
             QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override { return {40, 40}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString icon_;
};

}  // namespace leadline::ui
