#include "core/nav/plausibility/displacement_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leadline::nav {
namespace {

using Complex = DisplacementCheck::Complex;

constexpr double kWindowS = 64.0, kSpacingS = 2.0, kTrackSpacingS = 0.25, kGapS = 3.0;
constexpr double kCut = 16.0, kInlier = 3.5 * 3.5, kMedianChi2 = 1.386;
constexpr double kRatio = 30.0, kClearRatio = 40.0;  // twice the log likelihood ratio
constexpr double kWaySigmas = 5.0, kScaleWay_m = 10.0, kScaleWaySigmas = 14.0;
constexpr std::array<double, 5> kCalibrations{0.7, 0.85, 1.0, 1.2, 1.4};
constexpr double kShortest_m = 8.0;
constexpr std::array<double, 5> kScales{1.0, 0.3048, 1.0 / 0.3048, 1852.0 / 3600.0, 3600.0 / 1852.0};

template <class Iterator>
double median(Iterator begin, Iterator end) {
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end);
  return *middle;
}

}  // namespace

void DisplacementCheck::reset() {
  last_.reset();
  kept_.reset();
  track_ = {};
  sum_ = {};
  first_ = count_ = 0;
  times_ = 0;
}

void DisplacementCheck::velocity(Time t, Complex v, double heading_rad) {
  // Mirrored in the body's axes: e^{ih} conj(v e^{-ih}).
  const Complex folded = std::polar(1.0, 2.0 * heading_rad) * std::conj(v);
  if (last_) {
    const double dt_s = seconds(t - *last_);
    if (dt_s <= 0.0) return;
    if (dt_s > kGapS) return reset();
    sum_.plain += 0.5 * dt_s * (v + v_);
    sum_.mirrored += 0.5 * dt_s * (folded + folded_);
  }
  last_ = t;
  v_ = v, folded_ = folded, heading_rad_ = heading_rad;
  if (!kept_ || seconds(t - *kept_) >= kTrackSpacingS) {
    track_.add(t, sum_);
    kept_ = t;
  }
}

DisplacementCheck::Verdict DisplacementCheck::fix(Time t, Complex p, double sd_axis_m) {
  if (count_ > 0 && seconds(t - point(count_ - 1).t) < kSpacingS) return Verdict::open;
  const auto around = track_.at(t, 1.0);
  if (!around || seconds(*last_ - t) > 15.0) return Verdict::open;
  const auto between = [&](Complex a, Complex b) { return a + (b - a) * around->fraction; };
  while (count_ > 0 && (count_ == kPoints || seconds(t - point(0).t) > kWindowS))
    first_ = (first_ + 1) % kPoints, --count_;
  points_[(first_ + count_++) % kPoints] = {t,
                                            p,
                                            between(around->before->plain, around->after->plain),
                                            between(around->before->mirrored, around->after->mirrored),
                                            std::max(sd_axis_m, 0.1),
                                            heading_rad_};
  return evaluate();
}

DisplacementCheck::Fit DisplacementCheck::fit(const Reading& reading, double noise) const {
  const Complex m = reading.factor();
  std::array<Complex, kPoints> off;
  std::array<double, kPoints> north{}, east{}, square{};
  Fit fit;
  Complex begin;
  for (std::size_t i = 0; i < count_; ++i) {
    const Complex q = m * (reading.mirrored ? point(i).mirrored : point(i).plain);
    if (i == 0) begin = q;
    fit.travelled_m = std::max(fit.travelled_m, std::abs(q - begin));
    off[i] = point(i).p - q;
    north[i] = off[i].real(), east[i] = off[i].imag();
  }
  const auto n = static_cast<std::ptrdiff_t>(count_);
  const Complex offset(median(north.begin(), north.begin() + n), median(east.begin(), east.begin() + n));
  for (std::size_t i = 0; i < count_; ++i) {
    square[i] = std::norm(off[i] - offset) / (point(i).sd_m * point(i).sd_m);
    fit.cost += std::min(square[i] / noise, kCut);
    fit.inliers += square[i] / noise <= kInlier;
  }
  fit.noise = std::max(1.0, median(square.begin(), square.begin() + n) / kMedianChi2);
  return fit;
}

DisplacementCheck::Misreading DisplacementCheck::refined(const Reading& reading, const Fit& best) const {
  const Complex m = reading.factor();
  const auto track = [&](std::size_t i) { return reading.mirrored ? point(i).mirrored : point(i).plain; };
  std::array<double, kPoints> north{}, east{};
  for (std::size_t i = 0; i < count_; ++i) {
    const Complex off = point(i).p - m * track(i);
    north[i] = off.real(), east[i] = off.imag();
  }
  const auto n = static_cast<std::ptrdiff_t>(count_);
  const Complex offset(median(north.begin(), north.begin() + n), median(east.begin(), east.begin() + n));
  double weight = 0.0;
  Complex mean_p, mean_q;
  const auto inlier = [&](std::size_t i) {
    return std::norm(point(i).p - m * track(i) - offset) <=
           kInlier * best.noise * point(i).sd_m * point(i).sd_m;
  };
  for (std::size_t i = 0; i < count_; ++i)
    if (inlier(i)) weight += 1.0, mean_p += point(i).p, mean_q += track(i);
  mean_p /= weight, mean_q /= weight;
  Complex cross;
  double power = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (!inlier(i)) continue;
    cross += std::conj(track(i) - mean_q) * (point(i).p - mean_p);
    power += std::norm(track(i) - mean_q);
  }
  Misreading found;
  found.mirrored = reading.mirrored;
  found.travelled_m = best.travelled_m;
  if (power > 0.0) found.turn_deg = std::arg(cross) * kDegPerRad, found.scale = std::abs(cross) / power;
  double low = point(0).heading_rad, high = low;
  for (std::size_t i = 0; i < count_; ++i) {
    low = std::min(low, point(i).heading_rad), high = std::max(high, point(i).heading_rad);
  }
  found.heading_rad = 0.5 * (low + high), found.heading_span_rad = high - low;
  return found;
}

DisplacementCheck::Verdict DisplacementCheck::evaluate() {
  if (count_ < 5) return Verdict::open;
  double sd_m = 0.0;
  for (std::size_t i = 0; i < count_; ++i) sd_m = std::max(sd_m, point(i).sd_m);
  const double far_m = std::max(kShortest_m, kWaySigmas * sd_m);

  const Fit plain = fit({}, 1.0);
  if (plain.cost < kRatio) {
    times_ = 0;
    return plain.travelled_m >= far_m && 10 * plain.inliers >= 7 * count_ ? Verdict::well : Verdict::open;
  }
  Reading best;
  Fit of_best = plain, of_rotation = plain;
  Reading rotation;
  for (const bool mirrored : {false, true})
    for (const double turn_deg : {0.0, 90.0, 180.0, 270.0})
      for (const double scale : kScales) {
        const Reading reading{mirrored, turn_deg, scale};
        const Fit tried = fit(reading, 1.0);
        if (tried.cost < of_best.cost) best = reading, of_best = tried;
        if (!mirrored && tried.cost < of_rotation.cost) rotation = reading, of_rotation = tried;
      }
  // A mirror that a rotation explains about as well says nothing of its own.
  if (best.mirrored && of_rotation.cost - of_best.cost < kRatio * of_best.noise)
    best = rotation, of_best = of_rotation;
  const double noise = of_best.noise;
  const Fit scaled = fit(best, noise);
  const double scale_way_m = std::max(kScaleWay_m, kScaleWaySigmas * sd_m);
  const double required_m = (best.scale == 1.0 ? far_m : scale_way_m) * std::sqrt(noise);
  bool wrong = !(best == Reading{}) && plain.cost - of_best.cost >= kRatio * noise &&
               10 * scaled.inliers >= (best.scale == 1.0 ? 7 : 8) * count_ &&
               (best.scale == 1.0 || count_ >= 7) && of_best.travelled_m >= required_m;
  double calibrated = std::numeric_limits<double>::infinity();
  for (int turn = -4; wrong && turn <= 4; ++turn)
    for (const double scale : kCalibrations)
      calibrated = std::min(calibrated, fit({false, 10.0 * turn, scale}, noise).cost);
  wrong = wrong && calibrated - scaled.cost >= kRatio;
  if (!wrong) {
    times_ = 0;
    return Verdict::open;
  }
  const Misreading misreading = refined(best, of_best);
  const bool calibration = !misreading.mirrored && std::abs(misreading.turn_deg) < 45.0 &&
                           misreading.scale > 0.6 && misreading.scale < 1.6;
  times_ = calibration ? 0 : times_ > 0 && best == last_best_ ? times_ + 1 : 1;
  last_best_ = best;
  if (times_ < 2 && (calibration || calibrated - scaled.cost < kClearRatio)) return Verdict::open;
  found_ = misreading;
  return Verdict::misread;
}

}  // namespace leadline::nav
