#pragma once

#include <QObject>
#include <QTimer>
#include <mutex>

#include "core/flow/engine.h"
#include "ui/bridge/history_builder.h"
#include "ui/bridge/snapshot_builder.h"

namespace leadline::ui {

/// The end of the Bus that the screen looks at: the newest state behind a lock, never a queue. take() is
/// called by the core thread, everything else by the GUI thread. However slow the screen is, it costs the
/// core a copy's time at most and no memory; what it shows is the newest.
class Bridge final : public QObject, public Sink {
  Q_OBJECT

 public:
  static constexpr int kDisplayMs = 50;  ///< 20 Hz

  explicit Bridge(const ConsoleSetup& setup, QObject* parent = nullptr);

  void take(const Envelope& envelope) override;

  /// The state at the last display tick; const references are good until the next one.
  [[nodiscard]] const Snapshot& snapshot() const { return snapshot_; }
  [[nodiscard]] const History& history() const { return history_; }
  void start() { timer_.start(); }
  void stop() { timer_.stop(); }

 public slots:
  /// Looks now; the timer does it at display rate.
  void look();

 signals:
  /// Emitted at display rate, when something has come since.
  void looked();

 private:
  QTimer timer_;
  Snapshot snapshot_;
  History history_;

  std::mutex mutex_;
  SnapshotBuilder builder_;         // guarded
  HistoryBuilder history_builder_;  // guarded
  bool fresh_ = false;              // guarded
};

}  // namespace leadline::ui
