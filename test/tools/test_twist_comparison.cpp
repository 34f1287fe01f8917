#include <gtest/gtest.h>

#include <cmath>

#include "healthy_robot.hpp"
#include "tools/doctor/twist_comparison.hpp"

namespace multipath_localization {
namespace {

TEST(CompareTwist, IsOneOfAHealthyRobot) {
  const TwistComparison all = compare_twist(healthy_robot());
  EXPECT_EQ(all.messages, 2400U);
  EXPECT_EQ(all.without_orientation, 0U);
  EXPECT_FALSE(all.twist_is_empty);
  EXPECT_GT(all.moving.size(), 400U);
  EXPECT_NEAR(all.sum([](const TwistWindow& w) { return (w.by_pose - w.by_twist).norm(); }), 0.0, 0.01);
  EXPECT_NEAR(all.sum([](const TwistWindow& w) { return std::abs(w.turn_by_pose - w.turn_by_twist); }), 0.0,
              1e-6);
}

TEST(CompareTwist, CountsWhatHasNoOrientationAndSeesAnEmptyTwist) {
  Observations seen = healthy_robot();
  seen.odometry.front().message.pose.pose.orientation = geometry_msgs::Quaternion();
  for (auto& odometry : seen.odometry) odometry.message.twist.twist = geometry_msgs::Twist();
  const TwistComparison all = compare_twist(seen);
  EXPECT_EQ(all.without_orientation, 1U);
  EXPECT_TRUE(all.twist_is_empty);
}

}  // namespace
}  // namespace multipath_localization
