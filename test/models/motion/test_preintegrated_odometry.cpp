#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;

/// Forward, in reverse, sideways and at rest, with a yaw rate of its own at each step.
std::vector<OdometryIncrement> random_increments(std::uint64_t seed, int count) {
  std::vector<OdometryIncrement> increments;
  for (int i = 0; i < count; ++i) {
    RandomStream random(seed, static_cast<std::uint32_t>(i), 0);
    const bool rests = random.uniform() < 0.1;
    const double speed = rests ? 0.0 : 1.0 + 1.5 * random.normal();
    const double yaw_rate = rests ? 0.0 : 0.8 * random.normal();
    const double lateral_speed = rests ? 0.0 : 0.7 * random.normal();
    increments.push_back({kStep * (i + 1), kStep, speed, yaw_rate, lateral_speed});
  }
  return increments;
}

/// Step by step, the errors of the odometer taken out of each.
Pose2 composed(const std::vector<OdometryIncrement>& increments, const OdometerErrors& errors) {
  Pose2 pose;
  for (const OdometryIncrement& u : increments) {
    if (!standing(u)) pose = moved(pose, u, errors);
  }
  return pose;
}

PreintegratedOdometry summed(const std::vector<OdometryIncrement>& increments, const OdometerErrors& at,
                             const OdometryNoise& noise = {}) {
  PreintegratedOdometry odometry(noise);
  odometry.restart(at.speed_scale, at.gyro_bias);
  for (const OdometryIncrement& u : increments) odometry.add(u);
  return odometry;
}

/// What chords taken as long as their arcs are off at most.
double arc_to_chord(const std::vector<OdometryIncrement>& increments) {
  double sum = 0.0;
  for (const OdometryIncrement& u : increments) {
    const double turn = (std::abs(u.yaw_rate) + 0.05) * u.duration;
    sum += ground_speed(u) * u.duration * turn * turn / 24.0;
  }
  return sum;
}

TEST(PreintegratedOdometry, EqualsTheCompositionOfItsSteps) {
  const OdometerErrors errors{0.03, -0.02};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto increments = random_increments(seed, 60);
    const PreintegratedOdometry odometry = summed(increments, errors);
    const Pose2 expected = composed(increments, errors);
    const Eigen::Vector2d d = odometry.displacement(errors.speed_scale, errors.gyro_bias);
    EXPECT_LT((d - expected.position()).norm(), 1.1 * arc_to_chord(increments));
    EXPECT_NEAR(angle_difference(odometry.turn(errors.gyro_bias), expected.yaw), 0.0, 1e-12);
    EXPECT_NEAR(odometry.duration(), 60 * kStep, 1e-12);
  }
}

TEST(PreintegratedOdometry, DerivativesAreCentralDifferencesOfTheComposition) {
  const OdometerErrors at{-0.02, 0.01};
  constexpr double kDelta = 1e-5;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto increments = random_increments(seed, 60);
    const PreintegratedOdometry odometry = summed(increments, at);
    const auto difference = [&](double scale, double gyro_bias) -> Eigen::Vector3d {
      const Pose2 high = composed(increments, {at.speed_scale + scale, at.gyro_bias + gyro_bias});
      const Pose2 low = composed(increments, {at.speed_scale - scale, at.gyro_bias - gyro_bias});
      return Eigen::Vector3d(high.x - low.x, high.y - low.y, angle_difference(high.yaw, low.yaw)) /
             (2.0 * kDelta);
    };
    const Eigen::Vector3d by_scale = difference(kDelta, 0.0);
    const Eigen::Vector3d by_gyro_bias = difference(0.0, kDelta);
    EXPECT_LT((odometry.by_scale() - by_scale.head<2>()).norm(), 1e-3);
    EXPECT_LT((odometry.by_gyro_bias() - by_gyro_bias.head<2>()).norm(), 1e-3);
    EXPECT_NEAR(by_gyro_bias.z(), -odometry.moving_time(), 1e-6);
  }
}

TEST(PreintegratedOdometry, ConstantsOfAHypothesisCountToFirstOrder) {
  const OdometerErrors at{0.0, 0.0};
  const auto increments = random_increments(3, 60);
  const PreintegratedOdometry odometry = summed(increments, at);
  const auto error = [&](double factor) {
    const OdometerErrors other{0.2 * factor, 0.1 * factor};
    const Pose2 expected = composed(increments, other);
    EXPECT_NEAR(angle_difference(odometry.turn(other.gyro_bias), expected.yaw), 0.0, 1e-12);
    return (odometry.displacement(other.speed_scale, other.gyro_bias) - expected.position()).norm();
  };
  EXPECT_LT(error(0.1), 1e-3);
  EXPECT_NEAR(error(1.0) / error(0.5), 4.0, 0.8);  // what is left out is of second order
}

TEST(PreintegratedOdometry, NothingMovesOrDiffusesWhenStanding) {
  PreintegratedOdometry odometry{OdometryNoise{}};
  odometry.restart(0.01, 0.02);
  for (int i = 0; i < 500; ++i) odometry.add({kStep * i, kStep, 0.0, 0.0});
  EXPECT_EQ(odometry.displacement(0.05, -0.1), Eigen::Vector2d::Zero());
  EXPECT_EQ(odometry.turn(-0.1), 0.0);
  EXPECT_EQ(odometry.covariance(), Eigen::Matrix3d::Zero());
  EXPECT_EQ(odometry.moving_time(), 0.0);
  EXPECT_NEAR(odometry.duration(), 10.0, 1e-9);
}

TEST(PreintegratedOdometry, TurningOnTheSpotTurns) {
  const OdometryNoise noise;
  PreintegratedOdometry odometry(noise);
  for (int i = 0; i < 50; ++i) odometry.add({kStep * i, kStep, 0.0, 0.7});
  EXPECT_NEAR(odometry.turn(0.0), 0.7, 1e-12);
  EXPECT_NEAR(odometry.turn(0.1), 0.6, 1e-12);
  EXPECT_EQ(odometry.displacement(0.1, 0.1), Eigen::Vector2d::Zero());
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  expected(2, 2) = noise.yaw * noise.yaw;
  EXPECT_LT((odometry.covariance() - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PreintegratedOdometry, CovarianceIsThatOfManyDrawnDrives) {
  OdometryNoise noise;
  noise.distance = 0.05;
  noise.yaw = 0.05;
  const auto increments = random_increments(5, 60);
  const Pose2 mean = composed(increments, {});
  constexpr std::uint32_t kDrives = 20000;
  Eigen::Matrix3d observed = Eigen::Matrix3d::Zero();
  for (std::uint32_t drive = 0; drive < kDrives; ++drive) {
    RandomStream random(9, 0, drive);
    Pose2 pose;
    for (const OdometryIncrement& u : increments) {
      if (standing(u)) continue;
      const double along = noise.distance * std::sqrt(std::abs(u.speed) * u.duration) * random.normal();
      const double across =
          noise.distance * std::sqrt(std::abs(u.lateral_speed) * u.duration) * random.normal();
      pose =
          pose * displacement(u) * Pose2{along, across, noise.yaw * std::sqrt(u.duration) * random.normal()};
    }
    const Eigen::Vector3d d(pose.x - mean.x, pose.y - mean.y, angle_difference(pose.yaw, mean.yaw));
    observed += d * d.transpose() / kDrives;
  }
  const Eigen::Matrix3d covariance = summed(increments, {}, noise).covariance();
  const Eigen::Vector3d sigma = covariance.diagonal().cwiseSqrt();
  for (int i = 0; i < 3; ++i) {
    // 1 % is one standard deviation of 20000 draws; the rest is for what linearisation leaves out.
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(observed(i, j), covariance(i, j), 0.05 * sigma(i) * sigma(j)) << i << " " << j;
  }
}

TEST(PreintegratedOdometry, SplittingAnIncrementHardlyChangesTheCovariance) {
  const auto covariance = [](int parts) {
    PreintegratedOdometry odometry{OdometryNoise{}};
    const double dt = 2.0 / parts;
    for (int i = 1; i <= parts; ++i) odometry.add({dt * i, dt, 2.0, 0.5});
    return odometry.covariance();
  };
  const Eigen::Vector3d sigma = covariance(400).diagonal().cwiseSqrt();
  const auto change = [&](int parts) {
    const Eigen::Matrix3d difference = covariance(2 * parts) - covariance(parts);
    return (difference.array() / (sigma * sigma.transpose()).array()).abs().maxCoeff();
  };
  EXPECT_LT(change(100), 0.01);
  EXPECT_NEAR(change(50) / change(100), 2.0, 0.3);  // vanishes with the length of the steps
}

}  // namespace
}  // namespace multipath_localization
