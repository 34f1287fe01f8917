#include "found.hpp"
#include "healthy_robot.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {
namespace {

/// The healthy robot with every message of odometry changed.
template <class Change>
Observations with_odometry(const Change& change) {
  Observations seen = healthy_robot();
  for (auto& odometry : seen.odometry) change(odometry.message);
  return seen;
}

TEST(CheckTwist, TakesAnEmptyOne) {
  EXPECT_TRUE(Passes(check_twist(healthy_robot())));
  const auto empty = with_odometry([](auto& odometry) { odometry.twist.twist = geometry_msgs::Twist(); });
  EXPECT_TRUE(Passes(check_twist(empty)));
  EXPECT_NE(check_twist(empty).front().what.find("twist is empty"), std::string::npos);
}

TEST(CheckTwist, FindsSignAndScale) {
  const auto negative = with_odometry([](auto& odometry) { odometry.twist.twist.linear.x *= -1.0; });
  EXPECT_TRUE(
      ToFix(check_twist(negative), "twist.linear.x is -1.00 times", "turn the sign of twist.linear.x"));
  const auto mirrored = with_odometry([](auto& odometry) { odometry.twist.twist.angular.z *= -1.0; });
  EXPECT_TRUE(
      ToFix(check_twist(mirrored), "twist.angular.z is -1.00 times", "turn the sign of twist.angular.z"));
  const auto degrees = with_odometry([](auto& odometry) { odometry.twist.twist.angular.z *= 57.3; });
  EXPECT_TRUE(ToFix(check_twist(degrees), "twist.angular.z is 57.3", "times 0.017"));
}

TEST(CheckTwist, ReadsStampsThatLeapFurtherThanADurationReaches) {
  Observations seen = healthy_robot();
  for (std::size_t i = 0; i < seen.odometry.size() / 2; ++i)
    seen.odometry[i].message.header.stamp.sec += 3000000000;
  EXPECT_TRUE(Passes(check_twist(seen)));
}

TEST(CheckTwist, FindsASpeedWithoutSignInReverse) {
  Observations seen = healthy_robot();
  double x = 0.0;
  for (std::size_t i = 0; i < seen.odometry.size(); ++i) {
    x += i % 200 < 150 ? 0.05 : -0.05;
    seen.odometry[i].message.pose.pose = to_message(Pose2{x, 0.0, 0.0});
    seen.odometry[i].message.twist.twist.linear.x = 1.0;
  }
  EXPECT_TRUE(ToFix(check_twist(seen), "other sign than the pose in 25 %", "negative in reverse"));
}

TEST(CheckTurns, FindsAMirroredYaw) {
  EXPECT_TRUE(Passes(check_turns(healthy_robot())));
  const auto mirrored = with_odometry([](auto& odometry) { odometry.twist.twist.angular.z *= -1.0; });
  EXPECT_TRUE(ToFix(check_turns(mirrored), "mirrored, or NED", "yaw = -yaw"));
  const auto straight = with_odometry([](auto& odometry) { odometry.twist.twist.angular.z = 0.0; });
  EXPECT_TRUE(Untold(check_turns(straight)));
}

TEST(CheckScale, FindsAWrongWheelRadius) {
  EXPECT_TRUE(Passes(check_scale(healthy_robot())));
  const auto small = with_odometry([](auto& odometry) { odometry.twist.twist.linear.x = 0.8; });
  EXPECT_TRUE(ToFix(check_scale(small), "fixes go 1.2", "times 1.2"));
  Observations parked = healthy_robot();
  parked.odometry.clear();
  EXPECT_TRUE(Untold(check_scale(parked)));
}

}  // namespace
}  // namespace multipath_localization
