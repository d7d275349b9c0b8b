#pragma once

#include <QAbstractButton>
#include <QString>

namespace leadline::ui {

/// Push button of 28 px, with an icon of ours or without.
class Button final : public QAbstractButton {
  Q_OBJECT

 public:
  enum class Kind : std::uint8_t { plain, primary };

  /// name: the object name; tip names the key.
  Button(const char* name, const QString& icon, const QString& text, const QString& tip,
         QWidget* parent = nullptr, Kind kind = Kind::plain);

  void set_icon(const QString& icon);
  [[nodiscard]] const QString& icon_name() const { return icon_; }
  /// Without its words, where room is short; the accessible name and the tool tip keep them.
  void set_icon_only(bool icon_only);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString icon_;
  Kind kind_;
  bool icon_only_ = false;
};

}  // namespace leadline::ui
