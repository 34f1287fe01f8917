#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/gated_ekf.hpp"
#include "multipath_localization/models/odometry_motion.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;
constexpr int kStepsPerFix = 10;

/// A robot that behaves exactly as the filter assumes, odometry at 50 Hz, fixes at 5 Hz.
class MatchedRobot {
 public:
  MatchedRobot(const GatedEkfParameters& parameters, std::uint64_t seed)
      : noise_(parameters.odometry), seed_(seed) {
    RandomStream random(seed_, 0, 0);
    errors_ = {noise_.scale_sigma * random.normal(), noise_.gyro_bias_sigma * random.normal()};
  }

  Pose2 truth;
  Eigen::Vector2d antenna = Eigen::Vector2d(0.4, -0.1);
  double fix_sigma = 0.5;
  double speed = 2.0;
  double time = 0.0;

  /// One increment as measured; the truth moves by a noisy one.
  OdometryIncrement drive() {
    RandomStream random(seed_, ++step_, 1);
    time += kStep;
    const double yaw_rate = 0.3 * std::sin(0.2 * time);
    const OdometryIncrement measured{time, kStep, speed, yaw_rate};
    truth = moved(truth, measured, errors_);
    const double along = noise_.distance * std::sqrt(std::abs(speed) * kStep) * random.normal();
    truth.x += along * std::cos(truth.yaw);
    truth.y += along * std::sin(truth.yaw);
    truth.yaw = wrap_angle(truth.yaw + noise_.yaw * std::sqrt(kStep) * random.normal());
    return measured;
  }

  GnssFix fix() {
    RandomStream random(seed_, step_, 2);
    GnssFix fix;
    fix.stamp = time;
    fix.position = truth * antenna + fix_sigma * Eigen::Vector2d(random.normal(), random.normal());
    fix.covariance = fix_sigma * fix_sigma * Eigen::Matrix2d::Identity();
    fix.antenna_in_base = antenna;
    return fix;
  }

  /// Drives on for `duration`, giving the filter everything but fixes moved by `offset`.
  void run(Estimator& filter, double duration, const Eigen::Vector2d& offset = Eigen::Vector2d::Zero()) {
    const auto steps = std::lround(duration / kStep);
    for (long i = 1; i <= steps; ++i) {
      filter.predict(drive());
      if (i % kStepsPerFix != 0) continue;
      GnssFix z = fix();
      z.position += offset;
      last = filter.update(z);
    }
  }

  Innovation last;

 private:
  OdometryNoise noise_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  OdometerErrors errors_;
};

Eigen::Vector3d pose_error(const PoseEstimate& estimate, const Pose2& truth) {
  return {estimate.pose.x - truth.x, estimate.pose.y - truth.y,
          angle_difference(estimate.pose.yaw, truth.yaw)};
}

double distance(const PoseEstimate& estimate, const Pose2& truth) {
  return pose_error(estimate, truth).head<2>().norm();
}

double nees(const PoseEstimate& estimate, const Pose2& truth) {
  const Eigen::Vector3d error = pose_error(estimate, truth);
  return error.dot(estimate.covariance.inverse() * error);
}

PosePrior prior_at(const Pose2& pose) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = Eigen::Vector3d(0.25, 0.25, 0.01).asDiagonal();
  return prior;
}

TEST(GatedEkf, NeesAndNisLieInTheirChiSquareBands) {
  constexpr int kSeeds = 80;
  GatedEkfParameters parameters;
  parameters.gate = 1e6;
  double nees_sum = 0.0;
  double nis_sum = 0.0;
  int fixes = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    MatchedRobot robot(parameters, seed);
    RandomStream random(seed, 0, 3);
    const Pose2 start{0.5 * random.normal(), 0.5 * random.normal(), 0.1 * random.normal()};
    GatedEkf filter(parameters);
    filter.start(prior_at(start));
    for (; fixes < 150 * static_cast<int>(seed); ++fixes) {
      robot.run(filter, kStep * kStepsPerFix);
      nis_sum += robot.last.nis;
    }
    nees_sum += nees(filter.estimate(), robot.truth);
  }
  // 3.3 standard deviations of a mean of chi-squares: sqrt(2 dof / count).
  EXPECT_NEAR(nees_sum / kSeeds, 3.0, 3.3 * std::sqrt(6.0 / kSeeds));
  EXPECT_NEAR(nis_sum / fixes, 2.0, 3.3 * std::sqrt(4.0 / fixes));
}

TEST(GatedEkf, FindsItsHeadingFromTheChordAndKnowsHowWell) {
  constexpr int kSeeds = 60;
  const GatedEkfParameters parameters;
  double nees_sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    MatchedRobot robot(parameters, seed);
    robot.truth = {10.0, -20.0, 2.0};
    GatedEkf filter(parameters);
    filter.start(std::nullopt);
    while (!filter.estimate().aligned && robot.time < 20.0) robot.run(filter, 0.2);
    ASSERT_LT(robot.time, 5.0);  // 5 m at 2 m/s, plus noise
    nees_sum += nees(filter.estimate(), robot.truth);
  }
  EXPECT_NEAR(nees_sum / kSeeds, 3.0, 3.3 * std::sqrt(6.0 / kSeeds));
}

TEST(GatedEkf, FindsItsHeadingInReverse) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters, 7);
  robot.truth = {0.0, 0.0, -2.5};
  robot.speed = -1.5;
  GatedEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 30.0);
  ASSERT_TRUE(filter.estimate().aligned);
  EXPECT_LT(std::abs(angle_difference(filter.estimate().pose.yaw, robot.truth.yaw)), 0.1);
  EXPECT_LT(distance(filter.estimate(), robot.truth), 0.6);
}

TEST(GatedEkf, FollowsTheFixesBeforeItIsAligned) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters, 8);
  GatedEkf filter(parameters);
  filter.start(std::nullopt);
  filter.predict(robot.drive());
  EXPECT_FALSE(filter.estimate().valid);
  EXPECT_TRUE(filter.hypotheses().empty());
  robot.run(filter, 0.6);
  const PoseEstimate estimate = filter.estimate();
  EXPECT_TRUE(estimate.valid);
  EXPECT_FALSE(estimate.aligned);
  EXPECT_GT(estimate.covariance(2, 2), 3.0);
  EXPECT_LT(distance(estimate, robot.truth), 2.0);
  EXPECT_EQ(filter.hypotheses().size(), 1U);
}

TEST(GatedEkf, RefusesASpikeAndKeepsItsPose) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters, 9);
  GatedEkf filter(parameters);
  filter.start(prior_at(robot.truth));
  robot.run(filter, 20.0);
  const PoseEstimate before = filter.estimate();
  GnssFix spike = robot.fix();
  spike.position += Eigen::Vector2d(15.0, 0.0);
  const Innovation result = filter.update(spike);
  EXPECT_EQ(result.reason, Reason::kGated);
  EXPECT_GT(result.nis, parameters.gate);
  EXPECT_NEAR(result.innovation.x(), 15.0, 3.0);
  EXPECT_EQ(filter.estimate().pose.x, before.pose.x);
  EXPECT_EQ(filter.estimate().covariance, before.covariance);
}

TEST(GatedEkf, AcceptsAnOffsetThatPersists) {
  const GatedEkfParameters parameters;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    MatchedRobot robot(parameters, seed);
    GatedEkf filter(parameters);
    filter.start(prior_at(robot.truth));
    robot.run(filter, 20.0);
    const Eigen::Vector2d offset(16.0, -12.0);
    robot.run(filter, parameters.reopen_after - 0.4, offset);
    EXPECT_EQ(robot.last.reason, Reason::kGated);
    EXPECT_LT(distance(filter.estimate(), robot.truth), 3.0);
    robot.run(filter, 1.0, offset);
    EXPECT_EQ(robot.last.reason, Reason::kAccepted);
    const Pose2 seen{robot.truth.x + offset.x(), robot.truth.y + offset.y(), robot.truth.yaw};
    EXPECT_LT(distance(filter.estimate(), seen), 3.0);
  }
}

TEST(GatedEkf, AnOutageIsNoRejection) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters, 11);
  GatedEkf filter(parameters);
  filter.start(prior_at(robot.truth));
  robot.run(filter, 20.0);
  for (int i = 0; i < 500; ++i) filter.predict(robot.drive());
  GnssFix spike = robot.fix();
  spike.position.x() += 50.0;
  EXPECT_EQ(filter.update(spike).reason, Reason::kGated);
  EXPECT_EQ(filter.update(robot.fix()).reason, Reason::kAccepted);
}

TEST(GatedEkf, LeverArmOfALateFixCounts) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters, 12);
  robot.antenna = {-6.0, 1.0};
  GatedEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 40.0);
  EXPECT_TRUE(filter.estimate().aligned);
  EXPECT_LT(distance(filter.estimate(), robot.truth), 0.8);
}

TEST(GatedEkf, ParkedRobotNeitherDiffusesNorTurns) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters, 13);
  GatedEkf filter(parameters);
  filter.start(prior_at(robot.truth));
  robot.run(filter, 10.0);
  const PoseEstimate before = filter.estimate();
  for (int i = 0; i < 3000; ++i) filter.predict({robot.time + kStep * i, kStep, 0.0, 0.01});
  EXPECT_EQ(filter.estimate().covariance, before.covariance);
  EXPECT_EQ(filter.estimate().pose.yaw, before.pose.yaw);
}

TEST(GatedEkf, WidePriorHeadingCountsAsUnknown) {
  PosePrior prior = prior_at({3.0, 4.0, 0.5});
  prior.covariance(2, 2) = 10.0;
  GatedEkf filter{GatedEkfParameters{}};
  filter.start(prior);
  EXPECT_TRUE(filter.estimate().valid);
  EXPECT_FALSE(filter.estimate().aligned);
  EXPECT_EQ(filter.estimate().pose.x, 3.0);
}

TEST(GatedEkf, UnusablePriorsAndIncrementsChangeNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  GatedEkf filter{GatedEkfParameters{}};
  filter.start(prior_at({nan, 0.0, 0.0}));
  EXPECT_FALSE(filter.estimate().valid);
  filter.start(prior_at({1.0, 2.0, 0.5}));
  for (const OdometryIncrement& u :
       {OdometryIncrement{0.1, 0.1, nan, 0.0}, OdometryIncrement{0.1, 0.0, 1.0, 0.0},
        OdometryIncrement{0.1, -1.0, 1.0, 0.0}}) {
    filter.predict(u);
    EXPECT_EQ(filter.estimate().pose.x, 1.0);
  }
}

}  // namespace
}  // namespace multipath_localization
