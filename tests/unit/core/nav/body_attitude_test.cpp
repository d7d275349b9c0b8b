#include "core/nav/motion/body_attitude.h"

#include <gtest/gtest.h>

namespace leadline::nav {
namespace {

const Geodetic kPlace{Angle::deg(45.0), Angle::deg(-67.0)};
Time at(double s) { return from_unix(1'491'400'000.0 + s); }  // April 2017

SourceInfo source(SourceId id, Body body = Body::vehicle) {
  SourceInfo info;
  info.id = id;
  info.body = body;
  return info;
}

Envelope said(double t_s, const Message& message, SourceId id = 0) {
  return {.valid = at(t_s), .source = id, .message = message};
}

Heading heading(double deg, HeadingReference reference = HeadingReference::true_north) {
  return {.heading = Angle::deg(deg), .reference = reference};
}

TEST(BodyAttitude, InterpolatesTheShortWayThroughNorth) {
  BodyAttitude attitude(Body::vehicle, nullptr);
  attitude.take(said(0, heading(359)), source(0));
  attitude.take(said(1, heading(3)), source(0));
  EXPECT_NEAR(attitude.at(at(0.5), kPlace).attitude->heading.deg(), 1.0, 1e-9);
  EXPECT_NEAR(attitude.at(at(0.125), kPlace).attitude->heading.deg(), 359.5, 1e-9);
}

TEST(BodyAttitude, AnOldHeadingIsNoHeading) {
  BodyAttitude attitude(Body::vehicle, nullptr);
  EXPECT_FALSE(attitude.at(at(0), kPlace).attitude);
  attitude.take(said(0, heading(10)), source(0));
  EXPECT_TRUE(attitude.at(at(3.0), kPlace).attitude);
  EXPECT_FALSE(attitude.at(at(3.1), kPlace).attitude);
}

TEST(BodyAttitude, MountIsUndone) {
  auto turned = source(0);
  turned.mount.heading = Angle::deg(90);  // built in looking to starboard
  BodyAttitude attitude(Body::vehicle, nullptr);
  attitude.take(said(0, heading(100)), turned);
  attitude.take(said(0, Attitude{.roll = Angle::deg(5), .pitch = Angle()}), turned);
  const auto found = *attitude.at(at(0), kPlace).attitude;
  EXPECT_NEAR(found.heading.deg(), 10.0, 1e-9);
  // The instrument rolls about its own forward axis, which is the body's starboard axis: the body pitches.
  EXPECT_NEAR(found.roll.deg(), 0.0, 1e-9);
  EXPECT_NEAR(found.pitch.deg(), 5.0, 1e-9);
}

TEST(BodyAttitude, TheFirstOfTheConfigurationSpeaksWhileItIsAlive) {
  BodyAttitude attitude(Body::vehicle, nullptr);
  attitude.take(said(0.0, heading(10), 1), source(1));
  EXPECT_NEAR(attitude.at(at(0.0), kPlace).attitude->heading.deg(), 10.0, 1e-9);
  attitude.take(said(0.1, heading(20), 0), source(0));
  attitude.take(said(0.2, heading(10), 1), source(1));
  EXPECT_NEAR(attitude.at(at(0.2), kPlace).attitude->heading.deg(), 20.0, 1e-9);
  attitude.take(said(5.0, heading(10), 1), source(1));  // the first has been silent for 4.9 s
  EXPECT_NEAR(attitude.at(at(5.0), kPlace).attitude->heading.deg(), 10.0, 1e-9);
}

TEST(BodyAttitude, MagneticHeadingsAreTurnedByKeyTelegramOrModel) {
  const auto models = geo::MagneticModel::load(std::string(LEADLINE_BINARY_DIR) + "/magnetic");
  ASSERT_TRUE(models.ok());
  const auto found = [&](const SourceInfo& info, const Heading& h, const geo::MagneticModel* model) {
    BodyAttitude attitude(Body::vehicle, model);
    attitude.take(said(0, h), info);
    return attitude.at(at(0), kPlace).attitude;
  };
  auto magnetic = heading(100, HeadingReference::magnetic_north);
  EXPECT_NEAR(found(source(0), magnetic, &models.value())->heading.deg(), 100.0 - 16.76, 0.1);
  magnetic.variation = Angle::deg(2.0);
  EXPECT_NEAR(found(source(0), magnetic, &models.value())->heading.deg(), 102.0, 1e-9);
  auto with_key = source(0);
  with_key.declination = Angle::deg(-7.8);
  EXPECT_NEAR(found(with_key, magnetic, nullptr)->heading.deg(), 92.2, 1e-9);
}

TEST(BodyAttitude, AMagneticHeadingWithoutDeclinationIsNotTakenForTrue) {
  BodyAttitude attitude(Body::vehicle, nullptr);
  attitude.take(said(0, heading(100, HeadingReference::magnetic_north)), source(0));
  EXPECT_FALSE(attitude.at(at(0), kPlace).attitude);
  EXPECT_TRUE(attitude.lacks_declination());
}

TEST(BodyAttitude, OtherBodiesAreNoneOfItsBusiness) {
  BodyAttitude attitude(Body::vehicle, nullptr);
  attitude.take(said(0, heading(100)), source(0, Body::ship));
  EXPECT_FALSE(attitude.at(at(0), kPlace).attitude);
}

}  // namespace
}  // namespace leadline::nav
