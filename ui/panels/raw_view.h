#pragma once

#include <QPlainTextEdit>
#include <vector>

#include "ui/bridge/raw_tail.h"

namespace leadline::ui {

/// Raw text in lines, the newest at the foot: arrival to the millisecond, a cross and the reason where it was
/// refused, the text as it came. Long lines end with how long they are. It follows the newest as long as its
/// end is in sight; text can be selected and copied. Never markup.
class RawView final : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit RawView(QWidget* parent = nullptr);

  void set(const std::vector<RawLine>& lines);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void write();
  void scroll_to_end();

  std::vector<RawLine> lines_;
  bool follow_ = true;  ///< the end is in sight
  bool ours_ = false;   ///< it is not the operator who scrolls
};

}  // namespace leadline::ui
