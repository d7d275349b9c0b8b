#pragma once

#include <QWidget>
#include <optional>

#include "ui/models/timeline_data.h"
#include "ui/widgets/fold.h"

namespace leadline::ui {

class Button;
class Segmented;
class Timeline;

/// The controls of a replay over its timeline, 132 px. It holds no clock: it is told the time and says what
/// the operator wants.
class ReplayBar final : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayBar(QWidget* parent = nullptr);

  void set_data(const TimelineData& newer);
  void set_now(Time now);
  void set_playing(bool playing);
  /// One of kSpeeds; infinity is "max". Anything else marks none.
  void set_speed(double speed);
  void set_loop(std::optional<TimeSpan> loop);
  void set_fold(Fold fold);
  [[nodiscard]] QSize sizeHint() const override { return {800, 132}; }

  /// A, then B, then no loop.
  void step_loop();
  /// To the next (+1) or previous (-1) event.
  void seek_event(int direction);

 signals:
  void playToggled();
  void stepped(int direction);                 ///< -1, +1
  void speedChosen(double speed);              ///< infinity: as fast as possible
  void sought(Time time);                      ///< by the timeline or to an event
  void loopSet(std::optional<TimeSpan> loop);  ///< whole, or gone

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();

  TimelineData data_;
  Time now_;
  bool playing_ = false;
  std::optional<TimeSpan> loop_;  ///< until == from: only A is set
  Fold fold_ = Fold::wide;
  Button *back_, *play_, *forward_, *loop_button_, *previous_, *next_;
  Segmented* speeds_;
  Timeline* timeline_;
};

}  // namespace leadline::ui
