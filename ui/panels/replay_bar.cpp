#include "ui/panels/replay_bar.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <limits>

#include "ui/look/look.h"
#include "ui/widgets/button.h"
#include "ui/widgets/clock_text.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/timeline.h"

namespace leadline::ui {
namespace {

constexpr std::array<double, 6> kSpeeds{0.25, 1, 4, 20, 60, std::numeric_limits<double>::infinity()};
constexpr int kRow = 7, kButton = 28, kTimelineTop = 40;

QStringList speed_words() {
  return {QStringLiteral("0.25×"), QStringLiteral("1×"),  QStringLiteral("4×"),
          QStringLiteral("20×"),   QStringLiteral("60×"), QStringLiteral("max")};
}

}  // namespace

ReplayBar::ReplayBar(QWidget* parent)
    : QWidget(parent),
      back_(new Button("stepBack", QStringLiteral("step-back"), {}, QStringLiteral("One step back  (Left)"),
                       this)),
      play_(new Button("play", QStringLiteral("play"), {}, QStringLiteral("Play, pause  (Space)"), this,
                       Button::Kind::primary)),
      forward_(new Button("stepForward", QStringLiteral("step-forward"), {},
                          QStringLiteral("One step forward  (Right)"), this)),
      loop_button_(new Button("loop", {}, QStringLiteral("A–B loop"),
                              QStringLiteral("Set A here, then B, then end the loop  (L)"), this)),
      previous_(new Button("previousEvent", QStringLiteral("event-back"), QStringLiteral("Previous event"),
                           QStringLiteral("To the event or alert before  (Ctrl+Left)"), this)),
      next_(new Button("nextEvent", QStringLiteral("event-forward"), QStringLiteral("Next event"),
                       QStringLiteral("To the event or alert after  (Ctrl+Right)"), this)),
      speeds_(new Segmented("speed", QStringLiteral("Speed"), speed_words(), this)),
      timeline_(new Timeline(this)) {
  setObjectName(QStringLiteral("replayBar"));
  setAccessibleName(QStringLiteral("Replay"));
  setFixedHeight(132);
  back_->setAccessibleName(QStringLiteral("One step back"));
  play_->setAccessibleName(QStringLiteral("Play"));
  forward_->setAccessibleName(QStringLiteral("One step forward"));
  connect(back_, &Button::clicked, this, [this] { emit stepped(-1); });
  connect(forward_, &Button::clicked, this, [this] { emit stepped(+1); });
  connect(play_, &Button::clicked, this, [this] { emit playToggled(); });
  connect(speeds_, &Segmented::chosen, this,
          [this](int index) { emit speedChosen(kSpeeds[static_cast<std::size_t>(index)]); });
  connect(timeline_, &Timeline::sought, this, [this](Time t) {
    set_now(t);
    emit sought(t);
  });
  connect(loop_button_, &Button::clicked, this, [this] { step_loop(); });
  connect(previous_, &Button::clicked, this, [this] { seek_event(-1); });
  connect(next_, &Button::clicked, this, [this] { seek_event(+1); });
  // Reading order.
  QWidget* before = back_;
  for (QWidget* after :
       std::initializer_list<QWidget*>{play_, forward_, speeds_, loop_button_, previous_, next_, timeline_}) {
    setTabOrder(before, after);
    before = after;
  }
}

void ReplayBar::set_data(const TimelineData& newer) {
  data_ = newer;
  timeline_->set_data(newer);
  update();
}

void ReplayBar::set_now(Time now) {
  if (now == now_) return;
  now_ = now;
  timeline_->set_now(now);
  update(0, 0, width(), kTimelineTop);
}

void ReplayBar::set_playing(bool playing) {
  if (playing == playing_) return;
  playing_ = playing;
  play_->set_icon(playing ? QStringLiteral("pause") : QStringLiteral("play"));
  play_->setAccessibleName(playing ? QStringLiteral("Pause") : QStringLiteral("Play"));
}

void ReplayBar::set_speed(double speed) {
  const auto found = std::find(kSpeeds.begin(), kSpeeds.end(), speed);
  speeds_->set_current(found == kSpeeds.end() ? -1 : static_cast<int>(found - kSpeeds.begin()));
}

void ReplayBar::set_loop(std::optional<TimeSpan> loop) {
  loop_ = loop;
  timeline_->set_loop(loop);
  update(0, 0, width(), kTimelineTop);
}

void ReplayBar::set_fold(Fold fold) {
  fold_ = fold;
  place();
  update();
}

void ReplayBar::step_loop() {
  const bool begun = loop_ && loop_->until <= loop_->from;
  if (!loop_) return set_loop(TimeSpan{now_, now_});
  if (begun && now_ != loop_->from)
    set_loop(TimeSpan{std::min(loop_->from, now_), std::max(loop_->from, now_)});
  else
    set_loop(std::nullopt);
  emit loopSet(loop_);
}

void ReplayBar::seek_event(int direction) {
  std::optional<Time> best;
  const auto consider = [&](Time t) {
    const bool beyond = direction > 0 ? now_ < t : t < now_;
    if (beyond && (!best || (direction > 0 ? t < *best : *best < t))) best = t;
  };
  for (const auto& event : data_.events) consider(event.at);
  for (const auto& alert : data_.alerts) consider(alert.at);
  if (!best) return;
  set_now(*best);
  emit sought(*best);
}

void ReplayBar::resizeEvent(QResizeEvent* /*event*/) { place(); }

void ReplayBar::place() {
  for (Button* button : {previous_, next_}) button->set_icon_only(width() < 1100);
  speeds_->set_close(width() < 850);
  int x = 15;
  for (Button* button : {back_, play_, forward_}) {
    button->setGeometry(x, kRow, 34, kButton);
    x += 34 + 9;
  }
  speeds_->setGeometry(x + 7, kRow, speeds_->sizeHint().width(), kButton);
  int right = width() - 14;
  for (Button* button : {next_, previous_, loop_button_}) {
    const int w = button->sizeHint().width();
    button->setGeometry(right - w, kRow, w, kButton);
    right -= w + 9;
  }
  timeline_->setGeometry(0, kTimelineTop, width(), height() - kTimelineTop);
}

void ReplayBar::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  painter.fillRect(rect(), colours.of(Role::bg_panel));
  draw_rule(painter, {0, 0}, {width() - 1, 0}, colours.of(Role::line));
  const double middle = kRow + kButton / 2.0;
  const double limit = loop_button_->x() - 10;
  double x = speeds_->geometry().right() + 15;
  const QFont big = ui::font(22, true), body = ui::font(13), small = ui::font(12);
  draw_text(painter, {x, base_line(middle, big)}, clock_text(now_, 1), big, colours.of(Role::text));
  x += text_width(QStringLiteral("00:00:00.0 Z"), big) + 8;
  const QString elapsed = duration_words(now_ - data_.run.from) + QStringLiteral(" of ") +
                          duration_words(data_.run.until - data_.run.from);
  const double elapsed_end = x + text_width(QStringLiteral("00 h 00 min of 00 h 00 min"), body);
  if (elapsed_end <= limit)
    draw_text(painter, {x, base_line(middle, body)}, elapsed, body, colours.of(Role::text_2));
  if (!loop_) return;
  const QString clock_a = clock_text(loop_->from).chopped(2);
  const QString words = loop_->from < loop_->until
                            ? QStringLiteral("loop %1 to %2").arg(clock_a, clock_text(loop_->until))
                            : QStringLiteral("loop from %1 Z, set B").arg(clock_a);
  if (text_width(words, small) <= limit - elapsed_end)
    draw_text_right(painter, {limit, base_line(middle, small)}, words, small, colours.of(Role::text_2));
}

}  // namespace leadline::ui
