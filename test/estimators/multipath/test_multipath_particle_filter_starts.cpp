#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "default_localizer.hpp"
#include "estimators/multipath/multipath_particle_filter.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

PosePrior prior_at(const Pose2& pose, double yaw_sigma) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = Eigen::Vector3d(0.25, 0.25, yaw_sigma * yaw_sigma).asDiagonal();
  return prior;
}

TEST(MultipathParticleFilter, IsValidFromTheFirstFixAndAlignedAfterTheConfirmingDistance) {
  SimulatedDrive robot(1);
  Localizer localizer = default_localizer(1);
  robot.receiving = false;
  robot.run(localizer, 2.0);
  EXPECT_FALSE(localizer.estimate().valid);
  EXPECT_TRUE(localizer.hypotheses().empty());
  robot.receiving = true;
  robot.run(localizer, 0.2);
  EXPECT_TRUE(localizer.estimate().valid);
  EXPECT_GE(localizer.hypotheses().size(), 800U);
  robot.run(localizer, 2.0);
  EXPECT_FALSE(localizer.estimate().aligned);
  robot.run(localizer, 30.0);
  EXPECT_TRUE(localizer.estimate().aligned);
}

TEST(MultipathParticleFilter, NeverAlignsStandingStill) {
  SimulatedDrive robot(2);
  robot.speed = 0.0;
  Localizer localizer = default_localizer(1);
  robot.run(localizer, 120.0);
  EXPECT_FALSE(localizer.estimate().aligned);
}

TEST(MultipathParticleFilter, NeverAlignsByOdometryThatOnlyJitters) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    MultipathParticleFilter filter({}, seed);
    filter.start(std::nullopt);
    RandomStream random(seed, 1, 0);
    for (int i = 1; i <= 900 * 50; ++i) {
      filter.predict({0.02 * i, 0.02, 0.05 * random.normal(), 0.0});
      if (i % 50 != 0) continue;
      GnssFix fix;
      fix.stamp = 0.02 * i;
      fix.position = {0.3 * random.normal(), 0.3 * random.normal()};
      filter.update(fix);
      ASSERT_FALSE(filter.estimate().aligned) << fix.stamp;
    }
  }
}

TEST(MultipathParticleFilter, StartsAtAPriorAndConfirmsItByDriving) {
  for (const double yaw_sigma : {0.05, 0.8}) {
    SimulatedDrive robot(3);
    Localizer localizer = default_localizer(1);
    localizer.start(prior_at(robot.truth, yaw_sigma));
    const PoseEstimate start = localizer.estimate();
    EXPECT_TRUE(start.valid);
    EXPECT_FALSE(start.aligned);
    EXPECT_LT(position_error(start, robot.truth).norm(), 1e-9);
    EXPECT_LT(std::abs(angle_difference(start.pose.yaw, robot.truth.yaw)), yaw_sigma);
    double mass = 0.0;
    for (const Hypothesis& hypothesis : localizer.hypotheses()) mass += hypothesis.weight;
    EXPECT_NEAR(mass, 1.0, 1e-9);
    robot.run(localizer, 30.0);
    EXPECT_TRUE(localizer.estimate().aligned);
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 1.0);
    localizer.start(prior_at({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, yaw_sigma));
    EXPECT_FALSE(localizer.estimate().valid);
  }
}

TEST(MultipathParticleFilter, APriorMayCountAsConfirmed) {
  MultipathParticleFilter filter({}, 1);
  PosePrior prior = prior_at({1.0, 2.0, 0.5}, 0.05);
  prior.confirmed = true;
  filter.start(prior);
  EXPECT_TRUE(filter.estimate().aligned);
  filter.start(std::nullopt);
  filter.update(GnssFix{});
  EXPECT_FALSE(filter.estimate().aligned) << "without a prior there is nothing to count";
}

TEST(MultipathParticleFilter, AFirstFixFarAwayIsAStartLikeAnyOther) {
  SimulatedDrive robot(6);
  robot.truth = {1e7, -1e7, 0.5};
  Localizer localizer = default_localizer(1);
  robot.run(localizer, 60.0);
  EXPECT_TRUE(localizer.estimate().aligned);
  EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 1.0);
}

TEST(MultipathParticleFilter, SaysHowFarToDriveUntilItIsConfirmed) {
  SimulatedDrive robot(5);
  Localizer localizer = default_localizer(5);
  robot.run(localizer, 0.4);
  const double whole = localizer.estimate().way_to_alignment;
  EXPECT_GT(whole, 5.0);
  while (!localizer.estimate().aligned && robot.time < 60.0) robot.run(localizer, 1.0);
  EXPECT_EQ(localizer.estimate().way_to_alignment, 0.0);
}

}  // namespace
}  // namespace multipath_localization
