#pragma once

#include <QPainter>
#include <cstdint>

#include "ui/look/colours.h"

namespace leadline::ui {

/// How old what a symbol stands for is: stale is half transparent, lost an outline in dashes.
enum class SymbolState : std::uint8_t { live, stale, lost };
/// Simulated is told on top of any state: dashed outline, halo inside.
struct SymbolLook {
  SymbolState state = SymbolState::live;
  bool simulated = false;
  bool operator==(const SymbolLook&) const = default;
};

/// A ship's outline: metres; the reference point lies `bow_m` behind the bow on the centre line.
struct Hull {
  double length_m = 0.0, beam_m = 0.0, bow_m = 0.0;
  bool operator==(const Hull&) const = default;
};

// px from the position to where the symbol ends ahead of it.
inline constexpr double kShipBow_px = 13.0;
inline constexpr double kVehicleTip_px = 14.0;
inline constexpr double kTargetEdge_px = 9.0;

/// Whether a ship is drawn as her outline: from 40 px of length and 6 px of beam, back below 34 px of length
/// (or 5 px of beam), so that a scale at the limit does not flicker.
[[nodiscard]] bool shows_true_scale(const Hull& hull, double metres_per_px, bool shown_before);

// Painting: at = the position on the screen; angle clockwise from the top of the screen, as
// ChartView::screen_angle_deg gives it. Rotation is exact.
void draw_ship(QPainter& painter, QPointF at, double angle_deg, SymbolLook look, const Colours& colours);
void draw_hull(QPainter& painter, QPointF at, double angle_deg, const Hull& hull, double metres_per_px,
               SymbolLook look, const Colours& colours);
void draw_vehicle(QPainter& painter, QPointF at, double angle_deg, SymbolLook look, const Colours& colours);
void draw_target(QPainter& painter, QPointF at, SymbolLook look, const Colours& colours);

/// Four corners, 32 x 32: `ink` round what is selected, an alert's `*_mark` round what it concerns.
void draw_brackets(QPainter& painter, QPointF at, Role role, const Colours& colours);

}  // namespace leadline::ui
