#include "ui/widgets/tile_painter.h"

#include <QFontMetricsF>
#include <cmath>
#include <vector>

#include "ui/look/icon.h"
#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

constexpr double kPad = 10, kSignSlot = 0.65;
const QString kUnknown = QStringLiteral("− − −");

/// Base lines from the top of the tile.
struct Lines {
  double label = 17, value = 46, second = 0, note = 0;  // 0: there is none
  int px = 28;
};

Lines lines_of(int height, const TileText& text, int value_px) {
  if (!text.value_2.empty() && text.state != ValueState::lost)
    return height >= 78 ? Lines{17, 44, 71, 0, 22} : Lines{13, 32, 50, 0, 18};
  const bool noted = !text.note.empty() || text.state == ValueState::pending;
  if (noted && height >= 78) return {17, 47, 0, 65, value_px};
  if (noted && height >= 54) return {std::min(17.0, height - 44.0), height - 26.0, 0, height - 9.0, 18};
  if (value_px > 18 && height >= 54)
    return {height >= 60 ? 17.0 : 15.0, std::min(height - 15.0, 47.0), 0, 0, value_px};
  return {16, 38, 0, 0, 18};
}

/// What stands at the top right, in pieces from left to right.
struct Piece {
  enum class Kind : std::uint8_t { text, aged, icon, tag, outlined_tag, dashed_tag, alert_tag };
  Kind kind = Kind::text;
  QString text;
  QFont font;
  Role role = Role::text_2;
  Role fill = Role::bg_tile;
  double gap = 0;  // before it
};

double width_of(const Piece& piece) {
  switch (piece.kind) {
    case Piece::Kind::icon:
      return piece.gap + 14;
    case Piece::Kind::alert_tag:
      return piece.gap + 28 + text_width(piece.text, piece.font);
    case Piece::Kind::tag:
    case Piece::Kind::outlined_tag:
    case Piece::Kind::dashed_tag:
      return piece.gap + 12 + text_width(piece.text, piece.font);
    case Piece::Kind::text:
    case Piece::Kind::aged:
      break;
  }
  return piece.gap + text_width(piece.text, piece.font);
}

double width_of(const std::vector<Piece>& pieces) {
  double width = 0;
  for (const Piece& piece : pieces) width += width_of(piece);
  return width;
}

enum class Detail : std::uint8_t { full, no_source, least };

std::vector<Piece> corner_of(const TileText& t, bool lone, Detail detail) {
  const QFont small = font(12), strong = font(12, true);
  using Kind = Piece::Kind;
  std::vector<Piece> pieces;
  const auto gap = [&](double px) { return pieces.empty() ? 0.0 : px; };
  const auto tag = [&](Kind kind, const QString& word, Role role, Role fill = Role::bg_tile) {
    pieces.push_back({kind, word, strong, role, fill, gap(5)});
  };
  if (t.simulated) tag(Kind::dashed_tag, QStringLiteral("SIM"), Role::sim);
  if (t.replay && lone) tag(Kind::tag, QStringLiteral("REPLAY"), Role::replay_on, Role::replay);
  if (t.manual) tag(Kind::outlined_tag, QStringLiteral("MAN"), Role::text_2);
  const bool tagged = !pieces.empty();
  const bool least = detail == Detail::least;
  const QString age = q(t.age);
  switch (t.state) {
    case ValueState::stale:
      if (!least) pieces.push_back({Kind::icon, QStringLiteral("clock"), small, Role::text, {}, gap(5)});
      pieces.push_back({Kind::text, QStringLiteral("STALE ") + age, strong, Role::text, {}, gap(4)});
      return pieces;
    case ValueState::lost:
      if (!least) pieces.push_back({Kind::icon, QStringLiteral("cross"), small, Role::text, {}, gap(5)});
      pieces.push_back({Kind::text, QStringLiteral("LOST ") + age, strong, Role::text, {}, gap(4)});
      return pieces;
    case ValueState::alert: {
      const QString limit = q(t.limit).isEmpty() ? QString::fromLatin1(alert_word(t.priority)) : q(t.limit);
      tag(Kind::alert_tag, least ? limit.section(QLatin1Char(','), 0, 0) : limit, alert_roles(t.priority).on,
          alert_roles(t.priority).fill);
      return pieces;
    }
    case ValueState::disagree:
      tag(Kind::tag, QStringLiteral("DISAGREE"), Role::caution_on, Role::caution);
      return pieces;
    case ValueState::pending:
      pieces.push_back({Kind::text, QStringLiteral("sent %1 ago").arg(age), small, Role::text_2, {}, gap(6)});
      return pieces;
    case ValueState::live:
    case ValueState::ageing:
      break;
  }
  const bool ageing = t.state == ValueState::ageing;
  if (!t.source.empty() && !tagged && detail == Detail::full) {
    const bool changed = !t.was_source.empty();
    pieces.push_back(
        {Kind::text, q(t.source), changed ? strong : small, changed ? Role::text : Role::text_2, {}, 0});
    if (changed)
      pieces.push_back({Kind::text, QStringLiteral(" was ") + q(t.was_source), small, Role::text_2, {}, 0});
    if (!age.isEmpty()) pieces.push_back({Kind::text, QStringLiteral(" · "), small, Role::text_2, {}, 0});
  } else if (!t.was_source.empty() && !t.source.empty()) {
    // A change of source is never dropped for want of room: the age is.
    pieces.push_back({Kind::text, q(t.source), strong, Role::text, {}, gap(6)});
    if (!least)
      pieces.push_back({Kind::text, QStringLiteral(" was ") + q(t.was_source), small, Role::text_2, {}, 0});
    return pieces;
  }
  if (age.isEmpty()) return pieces;
  if (ageing && !least)
    pieces.push_back({Kind::icon, QStringLiteral("clock"), small, Role::text, {}, tagged ? 5.0 : 0.0});
  pieces.push_back({ageing ? Kind::aged : Kind::text,
                    age,
                    small,
                    ageing ? Role::text : Role::text_2,
                    {},
                    ageing && !least ? 5.0 : (tagged ? 5.0 : 0.0)});
  return pieces;
}

void draw_piece(QPainter& painter, double x, double base, const Piece& piece, const TileText& text,
                const Colours& colours) {
  const QColor ink = colours.of(piece.role);
  const double w = width_of(piece) - piece.gap;
  x += piece.gap;
  switch (piece.kind) {
    case Piece::Kind::text:
      draw_text(painter, {x, base}, piece.text, piece.font, ink);
      return;
    case Piece::Kind::aged: {
      draw_text(painter, {x, base}, piece.text, piece.font, ink);
      for (double dot = std::round(x); dot < x + w; dot += 2)
        painter.fillRect(QRectF(dot, base + 3, 1, 1), ink);
      return;
    }
    case Piece::Kind::icon:
      draw_icon(painter, {x + 7, base - 4}, piece.text, 14, ink);
      return;
    case Piece::Kind::tag:
    case Piece::Kind::alert_tag:
    case Piece::Kind::outlined_tag:
    case Piece::Kind::dashed_tag:
      break;
  }
  const QRect box(static_cast<int>(std::round(x)), static_cast<int>(base) - 13,
                  static_cast<int>(std::round(w)), 17);
  if (piece.kind == Piece::Kind::tag || piece.kind == Piece::Kind::alert_tag) {
    painter.fillRect(box, colours.of(piece.fill));
  } else {
    painter.setBrush(Qt::NoBrush);
    QPen pen(ink, 1.0);
    if (piece.kind == Piece::Kind::dashed_tag) pen.setDashPattern({3, 2});
    painter.setPen(pen);
    painter.drawRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5));
  }
  double at = x + 6;
  if (piece.kind == Piece::Kind::alert_tag) {
    draw_alert_icon(painter, {x + 12, base - 4.5}, 12, text.priority, AlertMark::acknowledged, colours,
                    AlertGround::fill);
    at = x + 22;
  }
  draw_text(painter, {at, base}, piece.text, piece.font, ink);
}

double value_width(const QString& value, int px) {
  const QFont bold = font(px, true);
  const bool sign = value.startsWith(QLatin1Char('+')) || value.startsWith(QChar(0x2212));
  return sign ? kSignSlot * px + text_width(value.mid(1), bold) : text_width(value, bold);
}

double draw_value(QPainter& painter, QPointF at, const QString& value, int px, const QColor& ink) {
  const QFont bold = font(px, true);
  const bool sign = value.startsWith(QLatin1Char('+')) || value.startsWith(QChar(0x2212));
  if (!sign) return draw_text(painter, at, value, bold, ink);
  const double slot = kSignSlot * px;
  draw_text_centred(painter, at + QPointF(slot / 2, 0), value.left(1), bold, ink);
  return draw_text(painter, at + QPointF(slot, 0), value.mid(1), bold, ink);
}

}  // namespace

void draw_tile_ground(QPainter& painter, const QRect& rect, const TileText& t, const Colours& colours) {
  painter.fillRect(rect, colours.of(t.state == ValueState::lost ? Role::bg_panel : Role::bg_tile));
  if (t.state == ValueState::stale) draw_hatch(painter, rect, colours.of(Role::bg_panel));
  painter.setBrush(Qt::NoBrush);
  double inset = 0;
  const auto border = [&](Role role, double width, bool dashed) {
    QPen pen(colours.of(role), width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
    if (dashed) pen.setDashPattern({4, 3});
    painter.setPen(pen);
    const double in = inset + width / 2;
    painter.drawRect(QRectF(rect).adjusted(in, in, -in, -in));
    inset += width + 1;
  };
  int edge = 0;
  if (t.replay) {
    painter.fillRect(QRect(rect.left(), rect.top(), 3, rect.height()), colours.of(Role::replay));
    edge = 3;
  }
  switch (t.state) {
    case ValueState::lost:
      border(Role::line_strong, 1, true);
      break;
    case ValueState::pending:
      border(Role::line_strong, 1, false);
      break;
    case ValueState::disagree:
      border(Role::caution_mark, 1, false);
      painter.fillRect(QRect(rect.left() + edge, rect.top(), 4, rect.height()),
                       colours.of(Role::caution_icon));
      break;
    case ValueState::alert:
      border(alert_roles(t.priority).mark, 2, false);
      break;
    case ValueState::live:
    case ValueState::ageing:
    case ValueState::stale:
      break;
  }
  if (t.simulated) border(Role::sim, 1, true);
  // Above the border: a recorded value keeps its edge in every state.
  if (t.replay) painter.fillRect(QRect(rect.left(), rect.top(), 3, rect.height()), colours.of(Role::replay));
}

void draw_tile(QPainter& painter, const QRect& rect, const TileText& t, const Colours& colours,
               TileStyle style) {
  painter.save();
  painter.setClipRect(rect, Qt::IntersectClip);
  draw_tile_ground(painter, rect, t, colours);

  const Lines lines = lines_of(rect.height(), t, style.value_px);
  const double left = rect.left() + kPad, right = rect.left() + rect.width() - kPad;
  const double top = rect.top();
  const QFont small = font(12), body = font(13);

  const QString label = q(t.label);
  const double room = right - left - text_width(label, small) - 6;
  std::vector<Piece> corner;
  for (const Detail detail : {Detail::full, Detail::no_source, Detail::least}) {
    corner = corner_of(t, style.lone, detail);
    if (width_of(corner) <= room) break;
  }
  double x = right - width_of(corner);
  draw_text(painter, {left, top + lines.label}, elided(label, small, x - left - 4), small,
            colours.of(Role::text_2));
  for (const Piece& piece : corner) {
    draw_piece(painter, x, top + lines.label, piece, t, colours);
    x += width_of(piece);
  }

  if (t.state == ValueState::lost || t.value.empty()) {
    draw_text(painter, {left, top + lines.value}, kUnknown, font(18), colours.of(Role::text_2));
  } else {
    const bool stale = t.state == ValueState::stale;
    const QColor ink = colours.of(stale                          ? Role::stale
                                  : t.state == ValueState::alert ? alert_roles(t.priority).mark
                                                                 : Role::text);
    const QString sigma = t.sigma.empty() ? QString() : QStringLiteral("σ ") + q(t.sigma);
    const QString unit = q(t.unit);
    const double sigma_width = sigma.isEmpty() ? 0 : text_width(sigma, body) + 8;
    const double beside = unit.isEmpty() ? 0 : text_width(unit, body) + 7;
    int px = lines.px;
    const bool tall = rect.height() >= 78 && lines.second == 0;
    const double widest_line = value_width(q(t.value), px) + beside;
    // Where the tile has a line to spare sigma goes there rather than the value down a size.
    const double spare = t.note.empty() ? 0 : text_width(q(t.note), small) + 8;
    const bool below =
        tall && widest_line + sigma_width > right - left && spare + sigma_width <= right - left;
    const double same_line = below ? 0 : sigma_width;
    for (const int smaller : {22, 18, 15}) {
      const double widest = std::max(value_width(q(t.value), px), value_width(q(t.value_2), px));
      if (widest + beside + same_line <= right - left) break;
      px = std::min(px, smaller);
    }
    double end = draw_value(painter, {left, top + lines.value}, q(t.value), px, ink);
    if (lines.second > 0) end = draw_value(painter, {left, top + lines.second}, q(t.value_2), px, ink);
    const double base = top + (lines.second > 0 ? lines.second : lines.value);
    draw_text(painter, {end + 7, base}, unit, body, colours.of(stale ? Role::stale : Role::text_2));
    draw_text_right(painter, {right, below ? top + 65 : base}, sigma, body,
                    colours.of(stale ? Role::stale : Role::text));
  }

  if (lines.note > 0) {
    const bool pending = t.state == ValueState::pending;
    const QString note = t.note.empty() ? QStringLiteral("waiting for the vehicle") : q(t.note);
    double at = left;
    if (pending) {
      draw_icon(painter, {at + 7, top + lines.note - 4}, QStringLiteral("clock"), 14, colours.of(Role::text));
      at += 18;
    }
    const bool plain =
        t.state == ValueState::live || t.state == ValueState::ageing || t.state == ValueState::stale;
    draw_text(painter, {at, top + lines.note}, elided(note, small, right - at), small,
              colours.of(plain ? Role::text_2 : Role::text));
  }
  painter.restore();
}

}  // namespace leadline::ui
