// What the watch says, when it is silent, and that it is a pure function of what it hears.

#include <cmath>
#include <limits>

#include "core/geo/geodesy.h"
#include "tests/unit/core/nav/plausibility/watched_run.h"
#include "tests/unit/core/nav/simulated_survey.h"

namespace leadline {
namespace {

using test::Pcg;

/// A dive made by hand: sources by number, all of the vehicle, 10 Ticks a second.
class Dive {
 public:
  explicit Dive(std::size_t sources) {
    for (std::size_t i = 0; i < sources; ++i) {
      SourceInfo info;
      info.id = static_cast<SourceId>(i);
      info.name = "source" + std::to_string(i);
      heard.sources.push_back(info);
    }
  }
  void tell(double t_s, SourceId source, const Message& message) {
    Envelope envelope;
    for (; tick_s_ <= t_s; tick_s_ += 0.1) {
      envelope.arrival = arrival_at(from_unix(1.7e9 + tick_s_));
      envelope.valid = envelope.arrival.host();
      envelope.message = Tick{envelope.arrival};
      heard.envelopes.push_back(envelope);
    }
    envelope.arrival = arrival_at(from_unix(1.7e9 + t_s));
    envelope.valid = envelope.arrival.host();
    envelope.source = source;
    envelope.message = message;
    heard.envelopes.push_back(envelope);
  }
  test::Heard heard;

 private:
  double tick_s_ = 0.0;
};

DvlVelocity ahead(double speed_mps, double sideways_mps = 0.0) {
  return {.frame = DvlFrame::ship, .x_mps = speed_mps, .y_mps = sideways_mps, .valid = true};
}
GnssFix fix(double north_m, double east_m) {
  return {.position = geo::displaced({Angle::deg(59.0), Angle::deg(5.0)}, north_m, east_m),
          .quality = GnssQuality::autonomous};
}
double rounded(double value, double step) { return std::round(value / step) * step; }

TEST(PlausibilityWatch, AFaultIsSaidOnceAndItsEndOnce) {
  Pcg random(1);
  Dive dive(3);
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.1 * i;
    dive.tell(t, 0, Heading{.heading = Angle::deg(90.0 + random.normal() * 0.2)});
    dive.tell(t, 1, ahead((t < 100.0 ? -1.0 : 1.0) * (1.0 + 0.01 * random.normal()), 0.01 * random.normal()));
    if (i % 10 == 0) dive.tell(t, 2, fix(random.normal(), t + random.normal()));
  }
  const auto findings = test::Watched(dive.heard).findings;
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].level, Health::Level::warning);
  EXPECT_EQ(findings[0].source, "source1");
  EXPECT_NE(findings[0].text.find("moves backward while GNSS moves forward"), std::string::npos)
      << findings[0].text;
  EXPECT_LT(findings[0].t_s, 30.0);
  EXPECT_EQ(findings[1].level, Health::Level::note);
  EXPECT_GT(findings[1].t_s, 100.0);
}

TEST(PlausibilityWatch, SidewaysMotionTellsAMirroredAxisFromATurn) {
  const auto said = [](double x_sign, double y_sign, bool swapped) {
    Pcg random(2);
    Dive dive(3);
    double north = 0.0, east = 0.0;
    for (int i = 0; i < 1200; ++i) {
      const double t = 0.1 * i, heading = 0.3 * std::sin(t / 20.0), x = 1.0, y = 0.8 * std::sin(t / 7.0);
      north += 0.1 * (x * std::cos(heading) - y * std::sin(heading));
      east += 0.1 * (x * std::sin(heading) + y * std::cos(heading));
      dive.tell(t, 0, Heading{.heading = Angle::rad(heading).wrapped_2pi()});
      const double u = x_sign * x + 0.01 * random.normal(), v = y_sign * y + 0.01 * random.normal();
      dive.tell(t, 1, swapped ? ahead(v, u) : ahead(u, v));
      if (i % 10 == 0) dive.tell(t, 2, fix(north + 0.3 * random.normal(), east + 0.3 * random.normal()));
    }
    nav::Options options;
    options.aiding.gnss_drms_m = 0.5;
    const auto findings = test::Watched(dive.heard, {}, options).findings;
    return findings.size() == 1 ? findings[0].text : std::to_string(findings.size()) + " findings";
  };
  EXPECT_EQ(said(1.0, 1.0, false), "0 findings");
  EXPECT_NE(said(1.0, -1.0, false).find("starboard axis is wrong"), std::string::npos)
      << said(1.0, -1.0, false);
  EXPECT_NE(said(-1.0, 1.0, false).find("forward axis is wrong"), std::string::npos)
      << said(-1.0, 1.0, false);
  EXPECT_NE(said(1.0, 1.0, true).find("axes are swapped"), std::string::npos) << said(1.0, 1.0, true);
  EXPECT_NE(said(-1.0, -1.0, false).find("mounted at 180"), std::string::npos) << said(-1.0, -1.0, false);
}

TEST(PlausibilityWatch, AStillVehicleIsNotAccused) {
  Dive dive(6);
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.1 * i;
    dive.tell(t, 0, Heading{.heading = Angle::deg(90.0)});
    dive.tell(t, 1, ahead(0.0));
    dive.tell(t, 2, DepthMeasured{Depth{3.2}});
    dive.tell(t, 3, Attitude{.roll = Angle::deg(0.5), .pitch = Angle::deg(-1.0)});
    if (i % 10 == 0) dive.tell(t, 4, fix(0.0, 0.0));
    dive.tell(t, 5, SoundSpeed{1500.0});
  }
  EXPECT_TRUE(test::Watched(dive.heard).findings.empty());
}

TEST(PlausibilityWatch, CoarseValuesOfASteadyRunAreNotAccused) {
  Pcg random(3);
  Dive dive(6);
  for (int i = 0; i < 6000; ++i) {  // dives for 60 s, then runs level, straight and fast
    const double t = 0.1 * i;
    dive.tell(t, 0, Heading{.heading = Angle::deg(rounded(90.2 + 0.1 * random.normal(), 1.0))});
    dive.tell(t, 1, ahead(1.5 + 0.01 * random.normal()));
    dive.tell(t, 2, DepthMeasured{Depth{rounded(std::min(0.3 * t, 18.0) + 0.01 * random.normal(), 0.1)}});
    dive.tell(t, 3,
              Attitude{.roll = Angle::deg(rounded(0.1 * random.normal(), 0.5)), .pitch = Angle::deg(0.0)});
    if (i % 10 == 0) dive.tell(t, 4, fix(random.normal(), 1.5 * t + random.normal()));
    dive.tell(t, 5, SoundSpeed{1500.0});
  }
  const auto findings = test::Watched(dive.heard).findings;
  for (const auto& f : findings) ADD_FAILURE() << f.t_s << " s " << f.source << ": " << f.text;
}

TEST(PlausibilityWatch, TheSameIsSaidOfTheSame) {
  auto scenario = test::scenario("mount-calibration");
  scenario.options.duration_s = 60.0;
  const auto heard = test::simulated(scenario, 7);
  const test::Watched once(heard), again(heard);
  ASSERT_FALSE(once.findings.empty());
  ASSERT_EQ(once.findings.size(), again.findings.size());
  for (std::size_t i = 0; i < once.findings.size(); ++i) {
    EXPECT_EQ(once.findings[i].t_s, again.findings[i].t_s);
    EXPECT_EQ(once.findings[i].text, again.findings[i].text);
  }
}

TEST(PlausibilityWatch, NumbersThatAreNoneAreNotJudged) {
  const double wild[] = {std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity(),
                         1.7e308,
                         -1.7e308,
                         5e-324,
                         0.0,
                         -32768.0};
  Pcg random(4);
  const auto any = [&] { return random.uniform() < 0.3 ? wild[random.next() % 8] : random.normal(); };
  const auto angle = [&] { return Angle::rad(any()); };
  Dive dive(4);
  for (int i = 0; i < 8000; ++i) {
    const double t = 0.02 * i;
    const auto source = static_cast<SourceId>(random.next() % 4);
    switch (random.next() % 12) {
      case 0:
        dive.tell(t, source, GnssFix{.position = {angle(), angle()}});
        break;
      case 1:
        dive.tell(t, source, Course{.speed_mps = any(), .course = angle()});
        break;
      case 2:
        dive.tell(t, source, Heading{.heading = angle()});
        break;
      case 3:
        dive.tell(t, source, Attitude{.roll = angle(), .pitch = angle()});
        break;
      case 4:
        dive.tell(t, source, Rates{any()});
        break;
      case 5:
        dive.tell(t, source, ImuSample{.gyro = {any(), any(), any()}, .accel = {any(), any(), any()}});
        break;
      case 6:
        dive.tell(t, source, ahead(any(), any()));
        break;
      case 7:
        dive.tell(t, source, AltitudeAboveBottom{any()});
        break;
      case 8:
        dive.tell(t, source, DepthMeasured{Depth{any()}});
        break;
      case 9:
        dive.tell(t, source, Pressure{any()});
        break;
      case 10:
        dive.tell(t, source, UsblRelative{.x_m = any(), .y_m = any(), .down_m = any()});
        break;
      default:
        dive.tell(t, source, UsblGeographic{.position = {angle(), angle()}, .depth = Depth{any()}});
        break;
    }
  }
  for (const auto& f : test::Watched(dive.heard).findings)
    EXPECT_EQ(f.text.find("nan"), std::string::npos) << f.text;
}

}  // namespace
}  // namespace leadline
