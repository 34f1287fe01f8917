#include <cmath>
#include <functional>

#include "found.hpp"
#include "healthy_robot.hpp"
#include "ros/messages/imu_conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {
namespace {

/// The healthy robot with an IMU of that frame, every message of which was changed.
Observations with_imu(const std::function<void(sensor_msgs::Imu&)>& change,
                      const std::string& frame = "base_link") {
  Observations seen = healthy_robot();
  std::uint32_t number = 0;
  for (const auto& odometry : seen.odometry) {
    RandomStream random(2, ++number, 0);
    const double rate = odometry.message.twist.twist.angular.z + 0.001 * random.normal();
    std_msgs::Header header;
    header.stamp = odometry.message.header.stamp;
    header.frame_id = frame;
    sensor_msgs::Imu message = to_message(YawRate{header.stamp.toSec(), rate}, header);
    change(message);
    seen.imus.push_back({message, odometry.time});
  }
  return seen;
}

TEST(CheckGyro, PassesOneThatTurnsAsOdometryDoes) {
  EXPECT_TRUE(check_gyro(healthy_robot()).empty());
  EXPECT_TRUE(Passes(check_gyro(with_imu([](auto&) {}))));
}

TEST(CheckGyro, FindsWhatIsWrong) {
  const auto found = [](const std::function<void(sensor_msgs::Imu&)>& change) {
    return check_gyro(with_imu(change));
  };
  EXPECT_TRUE(ToFix(found([](auto& m) { m.angular_velocity.z *= -1.0; }), "the other way round", "upwards"));
  EXPECT_TRUE(ToFix(found([](auto& m) { m.angular_velocity.z *= 57.3; }), "several times", "rad/s"));
  EXPECT_TRUE(ToFix(found([](auto& m) { m.angular_velocity.z = 0.01; }), "same to the bit", "restart"));
  EXPECT_TRUE(ToFix(found([](auto& m) { m.angular_velocity_covariance[0] = -1.0; }), "no gyro", "fill in"));
  EXPECT_TRUE(ToFix(found([](auto& m) { m.angular_velocity.z = NAN; }), "not finite", "driver"));
  EXPECT_TRUE(ToFix(found([](auto& m) { m.header.stamp += ros::Duration(1000.0); }), "of the time", "clock"));
}

TEST(CheckGyro, FindsAFrameThatTfDoesNotKnow) {
  const Findings findings = check_gyro(with_imu([](auto&) {}, "imu_link"));
  EXPECT_TRUE(ToFix(findings, "no transform from base_link to imu_link", "static_transform_publisher"));
}

}  // namespace
}  // namespace multipath_localization
