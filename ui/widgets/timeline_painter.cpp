#include "ui/widgets/timeline_painter.h"

#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/availability_boxes.h"
#include "ui/widgets/clock_text.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

// Down from the top of the timeline, px.
constexpr int kIcons = 20, kWords = 25, kBand = 33, kBandHeight = 16, kTicks = 52, kCurveTop = 56,
              kCurveFoot = 73, kHours = 88, kLoopTop = 9, kLoopFoot = 77;

void draw_availability(QPainter& painter, const QRect& rect, const TimelineData& data, const TimeScale& scale,
                       const Colours& colours) {
  const int top = rect.top() + kBand;
  const QFont strong = font(12, true);
  for (const auto& part : data.availability) {
    if (part.span.until < scale.span.from || scale.span.until < part.span.from) continue;
    const int x0 = static_cast<int>(std::round(scale.x(part.span.from)));
    const int x1 = std::max(x0 + 1, static_cast<int>(std::round(scale.x(part.span.until))));
    const QRect box(x0, top, x1 - x0, kBandHeight);
    const auto priority = attention(part.mode);
    Role ink = Role::text;
    if (!priority) {
      painter.fillRect(box, colours.of(Role::line_strong, 0.45));
    } else if (*priority == Alarm::Priority::caution) {
      painter.fillRect(box, colours.of(Role::line_strong, 0.22));
      painter.fillRect(QRect(x0, top + kBandHeight - 3, box.width(), 3), colours.of(Role::caution_icon));
    } else {
      painter.fillRect(box, colours.of(alert_roles(*priority).fill));
      ink = alert_roles(*priority).on;
    }
    if (x0 > scale.left + 1) painter.fillRect(QRect(x0, top, 1, kBandHeight), colours.of(Role::bg_panel));
    // Always written where it can be read: in the middle of the part that is in view.
    const double in0 = std::max<double>(x0, scale.left), in1 = std::min<double>(x1, scale.left + scale.width);
    const QString word = letter(part.mode);
    const double lift = priority && *priority == Alarm::Priority::caution ? -1 : 0;
    if (in1 - in0 >= text_width(word, strong))
      draw_text_centred(painter, {(in0 + in1) / 2, base_line(top + kBandHeight / 2.0, strong) + lift}, word,
                        strong, colours.of(ink));
  }
}

void draw_gaps(QPainter& painter, const QRect& rect, const TimelineData& data, const TimeScale& scale,
               const Colours& colours) {
  for (const auto& gap : data.gaps) {
    if (gap.span.until < scale.span.from || scale.span.until < gap.span.from) continue;
    const double x0 = std::round(scale.x(gap.span.from));
    const double x1 = std::max(x0 + 5, std::round(scale.x(gap.span.until)));
    const QRectF box(x0, rect.top() + kBand - 2, x1 - x0, kBandHeight + 4);
    painter.fillRect(box, colours.of(Role::bg_panel));
    draw_hatch(painter, box, colours.of(Role::line_strong));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.of(Role::text_2), 1.0));
    painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

/// Icons that would cover one another are one: the gravest.
std::vector<std::pair<double, Alarm::Priority>> alert_places(const TimelineData& data,
                                                             const TimeScale& scale) {
  std::vector<std::pair<double, Alarm::Priority>> places;
  for (const auto& alert : data.alerts) {
    if (alert.at < scale.span.from || scale.span.until < alert.at) continue;
    const double x = scale.x(alert.at);
    if (!places.empty() && x - places.back().first < 12)
      places.back().second = std::max(places.back().second, alert.priority);
    else
      places.emplace_back(x, alert.priority);
  }
  return places;
}

void draw_events(QPainter& painter, const QRect& rect, const TimelineData& data, const TimeScale& scale,
                 const Colours& colours) {
  const auto alerts = alert_places(data, scale);
  const QFont small = font(12);
  std::vector<double> stops;  // where something else begins
  for (const auto& [x, priority] : alerts) stops.push_back(x - 8);
  for (const auto& event : data.events) stops.push_back(scale.x(event.at) - 6);
  std::sort(stops.begin(), stops.end());
  double free_from = scale.left - TimeScale::kMargin;
  for (const auto& event : data.events) {
    if (event.at < scale.span.from || scale.span.until < event.at) continue;
    double x = std::round(scale.x(event.at));
    const double y = rect.top() + kWords;
    // Beside the icon of an alert rather than under it.
    for (const auto& [icon, priority] : alerts)
      if (std::abs(x - icon) < 13) x = icon + (x < icon ? -13 : 13);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.of(Role::text_2));
    painter.drawPolygon(QPolygonF{{{x - 4, y - 7}, {x + 4, y - 7}, {x, y}}});
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double begin = x + 7;
    const auto next = std::upper_bound(stops.begin(), stops.end(), x);
    const double end = std::min(next == stops.end() ? 1e9 : *next, rect.right() - 2.0);
    const QString words = q(event.text);
    if (begin < free_from || end - begin < text_width(words, small)) continue;
    free_from = draw_text(painter, {begin, y}, words, small, colours.of(Role::text_2)) + 4;
  }
  for (const auto& [x, priority] : alerts)
    draw_alert_icon(painter, {std::round(x), rect.top() + double{kIcons}}, 14, priority,
                    AlertMark::acknowledged, colours);
}

void draw_sigma(QPainter& painter, const QRect& rect, const TimelineData& data, const TimeScale& scale,
                const Colours& colours) {
  const double foot = rect.top() + kCurveFoot, height = kCurveFoot - kCurveTop;
  painter.fillRect(QRectF(scale.left, foot + 1, scale.width, 1), colours.of(Role::line));
  if (data.sigma.empty()) return;
  double top = 0;
  for (const auto& s : data.sigma) top = std::max(top, s.drms_m);
  if (!(top > 0)) return;
  // One extreme a pixel: a peak is never lost and a long run costs its width.
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::ceil(scale.width) + 1));
  std::vector<double> most(columns, -1.0);
  for (const auto& s : data.sigma) {
    if (s.at < scale.span.from || scale.span.until < s.at) continue;
    auto& m =
        most[std::min(columns - 1, static_cast<std::size_t>(std::max(0.0, scale.x(s.at) - scale.left)))];
    m = std::max(m, s.drms_m);
  }
  QPainterPath path;
  bool begun = false;
  for (std::size_t i = 0; i < columns; ++i) {
    if (most[i] < 0) continue;
    // Square root: decimetres and a hundred metres on 17 px.
    const QPointF at(scale.left + static_cast<double>(i), foot - height * std::sqrt(most[i] / top));
    begun ? path.lineTo(at) : path.moveTo(at);
    begun = true;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.of(Role::vehicle), 1.5));
  painter.drawPath(path);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void draw_hours(QPainter& painter, const QRect& rect, const TimeScale& scale, const Colours& colours) {
  constexpr std::array<int, 17> kSteps{1,   2,   5,    10,   15,   30,    60,    120,  300,
                                       600, 900, 1800, 3600, 7200, 10800, 21600, 86400};
  const double span_s = seconds(scale.span.until - scale.span.from);
  if (!(span_s > 0)) return;
  int step = kSteps.back();
  for (const int s : kSteps)
    if (s / span_s * scale.width >= 130) {
      step = s;
      break;
    }
  const std::int64_t step_ns = std::int64_t{step} * 1'000'000'000;
  const QFont small = font(12);
  for (std::int64_t ns = (scale.span.from.ns / step_ns) * step_ns; ns <= scale.span.until.ns; ns += step_ns) {
    if (ns < scale.span.from.ns) continue;
    const double x = std::round(scale.x({ns}));
    painter.fillRect(QRectF(x, rect.top() + kTicks, 1, 4), colours.of(Role::text_2));
    const QString text = step < 60 ? clock_text({ns}) : hour_text({ns});
    const double half = text_width(text, small) / 2;
    if (x - half < rect.left() + 2 || x + half > rect.right() - 2) continue;
    draw_text_centred(painter, {x, rect.top() + double{kHours}}, text, small, colours.of(Role::text_2));
  }
}

}  // namespace

TimeScale::TimeScale(TimeSpan shown, const QRect& rect)
    : span(shown), left(rect.left() + kMargin), width(std::max(1.0, rect.width() - 2 * kMargin)) {
  if (span.until <= span.from) span.until = span.from + Duration(1);
}

double TimeScale::x(Time t) const {
  return left + width * (seconds(t - span.from) / seconds(span.until - span.from));
}

Time TimeScale::at(double x) const {
  const double share = std::clamp((x - left) / width, 0.0, 1.0);
  return span.from + Duration(static_cast<std::int64_t>(
                         std::llround(share * static_cast<double>((span.until - span.from).count()))));
}

void draw_timeline(QPainter& painter, const QRect& rect, const TimelineData& data, TimeSpan span,
                   const Colours& colours) {
  const TimeScale scale(span, rect);
  painter.fillRect(rect, colours.of(Role::bg_panel));
  painter.save();
  painter.setClipRect(QRectF(scale.left, rect.top(), scale.width, rect.height()), Qt::IntersectClip);
  painter.fillRect(QRectF(scale.left, rect.top() + kBand, scale.width, kBandHeight),
                   colours.of(Role::bg_tile));
  draw_availability(painter, rect, data, scale, colours);
  draw_gaps(painter, rect, data, scale, colours);
  draw_sigma(painter, rect, data, scale, colours);
  painter.restore();
  draw_events(painter, rect, data, scale, colours);
  draw_hours(painter, rect, scale, colours);
  if (!data.complete)
    draw_text_right(painter, {rect.right() - TimeScale::kMargin, rect.top() + 12.0},
                    QStringLiteral("still reading"), font(12), colours.of(Role::text_2));
}

void draw_loop(QPainter& painter, const QRect& rect, TimeSpan loop, TimeSpan span, const Colours& colours) {
  const TimeScale scale(span, rect);
  const QFont small = font(12);
  painter.save();
  painter.setClipRect(QRectF(scale.left - 8, rect.top(), scale.width + 16, rect.height()), Qt::IntersectClip);
  const double top = rect.top() + kLoopTop, foot = rect.top() + kLoopFoot;
  const double a = std::round(scale.x(loop.from)), b = std::round(scale.x(loop.until));
  const bool whole = loop.from < loop.until;
  if (whole) painter.fillRect(QRectF(a, top, b - a, foot - top), colours.of(Role::replay, 0.14));
  const QColor violet = colours.of(Role::replay);
  const auto bracket = [&](double x, double inward) {
    painter.fillRect(QRectF(x - 1, top, 2, foot - top), violet);
    for (const double y : {top, foot - 2}) painter.fillRect(QRectF(std::min(x, x + inward), y, 7, 2), violet);
  };
  bracket(a, 7);
  if (whole) bracket(b, -7);
  const double words = text_width(QStringLiteral("A"), small);
  draw_text(painter, {a + 9, top + 10}, QStringLiteral("A"), small, violet);
  if (whole && b - a > 2 * words + 26)
    draw_text_right(painter, {b - 9, top + 10}, QStringLiteral("B"), small, violet);
  painter.restore();
}

void draw_play_head(QPainter& painter, const QRect& rect, Time now, TimeSpan span, const Colours& colours) {
  if (now < span.from || span.until < now) return;
  const double x = std::round(TimeScale(span, rect).x(now));
  const double top = rect.top() + 1;
  painter.save();
  painter.fillRect(QRectF(x - 2, top + 8, 4, kLoopFoot - 8), colours.of(Role::bg_panel));
  painter.fillRect(QRectF(x - 1, top + 8, 2, kLoopFoot - 8), colours.of(Role::text));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours.of(Role::bg_panel), 1.0));
  painter.setBrush(colours.of(Role::text));
  painter.drawPolygon(
      QPolygonF{{{x - 7, top}, {x + 7, top}, {x + 7, top + 8}, {x, top + 15}, {x - 7, top + 8}}});
  painter.restore();
}

}  // namespace leadline::ui
