#pragma once

#include <QStringList>
#include <QWidget>

namespace leadline::ui {

/// One of a few words, side by side; the one in force is filled violet, as it is a control of the replay.
/// Arrow keys, Home and End move.
class Segmented final : public QWidget {
  Q_OBJECT

 public:
  Segmented(const char* name, const QString& words, const QStringList& options, QWidget* parent = nullptr);

  /// -1: none of them. Emits nothing.
  void set_current(int index);
  /// Closer together, where room is short.
  void set_close(bool close);
  [[nodiscard]] int current() const { return current_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void chosen(int index);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QRect segment(int index) const;
  void choose(int index);
  void name_current();

  QString words_;
  QStringList options_;
  int current_ = -1, pad_ = 11;
};

}  // namespace leadline::ui
