#pragma once

// Every colour of the console, by what it is for. A widget asks for a role, never for a colour; a palette is
// one column of this table, and the only place of colours under ui/.

#include <array>
#include <cstddef>
#include <cstdint>

namespace leadline::ui {

enum class Role : std::uint8_t {
  bg_window,      ///< window, gaps between panels
  bg_panel,       ///< panels, bars, dialogs, menus
  bg_tile,        ///< value tiles, tables, edit fields
  bg_raised,      ///< buttons, tool tips, lamp in force
  line,           ///< hairlines, dividers
  line_strong,    ///< control borders, scales
  text,           ///< values, names, default button fill
  text_2,         ///< labels, units, ages
  text_off,       ///< disabled (exempt from AA)
  stale,          ///< value whose age passed the limit, 28 px bold only
  alarm,          ///< fill, with `alarm.on` text
  alarm_on,       ///< text on it
  alarm_mark,     ///< edges, values, MOB
  warning,        ///< fill
  warning_on,     ///< text on it
  warning_mark,   ///< edges
  caution,        ///< fill
  caution_on,     ///< text on it
  caution_mark,   ///< edges
  alarm_icon,     ///< triangle
  alarm_glyph,    ///< mark inside
  warning_icon,   ///< circle
  warning_glyph,  ///< mark inside
  caution_icon,   ///< square
  caution_glyph,  ///< mark inside
  normal,         ///< a check that passed; nowhere else
  replay,         ///< frame, tag, loop, watermark 17 %
  replay_on,      ///< text on it
  sim,            ///< simulated tag and edge
  select,         ///< selected row, tool in hand
  focus,          ///< keyboard focus ring
  sea_deep,       ///< chart, deep
  sea_mid,        ///< chart, between
  sea_shallow,    ///< chart, shallower than the safety depth
  land,           ///< land, seabed fill
  coast,          ///< coast line, seabed line
  contour,        ///< depth contours, at 40 %
  grid,           ///< graticule, at 38 %
  ink,            ///< chart text, contacts, marks, furniture
  halo,           ///< under every symbol and text, at 85 %
  ship,           ///< own ship
  vehicle,        ///< vehicle, its ellipse
  target,         ///< target, its ellipse
  fix,            ///< fix used
  fix_refused,    ///< fix refused, track before
  track_dr,       ///< dead reckoning, dashed
  track_fused,    ///< fused, solid
  track_smooth,   ///< smoothed, solid thin
  plan,           ///< plan, active leg, set-point bug
  beam,           ///< USBL line ship to vehicle
};

enum class Palette : std::uint8_t { day, dusk, night };

struct RoleColours {
  const char* name;                   ///< as the style sheet and the design page spell it
  std::array<std::uint32_t, 3> argb;  ///< day, dusk, night; opaque
};

inline constexpr std::array<RoleColours, 50> kRoles{{
    {"bg.window", {0xFFD3DAE0, 0xFF0D1217, 0xFF030404}},
    {"bg.panel", {0xFFE9EDF1, 0xFF151C23, 0xFF080A0A}},
    {"bg.tile", {0xFFFBFCFD, 0xFF1C252E, 0xFF0D1010}},
    {"bg.raised", {0xFFFFFFFF, 0xFF27333E, 0xFF141818}},
    {"line", {0xFFBFC8D0, 0xFF2D3944, 0xFF1B1F1F}},
    {"line.strong", {0xFF6A7783, 0xFF748593, 0xFF6E665A}},
    {"text", {0xFF0D1820, 0xFFDCE3E8, 0xFFA4937A}},
    {"text.2", {0xFF42515D, 0xFFA3B0BB, 0xFF8E806B}},
    {"text.off", {0xFF75828D, 0xFF697783, 0xFF5E5547}},
    {"stale", {0xFF7B8791, 0xFF7A8894, 0xFF6A6050}},
    {"alarm", {0xFFC1121F, 0xFFD92632, 0xFF520B12}},
    {"alarm.on", {0xFFFFFFFF, 0xFFFFFFFF, 0xFFBC8680}},
    {"alarm.mark", {0xFFC1121F, 0xFFFF5C66, 0xFFB8404A}},
    {"warning", {0xFFF28C1B, 0xFFF0942A, 0xFF3B2200}},
    {"warning.on", {0xFF14100A, 0xFF14100A, 0xFFC18A44}},
    {"warning.mark", {0xFFB85400, 0xFFF0942A, 0xFFB37628}},
    {"caution", {0xFFFFDD33, 0xFFF0D043, 0xFF2B2700}},
    {"caution.on", {0xFF14130A, 0xFF14130A, 0xFFA39540}},
    {"caution.mark", {0xFF7D6400, 0xFFF0D043, 0xFFA39530}},
    {"alarm.icon", {0xFFC1121F, 0xFFE8404A, 0xFFB8404A}},
    {"alarm.glyph", {0xFFFFFFFF, 0xFFFFFFFF, 0xFF0D1010}},
    {"warning.icon", {0xFFF28C1B, 0xFFF0942A, 0xFFB37628}},
    {"warning.glyph", {0xFF14100A, 0xFF14100A, 0xFF0D1010}},
    {"caution.icon", {0xFFFFDD33, 0xFFF0D043, 0xFFA39530}},
    {"caution.glyph", {0xFF14130A, 0xFF14130A, 0xFF0D1010}},
    {"normal", {0xFF17744A, 0xFF57C48C, 0xFF3E8A5F}},
    {"replay", {0xFF6B2FD0, 0xFFA98BF5, 0xFF8672BE}},
    {"replay.on", {0xFFFFFFFF, 0xFF120A24, 0xFF0A0710}},
    {"sim", {0xFF00707A, 0xFF45C4CC, 0xFF388D95}},
    {"select", {0xFFC5DAF3, 0xFF254764, 0xFF1A2226}},
    {"focus", {0xFF0057D9, 0xFF86C5FF, 0xFFAA8E60}},
    {"sea.deep", {0xFFCFE2EE, 0xFF10202D, 0xFF04070A}},
    {"sea.mid", {0xFFB3D3E8, 0xFF152C3E, 0xFF060B10}},
    {"sea.shallow", {0xFF8FBFDF, 0xFF1C4059, 0xFF0A141B}},
    {"land", {0xFFE5DABD, 0xFF37362C, 0xFF12110C}},
    {"coast", {0xFF7A6A45, 0xFF8C8668, 0xFF4A4536}},
    {"contour", {0xFF5C8AA8, 0xFF4E7D9C, 0xFF203440}},
    {"grid", {0xFF3F6178, 0xFF8FA9BC, 0xFF3B4850}},
    {"ink", {0xFF0B1A26, 0xFFE3EBF0, 0xFFA4937A}},
    {"halo", {0xFFFFFFFF, 0xFF060B10, 0xFF020303}},
    {"ship", {0xFFBA102E, 0xFFFF6E7C, 0xFFC45F69}},
    {"vehicle", {0xFF0A4FC0, 0xFF62B0FF, 0xFF4A84BE}},
    {"target", {0xFF066A36, 0xFF52D690, 0xFF43906A}},
    {"fix", {0xFF0A4FC0, 0xFF62B0FF, 0xFF4A84BE}},
    {"fix.refused", {0xFF7A3A0C, 0xFFE3A97C, 0xFF96714A}},
    {"track.dr", {0xFF3E454D, 0xFFC3CBD2, 0xFF8A7E6D}},
    {"track.fused", {0xFF0A4FC0, 0xFF62B0FF, 0xFF4A84BE}},
    {"track.smooth", {0xFF006B66, 0xFF41CFC6, 0xFF348A86}},
    {"plan", {0xFF9C0F8A, 0xFFF08FE4, 0xFFA86CA2}},
    {"beam", {0xFF3E5163, 0xFFA9B9C6, 0xFF6E695E}},
}};

[[nodiscard]] constexpr std::uint32_t argb(Role role, Palette palette) {
  return kRoles[static_cast<std::size_t>(role)].argb[static_cast<std::size_t>(palette)];
}

}  // namespace leadline::ui
