#pragma once

#include <QPainter>
#include <QWidget>
#include <optional>

#include "core/messages/bookkeeping.h"
#include "core/messages/navigation.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// How much a state of availability asks for attention: A and B nothing, C and D caution, E1 warning, E0
/// alarm.
[[nodiscard]] std::optional<Alarm::Priority> attention(Mode mode);
/// "A" to "E"; E1 and E0 share a letter.
[[nodiscard]] QString letter(Mode mode);

/// Five boxes of 30 x 28, A to E, the one in force marked by outline or fill and icon.
class AvailabilityBoxes final : public QWidget {
  Q_OBJECT

 public:
  explicit AvailabilityBoxes(QWidget* parent = nullptr);

  void set(std::optional<Mode> mode);
  [[nodiscard]] QSize sizeHint() const override { return {5 * 32 - 2, 28}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<Mode> mode_;
};

}  // namespace leadline::ui
