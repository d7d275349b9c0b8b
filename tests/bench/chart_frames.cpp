// Frame times of the chart through its real paint event: 1920 x 1080, a raster below, 50 ellipses, a long
// track in follow mode; each frame one point is appended and the view scrolls. Prints p50, p95 and the worst
// of 1,000 frames.

#include <fmt/format.h>

#include <QApplication>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>
#include <vector>

#include "core/geo/geodesy.h"
#include "ui/chart/chart_canvas.h"
#include "ui/look/look.h"

namespace {

using namespace leadline;
using namespace std::chrono_literals;

constexpr int kFrames = 1'000;
const Geodetic kStart{Angle::deg(25.1), Angle::deg(-77.4)};  // inside the raster

double ms_since(std::chrono::steady_clock::time_point begun) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

double resident_mib() {
  std::ifstream statm("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  statm >> all >> resident;
  return resident * 4096.0 / (1 << 20);
}

/// A survey: legs of 2 km, 40 m apart, at 6 m a point, weaving by a metre.
Geodetic survey(int i) {
  constexpr double kStep_m = 6.0, kLeg_m = 2'000.0, kApart_m = 40.0;
  const double along = i * kStep_m;
  const int leg = static_cast<int>(along / kLeg_m);
  const double on_leg = along - leg * kLeg_m;
  const double east = leg % 2 == 0 ? on_leg : kLeg_m - on_leg;
  return geo::displaced(kStart, leg * kApart_m - 6'000.0 + std::sin(i * 0.05),
                        east - 1'000.0 + std::cos(i * 0.07));
}

struct Scene {
  ui::Snapshot snapshot;
  ui::History history;
  Time at(int i) const { return Time{1'700'000'000'000'000'000} + 100ms * i; }

  explicit Scene(int points) {
    ui::Track track{0, "fusion", ui::Body::vehicle, {}};
    track.points.reserve(static_cast<std::size_t>(points + kFrames + 10));
    history.tracks.push_back(track);
    for (int i = 0; i < points; ++i) append();
    for (int i = 0; i < 50; ++i) {
      ui::TargetState target;
      target.name = fmt::format("T{}", i + 1);
      target.position =
          geo::displaced(snapshot.vehicle->solution.position, (i / 10 - 2) * 380.0, (i % 10 - 4.5) * 360.0);
      target.var_north_m2 = 3600.0 + 100.0 * i;
      target.var_east_m2 = 900.0;
      target.cov_north_east_m2 = 20.0 * i;
      target.feed = {"sonar", snapshot.now, 1.0};
      snapshot.targets.push_back(target);
    }
  }

  void append() {
    auto& points = history.tracks[0].points;
    const int i = static_cast<int>(points.size());
    points.push_back({at(i), survey(i), 0.6F});
    snapshot.now = at(i);
    ui::BodyState vehicle;
    vehicle.name = "MDV-1";
    vehicle.engine = "fusion";
    vehicle.valid = at(i);
    vehicle.rate_hz = 10.0;
    vehicle.solution.position = points.back().position;
    vehicle.solution.depth = Depth{1512.4};
    vehicle.solution.heading = Angle::deg((i / 333) % 2 == 0 ? 90.0 : 270.0);
    vehicle.solution.vel_north_mps = 0.1;
    vehicle.solution.vel_east_mps = 1.5;
    vehicle.solution.var_north_m2 = vehicle.solution.var_east_m2 = 900.0;
    vehicle.position = vehicle.heading = vehicle.velocity = vehicle.depth = ui::Feed{"dvl", at(i), 0.1};
    snapshot.vehicle = vehicle;
    // They go with the vehicle, so that all fifty stay in sight.
    for (int k = 0; k < static_cast<int>(snapshot.targets.size()); ++k) {
      auto& target = snapshot.targets[static_cast<std::size_t>(k)];
      target.position = geo::displaced(points.back().position, (k / 10 - 2) * 380.0, (k % 10 - 4.5) * 360.0);
      target.feed.valid = at(i);
    }
  }
};

void settle(ui::ChartCanvas& canvas) {
  for (int i = 0; i < 3'000; ++i) {
    QApplication::processEvents();
    canvas.repaint();
    if (canvas.settled()) return;
    std::this_thread::sleep_for(5ms);
  }
}

void run(ui::Background& background, int points) {
  const auto made = std::chrono::steady_clock::now();
  Scene scene(points);
  fmt::print("{} points (made in {:.0f} ms)\n", points, ms_since(made));
  ui::ChartCanvas canvas;
  canvas.resize(1920, 1080);
  canvas.set_background(&background);
  canvas.set_history(&scene.history);
  canvas.set_snapshot(scene.snapshot);
  canvas.set_follow(ui::Body::vehicle);
  canvas.set_metres_per_px(2.0);
  canvas.show();
  settle(canvas);
  const double before = resident_mib();
  std::vector<double> frames;
  for (int i = 0; i < kFrames; ++i) {
    QApplication::processEvents();  // tiles that came meanwhile
    const auto begun = std::chrono::steady_clock::now();
    scene.append();
    canvas.set_snapshot(scene.snapshot);
    canvas.repaint();
    frames.push_back(ms_since(begun));
  }
  const double after = resident_mib();
  const auto worst =
      static_cast<std::size_t>(std::max_element(frames.begin(), frames.end()) - frames.begin());
  auto sorted = frames;
  std::sort(sorted.begin(), sorted.end());
  fmt::print(
      "  {} frames: p50 {:.2f} ms, p95 {:.2f} ms, max {:.2f} ms (frame {}); memory {:.0f} -> {:.0f} MiB\n",
      kFrames, sorted[kFrames / 2], sorted[kFrames * 95 / 100], sorted.back(), worst, before, after);
  std::vector<double> cold;
  for (const double factor : {1.25, 1.25, 0.8, 0.8, 0.5, 0.5, 4.0}) {
    canvas.zoom_by(factor);
    const auto begun = std::chrono::steady_clock::now();
    canvas.repaint();
    cold.push_back(ms_since(begun));
    settle(canvas);
  }
  std::sort(cold.begin(), cold.end());
  fmt::print("  cold frame after a zoom: median {:.1f} ms, max {:.1f} ms\n", cold[cold.size() / 2],
             cold.back());
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  ui::Look::current().set(ui::Palette::day);
  ui::Background background;
  background.load_coastline(LEADLINE_BINARY_DIR "/charts");
  background.set_charts({argc > 1 ? argv[1] : LEADLINE_TEST_DATA "/map_tiles/RGB.byte.tif"});
  run(background, 100'000);
  if (argc <= 2) run(background, 1'000'000);
}
