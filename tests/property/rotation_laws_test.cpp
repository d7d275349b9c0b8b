// The laws every pair of frames keeps, with random attitudes, and what must not compile.

#include <gtest/gtest.h>

#include <random>

#include "core/types/rotation.h"

namespace leadline {
namespace {

template <class A, class B>
concept Multiplies = requires(A a, B b) {
  a* b;
};
template <class A, class B>
concept Adds = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Converts = requires(A a) {
  B{a};
};

using NedFromBody = Rotation<Ned, BodyFrame>;
using BodyFromInstrument = Rotation<BodyFrame, Instrument>;

static_assert(Multiplies<NedFromBody, BodyFromInstrument>);
static_assert(Multiplies<NedFromBody, Vec3<BodyFrame>>);
static_assert(!Multiplies<NedFromBody, Vec3<Ned>>, "a vector that is in NED already");
static_assert(!Multiplies<NedFromBody, Vec3<Instrument>>, "the mount is left out");
static_assert(!Multiplies<BodyFromInstrument, NedFromBody>, "the wrong order");
static_assert(!Multiplies<NedFromBody, NedFromBody>, "an attitude applied twice");
static_assert(Adds<Vec3<Ned>, Vec3<Ned>>);
static_assert(!Adds<Vec3<Ned>, Vec3<BodyFrame>>);
static_assert(!Converts<Vec3<Ned>, Vec3<BodyFrame>>);
static_assert(!Converts<NedFromBody, BodyFromInstrument>);

constexpr int kRounds = 20'000;

class RotationLaws : public testing::Test {
 protected:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  template <class To, class From>
  Rotation<To, From> attitude() {
    return Rotation<To, From>::zyx({Angle::rad(uniform(-kPi, kPi)), Angle::rad(uniform(-kPi / 2, kPi / 2)),
                                    Angle::rad(uniform(0, 2 * kPi))});
  }
  Vec3<Instrument> vector() { return {uniform(-1e3, 1e3), uniform(-1e3, 1e3), uniform(-1e3, 1e3)}; }
  static double difference(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    return (a - b).cwiseAbs().maxCoeff();
  }

 private:
  std::mt19937_64 random_{20260722};
};

TEST_F(RotationLaws, ARotationAndItsInverseIsIdentity) {
  for (int i = 0; i < kRounds; ++i) {
    const auto r = attitude<Ned, BodyFrame>();
    ASSERT_LT(difference((r * r.inverse()).matrix(), Eigen::Matrix3d::Identity()), 1e-15 * 4);
    ASSERT_LT(difference((r.inverse() * r).matrix(), Eigen::Matrix3d::Identity()), 1e-15 * 4);
    ASSERT_EQ(r.inverse().inverse().matrix(), r.matrix());
  }
}

TEST_F(RotationLaws, NormsAndAnglesBetweenVectorsAreKept) {
  for (int i = 0; i < kRounds; ++i) {
    const auto r = attitude<BodyFrame, Instrument>();
    const auto v = vector(), w = vector();
    ASSERT_NEAR((r * v).eigen().norm(), v.eigen().norm(), 1e-12 * v.eigen().norm());
    ASSERT_NEAR((r * v).eigen().dot((r * w).eigen()), v.eigen().dot(w.eigen()), 1e-9);
  }
}

TEST_F(RotationLaws, CompositionIsOneAfterTheOther) {
  for (int i = 0; i < kRounds; ++i) {
    const auto attitude_nb = attitude<Ned, BodyFrame>();
    const auto mount = attitude<BodyFrame, Instrument>();
    const auto v = vector();
    ASSERT_LT(((attitude_nb * mount) * v - attitude_nb * (mount * v)).eigen().norm(), 1e-11);
    ASSERT_LT(difference((attitude_nb * mount).inverse().matrix(),
                         (mount.inverse() * attitude_nb.inverse()).matrix()),
              1e-15);
  }
}

TEST_F(RotationLaws, RotationIsLinear) {
  for (int i = 0; i < kRounds; ++i) {
    const auto r = attitude<Ned, Instrument>();
    const auto v = vector(), w = vector();
    const double k = uniform(-3, 3);
    ASSERT_LT((r * (v + w * k) - (r * v + (r * w) * k)).eigen().norm(), 1e-11);
  }
}

TEST_F(RotationLaws, EulerAnglesNameTheSameRotation) {
  for (int i = 0; i < kRounds; ++i) {
    const auto r = attitude<Ned, BodyFrame>();
    ASSERT_LT(difference(NedFromBody::zyx(r.euler()).matrix(), r.matrix()), 1e-9);
  }
}

}  // namespace
}  // namespace leadline
