#include "ui/chart/chart_canvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPixmapCache>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"
#include "ui/chart/furniture_panel.h"
#include "ui/chart/graticule.h"
#include "ui/chart/layer_badge.h"
#include "ui/chart/legend.h"
#include "ui/chart/scale_bar.h"
#include "ui/chart/watermark.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"
#include "ui/models/figures.h"

namespace leadline::ui {
namespace {

constexpr double kFirstScale_m_px = 1.0;
constexpr int kStampCache_KiB = 64 << 10;
constexpr double kWheelStep = 1.25;
constexpr int kKeyStep_px = 80;
/// Turns of the chart are whole steps of this, so that a swinging heading does not paint everything each
/// time.
constexpr double kTurnStep_deg = 0.5;
constexpr double kRoomAround = 1.25;
const QSize kOverviewFrom{1000, 620};  ///< a smaller chart has no room for it
constexpr int kLegendFrom_px = 460;

QString line_name(TrackKind kind) {
  switch (kind) {
    case TrackKind::fused:
      return QStringLiteral("fused");
    case TrackKind::dead_reckoning:
      return QStringLiteral("dead reckoning");
    case TrackKind::ship:
      return QStringLiteral("ship");
    case TrackKind::other:
      break;
  }
  return QStringLiteral("other engine");
}

std::vector<BadgeLine> badge_lines(const Background& background) {
  std::vector<BadgeLine> lines;
  for (const LayerLine& layer : background.layers())
    lines.push_back({QString::fromStdString(layer.name), QString::fromStdString(layer.detail),
                     layer.state == LayerLine::State::broken ? BadgeLine::Doubt::broken
                     : layer.accuracy_known || layer.state == LayerLine::State::hidden
                         ? BadgeLine::Doubt::none
                         : BadgeLine::Doubt::accuracy_unknown,
                     layer.accuracy_m});
  return lines;
}

/// Where the legend stands over the scale bar.
QPointF above(const QRectF& bar) { return bar.topLeft() - QPointF(0, 8); }

}  // namespace

ChartCanvas::ChartCanvas(QWidget* parent) : QWidget(parent), view_({}, QSize(1, 1), kFirstScale_m_px) {
  setObjectName("chart");
  setAccessibleName("Chart");
  setFocusPolicy(Qt::StrongFocus);
  setProperty("ringInside", true);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(240, 180);
  QPixmapCache::setCacheLimit(kStampCache_KiB);
  setCursor(Qt::BlankCursor);  // its own cross has a free middle
  connect(&Look::current(), &Look::lookChanged, this, &ChartCanvas::anew);
}

void ChartCanvas::set_background(Background* background) {
  if (background_ != nullptr) background_->disconnect(this);
  background_ = background;
  if (background_ != nullptr) {
    connect(background_, &Background::changed, this, [this](const QRectF& box) {
      if (box.isNull())
        ground_.invalidate();
      else
        ground_.invalidate({box.left(), box.top(), box.right(), box.bottom()});
      update();
    });
    connect(background_, &Background::overviewChanged, this, [this] {
      overview_.forget();
      update();
    });
    connect(background_, &Background::layersChanged, this, qOverload<>(&ChartCanvas::update));
  }
  anew();
}

void ChartCanvas::set_history(const History* history) {
  history_ = history;
  anew();
}

const BodyState* ChartCanvas::followed() const {
  if (!follow_) return nullptr;
  if (*follow_ == Body::ship) return snapshot_.ship ? &*snapshot_.ship : nullptr;
  return snapshot_.vehicle ? &*snapshot_.vehicle : nullptr;
}

void ChartCanvas::set_snapshot(const Snapshot& snapshot) {
  snapshot_ = snapshot;
  keep_followed();
  update();
}

void ChartCanvas::keep_followed() {
  const BodyState* body = followed();
  if (body == nullptr) return;
  const Solution& s = body->solution;
  const Geodetic before = view_.centre();
  if (orientation_ == Orientation::north_up) {
    turn_to({}, s.position);
  } else {
    std::optional<Angle> up = s.heading;
    if (orientation_ == Orientation::course_up && s.vel_north_mps && s.vel_east_mps)
      up = Angle::rad(std::atan2(*s.vel_east_mps, *s.vel_north_mps));
    if (up) turn_to(*up, s.position);
  }
  view_.centre_on(s.position);
  if (geo::geodesic(before, view_.centre()).distance_m > 0.0) emit viewChanged();
}

void ChartCanvas::turn_to(Angle true_bearing, Geodetic at) {
  const double plane_deg = (true_bearing - view_.projection().convergence(at)).wrapped_2pi().deg();
  view_.turn(Angle::deg(std::round(plane_deg / kTurnStep_deg) * kTurnStep_deg));
}

void ChartCanvas::moved() {
  emit viewChanged();
  update();
}

void ChartCanvas::anew() {
  ground_.invalidate();
  overview_.forget();
  update();
}

void ChartCanvas::set_centre(Geodetic centre) {
  view_.centre_on(centre);
  if (orientation_ == Orientation::north_up) turn_to({}, centre);
  moved();
}

void ChartCanvas::set_metres_per_px(double metres_per_px) {
  view_.set_metres_per_px(metres_per_px);
  moved();
}

void ChartCanvas::zoom_by(double factor) {
  emit viewTaken();
  view_.zoom(factor, QPointF(width() / 2.0, height() / 2.0));
  keep_followed();
  moved();
}

void ChartCanvas::show_all() {
  if (history_ == nullptr) return;
  tracks_.sync(*history_, view_.projection(), snapshot_.now);
  const auto box = tracks_.extent();
  if (!box) return;
  const Geodetic middle =
      view_.projection().reverse({(box->west_m + box->east_m) / 2.0, (box->south_m + box->north_m) / 2.0});
  const double wide = kRoomAround * (box->east_m - box->west_m) / std::max(1, width());
  const double high = kRoomAround * (box->north_m - box->south_m) / std::max(1, height());
  view_.centre_on(middle);
  view_.set_metres_per_px(std::max({wide, high, 0.1}));
  moved();
}

void ChartCanvas::set_orientation(Orientation orientation) {
  if (orientation == orientation_) return;
  orientation_ = orientation;
  if (orientation == Orientation::north_up) view_.turn({});
  keep_followed();
  emit orientationChanged();
  moved();
}

void ChartCanvas::set_follow(std::optional<Body> body) {
  if (body == follow_) return;
  follow_ = body;
  keep_followed();
  emit followChanged();
  moved();
}

void ChartCanvas::set_tool(Tool tool) {
  if (tool == tool_) return;
  tool_ = tool;
  measured_from_.reset();
  measured_to_.reset();
  emit toolChanged();
  update();
}

bool ChartCanvas::settled() const { return background_ == nullptr || background_->settled(); }

void ChartCanvas::paint_ground(QPainter& painter, const QRect& exposed) {
  const Colours& colours = Look::current().colours();
  if (background_ != nullptr)
    background_->paint(painter, view_, exposed, colours);
  else
    painter.fillRect(exposed, colours.of(Role::sea_deep));
  if (snapshot_.replay) {
    // It moves with the ground: what stands in the picture need not be painted again.
    painter.save();
    painter.translate(view_.origin_px());
    draw_replay_watermark(painter, exposed.translated(-view_.origin_px()), colours);
    painter.restore();
  }
  draw_graticule(painter, view_, graticule_step(view_), exposed, colours);
  painter.setRenderHint(QPainter::Antialiasing);
  tracks_.paint(painter, view_, exposed, colours);
  fixes_.paint(painter, view_, exposed, colours);
}

void ChartCanvas::bring_ground_up_to_date() {
  const Colours& colours = Look::current().colours();
  const auto paint = [this](QPainter& painter, const QRect& exposed) { paint_ground(painter, exposed); };
  TrackLayer::Change tracks = TrackLayer::Change::none;
  FixLayer::Change fixes = FixLayer::Change::none;
  if (history_ != nullptr) {
    tracks = tracks_.sync(*history_, view_.projection(), snapshot_.now);
    fixes = fixes_.sync(*history_, view_, snapshot_.now);
  }
  if (tracks == TrackLayer::Change::anew || fixes == FixLayer::Change::anew) ground_.invalidate();
  ground_.update(view_, paint);
  if (tracks == TrackLayer::Change::grown)
    ground_.add(tracks_.added(view_),
                [&](QPainter& painter, const QRect&) { tracks_.paint_added(painter, view_, colours); });
  if (fixes == FixLayer::Change::grown)
    ground_.add(fixes_.added(view_),
                [&](QPainter& painter, const QRect&) { fixes_.paint_added(painter, view_, colours); });
  tracks_.settle();
  fixes_.settle();
}

void ChartCanvas::paintEvent(QPaintEvent*) {
  const Colours& colours = Look::current().colours();
  bring_ground_up_to_date();
  QPainter painter(this);
  ground_.draw(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  const Furniture stands = furniture();
  live_.paint(painter, view_, snapshot_, follow_, stands.taken, colours);
  draw_graticule_figures(painter, view_, graticule_step(view_), stands.taken, colours);
  paint_furniture(painter, stands);
  paint_measured(painter);
  paint_cursor(painter);
}

ChartCanvas::Furniture ChartCanvas::furniture() const {
  Furniture f;
  const BodyState* body = followed();
  f.facts = {orientation_, Motion::true_motion,
             body != nullptr ? QString::fromStdString(body->name) : QString()};
  f.taken.push_back(orientation_box(view_, f.facts));
  if (background_ != nullptr) {
    f.badge = badge_lines(*background_);
    f.taken.push_back(layer_badge_box(view_, f.badge, badge_folded_));
  }
  const QRectF bar = scale_bar_box(view_);
  f.taken.push_back(bar);
  for (const TrackKind kind : tracks_.kinds())
    f.legend.push_back({LegendRow::Sample::line, track_line(kind), line_name(kind)});
  const FixLayer::Kinds kinds = fixes_.kinds();
  if (kinds.used && kinds.refused)
    f.legend.push_back({LegendRow::Sample::fixes, {}, QStringLiteral("fix used, refused")});
  else if (kinds.used)
    f.legend.push_back({LegendRow::Sample::fix_used, {}, QStringLiteral("fix used")});
  else if (kinds.refused)
    f.legend.push_back({LegendRow::Sample::fix_refused, {}, QStringLiteral("fix refused")});
  if (height() < kLegendFrom_px) f.legend.clear();
  f.taken.push_back(legend_box(above(bar), f.legend));
  if (background_ != nullptr && width() >= kOverviewFrom.width() && height() >= kOverviewFrom.height()) {
    f.overview = QPoint(width() - Overview::kSize.width() - int(kFurnitureMargin_px),
                        height() - Overview::kSize.height() - int(kFurnitureMargin_px));
    f.taken.emplace_back(*f.overview, Overview::kSize);
  }
  return f;
}

void ChartCanvas::paint_furniture(QPainter& painter, const Furniture& f) {
  const Colours& colours = Look::current().colours();
  draw_orientation_box(painter, view_, f.facts, colours);
  badge_box_ = draw_layer_badge(painter, view_, f.badge, badge_folded_, colours);
  const QRectF bar = draw_scale_bar(painter, view_, colours);
  draw_legend(painter, above(bar), f.legend, colours);
  if (f.overview) overview_.paint(painter, *f.overview, *background_, view_.centre(), colours);
}

void ChartCanvas::paint_measured(QPainter& painter) const {
  if (!measured_from_ || !measured_to_) return;
  const Colours& colours = Look::current().colours();
  const QPointF from = view_.to_screen(*measured_from_), to = view_.to_screen(*measured_to_);
  QPainterPath line(from);
  line.lineTo(to);
  line.addEllipse(from, 3, 3);
  line.addEllipse(to, 3, 3);
  stroke_haloed(painter, line, {Role::ink, 1.6}, Halo::line, colours);
  const geo::GeodesicLine there = geo::geodesic(*measured_from_, *measured_to_);
  const geo::GeodesicLine back = geo::geodesic(*measured_to_, *measured_from_);
  const QString text =
      QString::fromStdString(distance_text(there.distance_m) + "  " + heading_text(there.azimuth) + "° T / " +
                             heading_text(back.azimuth) + "° T");
  draw_halo_text(painter, (from + to) / 2.0 + QPointF(10, -8), text, ui::font(13, true), Role::ink, colours);
}

void ChartCanvas::paint_cursor(QPainter& painter) const {
  if (!cursor_) return;
  QPainterPath cross;
  for (const QPointF arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
    cross.moveTo(QPointF(*cursor_) + arm * 4.0);
    cross.lineTo(QPointF(*cursor_) + arm * 13.0);
  }
  stroke_haloed(painter, cross, {Role::ink, 1.2}, Halo::line, Look::current().colours());
}

void ChartCanvas::resizeEvent(QResizeEvent*) {
  view_.resize(size());
  keep_followed();
  emit viewChanged();
}

void ChartCanvas::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (event->button() == Qt::LeftButton && badge_box_.contains(event->localPos())) {
    badge_folded_ = !badge_folded_;
    update();
    return;
  }
  if (event->button() == Qt::LeftButton && tool_ == Tool::measure) {
    measured_from_ = measured_to_ = view_.to_geodetic(event->localPos());
  } else if (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton) {
    dragged_from_ = event->pos();
  }
  update();
}

void ChartCanvas::mouseMoveEvent(QMouseEvent* event) {
  cursor_ = event->pos();
  if (dragged_from_) {
    const QPoint step = event->pos() - *dragged_from_;
    dragged_from_ = event->pos();
    if (!step.isNull()) {
      emit viewTaken();
      set_follow({});
      view_.pan(step);
      emit viewChanged();
    }
  } else if (tool_ == Tool::measure && (event->buttons() & Qt::LeftButton) && measured_from_) {
    measured_to_ = view_.to_geodetic(event->localPos());
  }
  emit cursorMoved(view_.to_geodetic(event->localPos()));
  update();
}

void ChartCanvas::mouseReleaseEvent(QMouseEvent*) {
  if (dragged_from_) view_.centre_on(view_.centre());  // a long way: a new projection
  dragged_from_.reset();
  update();
}

void ChartCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (tool_ == Tool::measure || badge_box_.contains(event->localPos())) return;
  emit viewTaken();
  set_follow({});
  set_centre(view_.to_geodetic(event->localPos()));
}

void ChartCanvas::wheelEvent(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  if (steps == 0.0) return;
  emit viewTaken();
  view_.zoom(std::pow(kWheelStep, steps),
             follow_ ? QPointF(width() / 2.0, height() / 2.0) : event->position());
  keep_followed();
  moved();
}

void ChartCanvas::keyPressEvent(QKeyEvent* event) {
  const auto pan = [&](int x, int y) {
    emit viewTaken();
    set_follow({});
    view_.pan({x, y});
    view_.centre_on(view_.centre());
    moved();
  };
  // In replay the bare arrows step through time; with Shift they always move the chart.
  const bool bare = !(event->modifiers() & Qt::ShiftModifier);
  if (bare && snapshot_.replay) return QWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_Left:
      return pan(kKeyStep_px, 0);
    case Qt::Key_Right:
      return pan(-kKeyStep_px, 0);
    case Qt::Key_Up:
      return pan(0, kKeyStep_px);
    case Qt::Key_Down:
      return pan(0, -kKeyStep_px);
    default:
      QWidget::keyPressEvent(event);
  }
}

void ChartCanvas::leaveEvent(QEvent*) {
  cursor_.reset();
  emit cursorMoved(std::nullopt);
  update();
}

}  // namespace leadline::ui
