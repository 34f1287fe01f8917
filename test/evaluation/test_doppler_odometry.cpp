#include <gtest/gtest.h>

#include <cmath>

#include "../models/sky.hpp"
#include "evaluation/doppler_odometry.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.2;

VelocitySample sample(double stamp, double speed, double course, double sigma = 0.03) {
  return {stamp, speed * Eigen::Vector2d(std::cos(course), std::sin(course)),
          sigma * sigma * Eigen::Matrix2d::Identity()};
}

/// Where odometry of these samples leads.
Pose2 driven(const std::vector<VelocitySample>& samples, const Pose2& start = {}) {
  Pose2 pose = start;
  for (const OdometryIncrement& increment : odometry_of(samples)) pose = pose * displacement(increment);
  return pose;
}

PseudorangeEpoch epoch(double stamp, const Eigen::Vector3d& velocity) {
  PseudorangeEpoch all;
  all.stamp = stamp;
  all.observations = observed(open_sky(), Eigen::Vector3d::Zero(), 100.0, 120.0);
  for (SatelliteObservation& one : all.observations) {
    one.range_rate = (one.velocity - velocity).dot(one.position.normalized()) + 5.0;
  }
  return all;
}

TEST(DopplerTrack, IsTheVelocityOfEachEpoch) {
  const DopplerTrack track = doppler_track({epoch(0.0, {1.0, 2.0, 0.0}), epoch(0.2, {1.5, 2.0, 0.1})});
  ASSERT_EQ(track.samples.size(), 2u);
  EXPECT_DOUBLE_EQ(track.samples[1].stamp, 0.2);
  EXPECT_LT((track.samples[1].velocity - Eigen::Vector2d(1.5, 2.0)).norm(), 1e-6);
  EXPECT_LT(track.samples[1].covariance.trace(), 0.1);
  EXPECT_EQ(track.held, 0u);
}

TEST(DopplerTrack, HoldsTheLastVelocityWhereThereIsNone) {
  std::vector<PseudorangeEpoch> epochs;
  for (int i = 0; i < 8; ++i) epochs.push_back(epoch(i, {1.0 + i, 0.0, 0.0}));
  for (const std::size_t blind : {0u, 3u, 4u, 6u}) epochs[blind].observations.resize(3);
  const DopplerTrack track = doppler_track(epochs);
  ASSERT_EQ(track.samples.size(), 7u);
  EXPECT_DOUBLE_EQ(track.samples[0].stamp, 1.0);
  EXPECT_DOUBLE_EQ(track.samples[3].stamp, 4.0);
  EXPECT_NEAR(track.samples[3].velocity.x(), 3.0, 1e-6);
  EXPECT_EQ(track.held, 3u);
  EXPECT_DOUBLE_EQ(track.longest_hold, 2.0);
}

TEST(DopplerOdometry, FollowsACircle) {
  std::vector<VelocitySample> samples;
  for (int i = 0; i <= 100; ++i) samples.push_back(sample(i * kStep, 2.0, 0.5 + 0.1 * i * kStep));
  const std::vector<OdometryIncrement> odometry = odometry_of(samples);
  ASSERT_EQ(odometry.size(), samples.size());
  EXPECT_DOUBLE_EQ(odometry[0].duration, 1e-3);
  EXPECT_DOUBLE_EQ(odometry[0].yaw_rate, 0.0);
  EXPECT_NEAR(odometry[40].yaw_rate, 0.1, 1e-9);
  EXPECT_NEAR(odometry[40].speed, 2.0, 1e-9);
  EXPECT_NEAR(odometry[40].duration, kStep, 1e-9);
  const Pose2 end = driven(samples, {0.0, 0.0, 0.5});
  EXPECT_NEAR(end.x, 20.0 * (std::sin(2.5) - std::sin(0.5)), 0.01);
  EXPECT_NEAR(end.y, 20.0 * (std::cos(0.5) - std::cos(2.5)), 0.01);
  EXPECT_NEAR(end.yaw, 2.5, 1e-9);
}

TEST(DopplerOdometry, AParkedReceiverDoesNotMove) {
  for (const double sigma : {0.02, 0.2}) {
    std::vector<VelocitySample> samples;
    RandomStream random(7, 0, 0);
    for (int i = 0; i < 3000; ++i) {
      samples.push_back(sample(i * kStep, 0.0, 0.0, sigma));
      samples.back().velocity = sigma * Eigen::Vector2d(random.normal(), random.normal());
    }
    for (const OdometryIncrement& increment : odometry_of(samples)) {
      ASSERT_EQ(increment.speed, 0.0);
      ASSERT_EQ(increment.yaw_rate, 0.0);
    }
  }
}

TEST(DopplerOdometry, AnUncertainVelocityIsNoStandstill) {
  std::vector<VelocitySample> samples;
  for (int i = 0; i < 10; ++i) samples.push_back(sample(i * kStep, 10.0, 0.3, 4.0));
  const std::vector<OdometryIncrement> odometry = odometry_of(samples);
  EXPECT_NEAR(odometry.back().speed, 10.0, 1e-9);
  EXPECT_TRUE(odometry.back().from_range_rates);
}

TEST(DopplerOdometry, FastRobotsDoNotReverse) {
  const std::vector<OdometryIncrement> odometry =
      odometry_of({sample(0.0, 8.0, 0.0), sample(1.0, 8.0, 2.0), sample(2.0, 8.0, 2.0)});
  EXPECT_NEAR(odometry.back().speed, 8.0, 1e-9);
}

TEST(DopplerOdometry, AStopKeepsTheHeading) {
  std::vector<VelocitySample> samples;
  for (int i = 0; i < 10; ++i) samples.push_back(sample(i * kStep, 1.0, 0.3));
  for (int i = 10; i < 20; ++i) samples.push_back(sample(i * kStep, 0.02, 2.0 * i));
  for (int i = 20; i < 30; ++i) samples.push_back(sample(i * kStep, 1.0, 0.8));
  EXPECT_NEAR(driven(samples, {0.0, 0.0, 0.3}).yaw, 0.8, 1e-9);
}

TEST(DopplerOdometry, ReverseIsNoTurn) {
  std::vector<VelocitySample> samples;
  for (int i = 0; i < 10; ++i) samples.push_back(sample(i * kStep, 1.0, 0.3));
  samples.push_back(sample(10 * kStep, 0.0, 0.0));
  for (int i = 11; i < 21; ++i) samples.push_back(sample(i * kStep, 1.0, 0.3 - kPi));
  const std::vector<OdometryIncrement> odometry = odometry_of(samples);
  EXPECT_NEAR(odometry.back().speed, -1.0, 1e-9);
  for (const OdometryIncrement& increment : odometry) EXPECT_NEAR(increment.yaw_rate, 0.0, 1e-9);
  const Pose2 end = driven(samples, {0.0, 0.0, 0.3});
  EXPECT_NEAR(end.position().norm(), 0.0, 0.01);
  EXPECT_NEAR(end.yaw, 0.3, 1e-9);
}

}  // namespace
}  // namespace multipath_localization
