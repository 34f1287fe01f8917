#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "estimators/multipath/odometry_sum.hpp"
#include "multipath_localization/core/random.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {
namespace {

const OdometryNoise kNoise = {0.005, 0.002, 0.03, 0.004, 1.5e-4, 2e-5};

/// Two seconds of a winding way, sideways too.
std::vector<OdometryIncrement> way() {
  std::vector<OdometryIncrement> all;
  for (int i = 1; i <= 100; ++i) {
    all.push_back({0.02 * i, 0.02, 2.0 + 0.5 * std::sin(0.1 * i), 0.6 * std::cos(0.05 * i), 0.2});
  }
  return all;
}

OdometrySum sum_with(const OdometryErrors& errors) {
  OdometrySum sum(kNoise);
  sum.restart(errors);
  for (const OdometryIncrement& u : way()) sum.add(u);
  return sum;
}

Eigen::Vector3d motion(const OdometrySum& sum) {
  return {sum.displacement().x(), sum.displacement().y(), sum.turn()};
}

TEST(OdometrySum, IsTheWayOfTheIncrementsWithoutErrors) {
  Pose2 pose;
  for (const OdometryIncrement& u : way()) pose = pose * displacement(u);
  EXPECT_LT((motion(sum_with({})) - Eigen::Vector3d(pose.x, pose.y, pose.yaw)).norm(), 1e-9);
}

TEST(OdometrySum, KnowsItsDerivativesByTheErrors) {
  const OdometryErrors at{0.02, 0.003, -0.05, 0.01};
  const OdometrySum sum = sum_with(at);
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 4; ++k) {
    OdometryErrors up = at;
    OdometryErrors down = at;
    (k == 0 ? up.scale : k == 1 ? up.gyro_bias : k == 2 ? up.turn_scale : up.curvature) += kStep;
    (k == 0 ? down.scale : k == 1 ? down.gyro_bias : k == 2 ? down.turn_scale : down.curvature) -= kStep;
    const Eigen::Vector3d numerical = (motion(sum_with(up)) - motion(sum_with(down))) / (2.0 * kStep);
    // The chord of an arc hardly depends on its turn, which is left out.
    EXPECT_LT((sum.by_errors().col(k) - numerical).norm(), 2e-3 * (1.0 + numerical.norm())) << k;
  }
}

/// Fixes that know the way to be straight would else say that measured turns are none.
TEST(OdometrySum, TellsNothingOfTheScaleOfTurnsByNoise) {
  RandomStream random(1, 1, 1);
  OdometrySum sum(kNoise);
  for (int i = 1; i <= 50; ++i) sum.add({0.02 * i, 0.02, 3.0, 0.005 * random.normal()});
  EXPECT_EQ(sum.by_errors().col(2).norm(), 0.0);
  EXPECT_NE(sum.turn(), 0.0);
  for (int i = 51; i <= 100; ++i) sum.add({0.02 * i, 0.02, 3.0, 0.2});
  EXPECT_NEAR(sum.by_errors()(2, 2), -0.2, 0.02);
}

TEST(OdometrySum, TakesTurnsOfAGyroWithItsErrorsAloneAndNoneOfTheWheels) {
  OdometrySum sum(kNoise);
  sum.restart({0.0, 0.1, 0.2, 0.3, 0.01});
  for (int i = 1; i <= 50; ++i) {
    OdometryIncrement u{0.02 * i, 0.02, 1.0, 0.5};
    u.turn_source = TurnSource::kGyro;
    sum.add(u);
  }
  EXPECT_NEAR(sum.turn(), 0.5 - 0.01, 1e-9);
  EXPECT_EQ(sum.by_errors().row(2).head<4>(), Eigen::RowVector4d::Zero());
  EXPECT_NEAR(sum.by_errors()(2, 4), -1.0, 1e-9);
  EXPECT_TRUE(sum.turns_by_gyro());
  EXPECT_EQ(sum.noise().total({0.0, 1.0, 0.0})(2, 2), sum.noise().total({0.0, 0.0, 0.0})(2, 2));
  EXPECT_GT(sum.noise().total({0.0, 0.0, 1.0})(2, 2), 0.0);
  sum.add({1.02, 0.02, 1.0, 0.5});
  EXPECT_FALSE(sum.turns_by_gyro());
}

TEST(OdometrySum, HearsOfAStandingGyroWhatItsBiasIs) {
  OdometrySum sum(kNoise);
  for (int i = 1; i <= 50; ++i) {
    OdometryIncrement u{0.1 * i, 0.1, 0.0, 0.0};
    u.rate_at_rest = 0.01 + (i % 2 == 0 ? 0.002 : -0.002);
    sum.add(u);
  }
  EXPECT_NEAR(sum.gyro_at_rest().time, 5.0, 1e-9);
  EXPECT_NEAR(sum.gyro_at_rest().rate(), 0.01, 1e-9);
}

TEST(OdometrySum, OfAParkedRobotIsTimeAlone) {
  OdometrySum sum(kNoise);
  for (int i = 1; i <= 50; ++i) sum.add({0.1 * i, 0.1, 0.0, 0.0});
  EXPECT_NEAR(sum.duration(), 5.0, 1e-9);
  EXPECT_EQ(sum.moving_time(), 0.0);
  EXPECT_EQ(motion(sum), Eigen::Vector3d::Zero());
  EXPECT_EQ(sum.noise().total({}).norm(), 0.0);
}

TEST(OdometrySum, HasTheNoiseOfItsParametersTimesTheFactors) {
  OdometrySum sum(kNoise);
  for (int i = 1; i <= 500; ++i) sum.add({0.02 * i, 0.02, 2.0, 0.0});
  const Eigen::Matrix3d way_only = sum.noise().total({4.0, 0.0, 0.0}) - sum.noise().total({0.0, 0.0, 0.0});
  EXPECT_NEAR(way_only(0, 0), 4.0 * square(0.005) * 20.0, 1e-12);
  EXPECT_LT(way_only(1, 1), way_only(0, 0));
  const Eigen::Matrix3d turn_only = sum.noise().total({0.0, 9.0, 0.0}) - sum.noise().total({0.0, 0.0, 0.0});
  EXPECT_NEAR(turn_only(2, 2), 9.0 * square(0.002) * 10.0, 1e-12);
}

TEST(OdometrySum, IsAsUnsureOfATurnThatTicksTellOfAsOfASteadyOne) {
  OdometrySum steady{OdometryNoise{}};
  OdometrySum ticks{OdometryNoise{}};
  for (int i = 1; i <= 100; ++i) {
    steady.add({0.01 * i, 0.01, 0.2, 0.0});
    ticks.add({0.01 * i, 0.01, i % 10 == 0 ? 2.0 : 0.0, 0.0});
  }
  EXPECT_NEAR(ticks.moving_time(), steady.moving_time(), 1e-9);
  EXPECT_NEAR(ticks.noise().total({})(2, 2), steady.noise().total({})(2, 2), 1e-12);
}

TEST(OdometrySum, IsLessSureOfCoarseSamplesThanOfFineOnes) {
  const auto spread = [](double step) {
    OdometrySum sum(kNoise);
    for (double t = step; t < 10.0; t += step) sum.add({t, step, 5.0 + std::sin(t), 0.3});
    return sum.noise().total({0.0, 0.0, 0.0}).topLeftCorner<2, 2>().trace();
  };
  EXPECT_GT(spread(1.0), 100.0 * spread(0.02));
}

TEST(OdometrySum, MayHaveTurnedWhereOdometryHasNeverToldOfATurn) {
  OdometrySum sum(kNoise);
  sum.restart({});
  sum.add({1.0, 1.0, 2.0, 0.0});
  EXPECT_GT(std::sqrt(sum.noise().untold_turns()(2, 2)), 0.3);
  sum.restart({});
  sum.add({1.5, 0.5, 2.0, 0.1});
  sum.add({2.5, 1.0, 2.0, 0.0});
  EXPECT_EQ(sum.noise().untold_turns().norm(), 0.0);
  sum.restart({});
  sum.add({3.5, 1.0, 2.0, 0.0});
  EXPECT_EQ(sum.noise().untold_turns().norm(), 0.0) << "it has told of one before";
}

TEST(OdometrySum, MayHaveGoneAnywhereInAGap) {
  OdometrySum sum(kNoise);
  sum.add({10.0, 10.0, 2.0, 0.0});
  EXPECT_NEAR(sum.missing_time(), 10.0, 1e-12);
  EXPECT_GT(std::sqrt(sum.noise().total({0.0, 0.0, 0.0})(1, 1)), 5.0);
}

}  // namespace
}  // namespace multipath_localization::multipath
