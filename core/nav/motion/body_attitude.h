#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/flow/source_info.h"
#include "core/geo/magnetic.h"
#include "core/nav/motion/preferred.h"

namespace leadline::nav {

/// Values with times, the newest few of them: interpolated between, held for a while behind the newest.
template <class Value>
class RecentValues {
 public:
  void add(Time t, const Value& value) {
    if (count_ > 0 && t <= newest().t) return;  // order is by time: a late one is of no use to the next ping
    entries_[(first_ + count_) % kSize] = {t, value};
    if (count_ < kSize)
      ++count_;
    else
      first_ = (first_ + 1) % kSize;
  }

  struct Around {
    const Value *before, *after;
    double fraction;  ///< of the way from before to after
  };
  /// Empty when nothing is known or the newest is older than `hold_s`.
  [[nodiscard]] std::optional<Around> at(Time t, double hold_s) const {
    if (count_ == 0) return std::nullopt;
    if (t >= newest().t) {
      if (seconds(t - newest().t) > hold_s) return std::nullopt;
      return Around{&newest().value, &newest().value, 0.0};
    }
    for (std::size_t i = count_ - 1; i-- > 0;) {
      const Entry &a = entry(i), &b = entry(i + 1);
      if (a.t <= t) return Around{&a.value, &b.value, seconds(t - a.t) / seconds(b.t - a.t)};
    }
    if (seconds(entry(0).t - t) > hold_s) return std::nullopt;
    return Around{&entry(0).value, &entry(0).value, 0.0};
  }

 private:
  struct Entry {
    Time t;
    Value value{};
  };
  static constexpr std::size_t kSize = 64;
  [[nodiscard]] const Entry& entry(std::size_t i) const { return entries_[(first_ + i) % kSize]; }
  [[nodiscard]] const Entry& newest() const { return entry(count_ - 1); }

  std::array<Entry, kSize> entries_{};
  std::size_t first_ = 0, count_ = 0;
};

/// Roll, pitch and true heading of one body from whatever compasses, gyros and inclinometers it carries:
/// mounts undone, magnetic headings turned by the declination of place and date, interpolated to the time
/// asked for.
class BodyAttitude {
 public:
  /// How long a value serves behind its time.
  static constexpr double kHoldS = 3.0;

  /// magnetic may be null: magnetic headings then need a declination of their own.
  BodyAttitude(Body body, const geo::MagneticModel* magnetic) : body_(body), magnetic_(magnetic) {}

  /// Takes Heading and Attitude of this body's sources; others are none of its business.
  void take(const Envelope& envelope, const SourceInfo& source);

  struct Estimate {
    std::optional<EulerAngles>
        attitude;  ///< empty without a heading; tilts are 0 where no inclinometer speaks
    bool tilts_known = false;
    std::optional<Angle> sd_heading;
  };
  /// At a time and place (for the declination).
  [[nodiscard]] Estimate at(Time t, const Geodetic& place);

  /// A magnetic heading could not be turned: no declination is known here and now.
  [[nodiscard]] bool lacks_declination() const { return lacks_declination_; }
  /// The declination of the model was asked for outside its years.
  [[nodiscard]] bool outside_model() const { return outside_model_; }

 private:
  struct HeadingSample {
    Angle heading;
    bool magnetic = false;
    std::optional<Angle> variation;  ///< already known for this heading: the source's or the telegram's
    std::optional<Angle> sd;
  };
  struct Tilts {
    Angle roll, pitch;
  };
  [[nodiscard]] std::optional<Angle> true_heading(const HeadingSample& sample, Time t, const Geodetic& place);

  Body body_;
  const geo::MagneticModel* magnetic_;
  Preferred heading_source_, tilt_source_;
  RecentValues<HeadingSample> headings_;
  RecentValues<Tilts> tilts_;
  bool lacks_declination_ = false, outside_model_ = false;

  struct {  // the declination changes by 0.01 degree in kilometres and weeks: asked for again after that
    bool known = false;
    Geodetic place;
    Time t;
    Angle east;
  } declination_;
};

}  // namespace leadline::nav
