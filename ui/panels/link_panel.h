#pragma once

#include <QElapsedTimer>
#include <vector>

#include "core/types/result.h"
#include "ui/bridge/raw_tail.h"
#include "ui/models/link_rows.h"
#include "ui/widgets/panel.h"

namespace leadline::ui {

class Button;
class LinkTable;
class RawView;

/// LINKS: a row a link and, of the selected one, what it says: the raw monitor. Holding or emptying the text
/// touches nothing that is heard or recorded.
class LinkPanel final : public Panel {
  Q_OBJECT

 public:
  explicit LinkPanel(QWidget* parent = nullptr);

  /// Where raw text comes from; the caller's. nullptr before it goes.
  void set_tail(RawTail* tail);
  /// The rows at this moment; reads the text as well, if the panel is in sight.
  void set(const std::vector<LinkRow>& rows);

  /// The link whose text is shown; empty: none.
  [[nodiscard]] const std::string& selected() const { return selected_; }
  /// An address among the rows; another one is ignored.
  void select(const std::string& address);
  /// What is shown of the selected link, oldest first.
  [[nodiscard]] const std::vector<RawLine>& lines() const { return lines_; }
  /// Writes lines(), a line each: arrival, refusal, sender, text, with tabs between. What was there before is
  /// replaced as a whole or not at all.
  [[nodiscard]] Result<void> save(const QString& file) const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void hold(bool held);
  void clear();
  void ask_where_to_save();
  /// What is shown, newly read where the text is not held.
  void show_lines();
  void read_held();
  void name_subject();
  void place();
  [[nodiscard]] const LinkRow* row() const;
  [[nodiscard]] QRect note_place() const;

  RawTail* tail_ = nullptr;
  std::vector<LinkRow> rows_;
  std::string selected_;
  std::vector<RawLine> lines_, held_lines_;  // the latter with what was not refused too
  QElapsedTimer held_;                       ///< valid: since when the text stands still
  LinkTable* table_;
  Button *hold_, *clear_, *save_, *refused_only_;
  RawView* view_;
};

}  // namespace leadline::ui
