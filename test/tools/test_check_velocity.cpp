#include <cmath>
#include <functional>

#include "found.hpp"
#include "healthy_robot.hpp"
#include "ros/messages/velocity_conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {
namespace {

/// The healthy robot with velocities at 5 Hz, every one of which was changed.
Observations with_velocity(const std::function<void(geometry_msgs::TwistWithCovarianceStamped&)>& change) {
  Observations seen = healthy_robot();
  for (std::size_t i = 0; i < seen.odometry.size(); i += 4) {
    const nav_msgs::Odometry& odometry = seen.odometry[i].message;
    GnssVelocity velocity;
    velocity.velocity = rotation(to_pose2(odometry.pose.pose)->yaw) * Eigen::Vector2d(1.0, 0.0);
    velocity.covariance = 0.01 * Eigen::Matrix2d::Identity();
    geometry_msgs::TwistWithCovarianceStamped message = to_message(velocity, odometry.header);
    change(message);
    seen.velocities.push_back({message, seen.odometry[i].time});
  }
  return seen;
}

TEST(CheckVelocity, PassesOneThatGoesTheWayOfTheFixes) {
  EXPECT_TRUE(check_velocity(healthy_robot()).empty());
  EXPECT_TRUE(Passes(check_velocity(with_velocity([](auto&) {}))));
}

TEST(CheckVelocity, FindsWhatIsWrong) {
  EXPECT_TRUE(ToFix(check_velocity(with_velocity(
                        [](auto& m) { std::swap(m.twist.twist.linear.x, m.twist.twist.linear.y); })),
                    "off the course", "swapped"));
  EXPECT_TRUE(ToFix(check_velocity(with_velocity([](auto& m) {
                      m.twist.twist.linear.x = 1.0;
                      m.twist.twist.linear.y = 0.0;
                    })),
                    "off the course", "over ground"));
  EXPECT_TRUE(ToFix(check_velocity(with_velocity([](auto& m) {
                      m.twist.twist.linear.x *= 3.6;
                      m.twist.twist.linear.y *= 3.6;
                    })),
                    "3.6", "metres per second"));
  EXPECT_TRUE(ToFix(check_velocity(with_velocity([](auto& m) { m.twist.twist.linear.x = NAN; })),
                    "cannot be used", "driver"));
}

}  // namespace
}  // namespace multipath_localization
