// Wrong instruments are named within 60 s of motion, frozen ones within 6 s, in 20 dives each.

#include <cmath>
#include <limits>
#include <map>

#include "tests/unit/core/nav/plausibility/watched_run.h"

namespace leadline {
namespace {

using test::Heard;
using test::Tamper;

constexpr std::uint64_t kSeeds = 20;

/// The dives of one scenario, simulated once; its options beside.
struct Dives {
  nav::Options options;
  std::vector<Heard> heard;
};
const Dives& dives(const std::string& name, double duration_s) {
  static std::map<std::string, Dives> kept;
  Dives& found = kept[name];
  if (!found.heard.empty()) return found;
  auto scenario = test::scenario(name == "turning" ? "mine-disposal" : name);
  scenario.options.duration_s = duration_s;
  if (name == "turning")
    scenario.vehicle->body.weave_deg = 15.0, scenario.vehicle->body.weave_period_s = 25.0;
  for (auto& sensor : scenario.sensors)
    if (name == "mount-calibration" && sensor.options.name == "dvl") sensor.mount_error = {};
  found.options = test::options_of(scenario);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) found.heard.push_back(test::simulated(scenario, seed));
  return found;
}
const Dives& mine() { return dives("mine-disposal", 75.0); }
/// The mine dive in a weave of 15 degrees.
const Dives& turning() { return dives("turning", 75.0); }
const Dives& surface() { return dives("mount-calibration", 75.0); }
const Dives& hover() { return dives("hover-run", 60.0); }
const Dives& deep() { return dives("deep-survey", 75.0); }

/// What a fault makes of the velocity in the instrument's axes.
Tamper velocity(const std::function<void(double& x, double& y)>& fault) {
  return [fault](Envelope& envelope, double) {
    auto* dvl = std::get_if<DvlVelocity>(&envelope.message);
    if (dvl == nullptr || !dvl->valid) return;
    const Angle turned = dvl->frame == DvlFrame::earth && dvl->applied ? dvl->applied->heading : Angle();
    double x = dvl->x_mps * cos(turned) + dvl->y_mps * sin(turned);
    double y = dvl->y_mps * cos(turned) - dvl->x_mps * sin(turned);
    fault(x, y);
    dvl->x_mps = x * cos(turned) - y * sin(turned);
    dvl->y_mps = x * sin(turned) + y * cos(turned);
  };
}
template <class Fact>
Tamper changed(const std::string& source, const Heard& of, const std::function<void(Fact&)>& fault) {
  const SourceId id = of.source(source);
  return [id, fault](Envelope& envelope, double) {
    if (auto* fact = std::get_if<Fact>(&envelope.message); fact && envelope.source == id) fault(*fact);
  };
}
template <class Fact>
Tamper frozen(const std::string& source, const Heard& of, double from_s) {
  const SourceId id = of.source(source);
  auto last = std::make_shared<std::optional<Fact>>();
  return [id, last, from_s](Envelope& envelope, double t_s) {
    auto* fact = std::get_if<Fact>(&envelope.message);
    if (fact == nullptr || envelope.source != id) return;
    if constexpr (std::is_same_v<Fact, DvlVelocity>)
      if (!fact->valid) return;
    if (t_s >= from_s && *last)
      *fact = **last;
    else
      *last = *fact;
  };
}

/// In every dive the source is named in time, and nobody else is.
void expect_named(const char* fault, const Dives& dives, const std::function<Tamper(const Heard&)>& tamper,
                  const std::string& source, const std::string& word, double from_s = 0.0,
                  double within_s = 60.0) {
  double worst_s = 0.0, sum_s = 0.0;
  std::string text;
  for (std::size_t i = 0; i < dives.heard.size(); ++i) {
    const test::Watched watched(dives.heard[i], tamper(dives.heard[i]), dives.options);
    const auto named_s = watched.named_s(source, word);
    EXPECT_TRUE(named_s) << fault << ", seed " << i + 1;
    for (const auto& f : watched.findings) {
      EXPECT_EQ(f.source, source) << fault << ", seed " << i + 1 << " " << f.t_s << " s: " << f.text;
      if (f.level == Health::Level::warning) text = f.text;
    }
    if (!named_s) continue;
    EXPECT_GE(*named_s, from_s);
    worst_s = std::max(worst_s, *named_s - from_s);
    sum_s += *named_s - from_s;
  }
  std::printf("%-44s mean %4.1f s, worst %4.1f s  %s: %s\n", fault, sum_s / static_cast<double>(kSeeds),
              worst_s, source.c_str(), text.c_str());
  EXPECT_LE(worst_s, within_s) << fault;
}

void expect_dvl_named(const char* name, const Dives& where) {
  const auto as = [](const std::function<void(double&, double&)>& fault) {
    return [fault](const Heard&) { return velocity(fault); };
  };
  const auto called = [&](const char* fault) { return std::string(name) + ": " + fault; };
  expect_named(called("DVL sign").c_str(), where, as([](double& x, double& y) { x = -x, y = -y; }), "dvl",
               "mounted at 180 deg");
  expect_named(called("DVL axes swapped").c_str(), where, as([](double& x, double& y) { std::swap(x, y); }),
               "dvl", "axes are swapped");
  expect_named(called("DVL turned by 90 deg").c_str(), where,
               as([](double& x, double& y) { std::swap(x, y), x = -x; }), "dvl", "mounted turned");
  expect_named(called("DVL in feet").c_str(), where,
               as([](double& x, double& y) { x /= 0.3048, y /= 0.3048; }), "dvl", "feet read as metres");
}

TEST(PlausibilityOfADvl, AtTheSurfaceUnderGnss) { expect_dvl_named("surface", surface()); }
TEST(PlausibilityOfADvl, HoveringAtAThirdOfAMetreASecond) { expect_dvl_named("hover", hover()); }
TEST(PlausibilityOfADvl, UnderUsblWithOutliers) { expect_dvl_named("mine", mine()); }
TEST(PlausibilityOfADvl, AtHalfAMetreASecondUnderAFixEveryEightSeconds) {
  expect_named(
      "deep: DVL sign", deep(),
      [](const Heard&) { return velocity([](double& x, double& y) { x = -x, y = -y; }); }, "dvl",
      "mounted at 180 deg", 0.0, 62.1);  // the fix of the sixtieth second is heard 2 s later
}

TEST(PlausibilityOfUnits, RadiansAndDegrees) {
  const auto heading = [](const std::function<Angle(Angle)>& fault) {
    return [fault](const Heard& heard) {
      return changed<Heading>("ahrs", heard, [fault](Heading& h) { h.heading = fault(h.heading); });
    };
  };
  for (const auto* where : {&mine(), &turning()}) {
    const char* name = where == &mine() ? "mine" : "turning";
    const auto called = [&](const char* fault) { return std::string(name) + ": " + fault; };
    expect_named(called("heading in radians").c_str(), *where,
                 heading([](Angle a) { return Angle::deg(a.rad()); }), "ahrs",
                 "in radians and read as degrees");
  }
  expect_named("turning: heading in degrees as radians", turning(),
               heading([](Angle a) { return Angle::rad(a.deg()).wrapped_2pi(); }), "ahrs",
               "in degrees and read as radians");
  const auto tilts = [](double factor) {
    return [factor](const Heard& heard) {
      return changed<Attitude>(
          "ahrs", heard, [factor](Attitude& a) { a.roll = a.roll * factor, a.pitch = a.pitch * factor; });
    };
  };
  expect_named("mine: tilts in radians", mine(), tilts(kRadPerDeg), "ahrs", "in radians and read as degrees");
  expect_named("mine: tilts in degrees as radians", mine(), tilts(kDegPerRad), "ahrs",
               "in degrees and read as radians");
  const auto rates = [](double factor) {
    return [factor](const Heard& heard) {
      return changed<Rates>("ahrs", heard, [factor](Rates& r) { r.rate_z_rps *= factor; });
    };
  };
  expect_named("turning: turn rate in radians", turning(), rates(kRadPerDeg), "ahrs", "57 times less");
  expect_named("turning: turn rate in degrees as radians", turning(), rates(kDegPerRad), "ahrs",
               "57 times more");
  expect_named("turning: turn rate with a wrong sign", turning(), rates(-1.0), "ahrs", "sign is wrong");
}

TEST(PlausibilityOfUnits, FeetForMetres) {
  expect_named(
      "mine: depth in feet", mine(),
      [](const Heard& heard) {
        return changed<DepthMeasured>("depth", heard, [](DepthMeasured& d) { d.depth.m /= 0.3048; });
      },
      "depth", "feet read as metres");
  expect_named(
      "mine: altitude in feet", mine(),
      [](const Heard& heard) {
        return changed<AltitudeAboveBottom>("dvl", heard,
                                            [](AltitudeAboveBottom& a) { a.above_bottom_m /= 0.3048; });
      },
      "dvl", "feet read as metres");
}

TEST(PlausibilityOfFrozenValues, EachIsNamedWithinSixSeconds) {
  constexpr double kFrom = 40.0, kWithin = 6.3;
  const auto freeze = [&]<class Fact>(Fact, const char* source) {
    return [source](const Heard& heard) { return frozen<Fact>(source, heard, kFrom); };
  };
  expect_named("mine: heading frozen", mine(), freeze(Heading{}, "ahrs"), "ahrs", "heading is frozen", kFrom,
               kWithin);
  expect_named("mine: tilts frozen", mine(), freeze(Attitude{}, "ahrs"), "ahrs", "roll and pitch is frozen",
               kFrom, kWithin);
  expect_named("mine: depth frozen", mine(), freeze(DepthMeasured{}, "depth"), "depth", "depth is frozen",
               kFrom, kWithin);
  expect_named("deep: heading frozen", deep(), freeze(Heading{}, "ahrs"), "ahrs", "heading is frozen", kFrom,
               kWithin);
  expect_named("deep: depth frozen", deep(), freeze(DepthMeasured{}, "depth"), "depth", "depth is frozen",
               kFrom, kWithin);
  expect_named("surface: GNSS frozen", surface(), freeze(GnssFix{}, "gnss"), "gnss", "position is frozen",
               kFrom, kWithin);
  expect_named("hover: GNSS frozen", hover(), freeze(GnssFix{}, "gps"), "gps", "position is frozen", kFrom,
               kWithin);
  expect_named("surface: DVL frozen", surface(), freeze(DvlVelocity{}, "dvl"), "dvl", "bottom is frozen",
               kFrom, kWithin);
}

}  // namespace
}  // namespace leadline
