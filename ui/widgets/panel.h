#pragma once

#include <QString>
#include <QWidget>

namespace leadline::ui {

/// The frame of a panel: title row 26 (NAME, subject, at the right one fact), 6 px of padding, a body. A
/// panel whose subject is absent stays in place and says why.
class Panel : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kTitle = 26, kPad = 6, kGap = 4;

  /// name: in words; drawn in capitals, and the accessible name.
  Panel(const char* object_name, const QString& name, QWidget* parent = nullptr);

  void set_heading(const QString& subject, const QString& fact);
  /// Empty: the subject is there.
  void set_absent(const QString& why);
  [[nodiscard]] bool absent() const { return !absent_.isEmpty(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  [[nodiscard]] QRect body() const;

 private:
  QString name_, subject_, fact_, absent_;
};

}  // namespace leadline::ui
