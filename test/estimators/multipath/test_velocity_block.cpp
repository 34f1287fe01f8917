#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "estimators/multipath/velocity_block.hpp"

namespace multipath_localization::multipath {
namespace {

GnssVelocity velocity_at(double stamp, double east, double north) {
  GnssVelocity velocity;
  velocity.stamp = stamp;
  velocity.velocity = {east, north};
  velocity.covariance = 0.01 * Eigen::Matrix2d::Identity();
  return velocity;
}

/// One that has taken a velocity before.
VelocityBlock heard() {
  VelocityBlock block;
  block.add(velocity_at(0.0, 0.0, 0.0));
  block.take();
  return block;
}

/// Drives for `seconds` and turns by `yaw_rate` [rad/s], faster by `acceleration` [m/s^2] from `speed` on.
void drive(VelocityBlock& block, double seconds, double speed, double yaw_rate, double acceleration = 0.0) {
  for (int i = 1; i <= std::lround(100.0 * seconds); ++i) {
    block.move({0.01 * i, 0.01, speed + acceleration * 0.01 * (i - 0.5), yaw_rate});
  }
}

TEST(VelocityBlock, SaysWhatOdometryDroveAtEachDelay) {
  VelocityBlock block = heard();
  drive(block, 3.0, 0.0, 0.0, 1.0);
  EXPECT_FALSE(block.add(velocity_at(2.5, 0.0, 2.3)));
  const auto sighting = block.take();
  ASSERT_TRUE(sighting);
  EXPECT_TRUE(block.empty());
  EXPECT_EQ(sighting->velocity, Eigen::Vector2d(0.0, 2.3));
  EXPECT_NEAR(sighting->variance, 0.01, 1e-12);
  for (std::size_t k = 0; k < kDelays; ++k) {
    EXPECT_NEAR(sighting->driven[k].x(), 2.5 - kDelayStep * static_cast<double>(k), 1e-6);
    EXPECT_NEAR(sighting->driven[k].y(), 0.0, 1e-9);
  }
}

TEST(VelocityBlock, SeesThePastFromTheBaseOfNow) {
  VelocityBlock block = heard();
  drive(block, 3.0, 2.0, 0.5);
  block.add(velocity_at(2.0, 2.0, 0.0));
  const auto sighting = block.take();
  ASSERT_TRUE(sighting);
  EXPECT_NEAR(std::atan2(sighting->driven[0].y(), sighting->driven[0].x()), -0.5, 1e-3);
}

TEST(VelocityBlock, SwingsTheAntenna) {
  VelocityBlock block = heard();
  drive(block, 3.0, 1.0, 0.5);
  GnssVelocity velocity = velocity_at(2.9, 1.0, 0.5);
  velocity.antenna_in_base = {1.0, 0.0};
  block.add(velocity);
  const auto sighting = block.take();
  ASSERT_TRUE(sighting);
  EXPECT_NEAR(sighting->driven[0].norm(), std::hypot(1.0, 0.5), 0.01);
}

TEST(VelocityBlock, RefusesWhatIsNoneAndWhatRepeatsItself) {
  VelocityBlock block;
  EXPECT_EQ(block.add(velocity_at(1.0, std::numeric_limits<double>::quiet_NaN(), 0.0)), Reason::kNotFinite);
  EXPECT_EQ(block.add(velocity_at(1.0, 1e4, 0.0)), Reason::kTooFast);
  EXPECT_FALSE(block.add(velocity_at(1.0, 1.0, 0.0)));
  EXPECT_EQ(block.add(velocity_at(1.2, 1.0, 0.0)), Reason::kRepeated);
}

TEST(VelocityBlock, HasNothingToSayOfARobotThatStands) {
  VelocityBlock block = heard();
  drive(block, 3.0, 0.0, 0.0);
  block.add(velocity_at(2.9, 0.05, 0.0));
  EXPECT_FALSE(block.take());
  block.add(velocity_at(2.9, 1.0, 0.0));
  EXPECT_TRUE(block.take()) << "it slides, or they lie";
}

TEST(VelocityBlock, KnowsTheWayFromTheStart) {
  VelocityBlock block = heard();
  drive(block, 1.0, 0.0, 0.0);
  block.start({0.5, 0.0});
  for (int i = 101; i <= 200; ++i) block.move({0.01 * i, 0.01, 2.0, 0.0});
  block.add(velocity_at(1.9, 2.0, 0.0));
  const auto sighting = block.take();
  ASSERT_TRUE(sighting);
  EXPECT_TRUE(sighting->near_start);
  EXPECT_NEAR(sighting->from_start.x(), 1.5, 1e-6);
}

}  // namespace
}  // namespace multipath_localization::multipath
