#pragma once

#include <QRect>
#include <vector>

#include "ui/bridge/snapshot.h"
#include "ui/chart/halo.h"
#include "ui/chart/track_path.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// What a track stands for decides its line; so does the legend.
enum class TrackKind : std::uint8_t { fused, dead_reckoning, ship, other };
[[nodiscard]] TrackKind track_kind(const Track& track);
[[nodiscard]] LineStyle track_line(TrackKind kind);
[[nodiscard]] TrackPens track_pens(TrackKind kind, const Colours& colours);

/// The tracks of a history on a chart's plane. What was projected once stays; it grows with the history. GUI
/// thread.
class TrackLayer {
 public:
  /// What has happened since settle(), for the picture that holds the tracks.
  enum class Change : std::uint8_t {
    none,
    grown,  ///< paint_added() brings the picture up to date
    anew    ///< another history or projection, or an earlier moment: paint everything
  };
  /// Shows what was valid at or before `now`. May be asked several times before the picture is painted.
  Change sync(const History& history, const maps::LocalProjection& projection, Time now);

  /// Tracks within `exposed`, as of the sync() before the last where that one found `grown`, so that
  /// paint_added() comes on top; screen coordinates.
  void paint(QPainter& painter, const ChartView& view, const QRect& exposed, const Colours& colours) const;
  /// Where paint_added() paints; empty without growth.
  [[nodiscard]] QRect added(const ChartView& view) const;
  void paint_added(QPainter& painter, const ChartView& view, const Colours& colours) const;
  /// The picture is up to date.
  void settle();

  /// The box of what is shown; empty when nothing is.
  [[nodiscard]] std::optional<maps::PlaneBox> extent() const;
  /// Of the tracks that show at least one line.
  [[nodiscard]] std::vector<TrackKind> kinds() const;

 private:
  struct Line {
    TrackKind kind = TrackKind::other;
    TrackPath path;
    std::size_t painted = 0, shown = 0;
  };

  const History* history_ = nullptr;
  std::optional<Geodetic> origin_;
  std::vector<Line> lines_;
  Change pending_ = Change::none;
};

}  // namespace leadline::ui
