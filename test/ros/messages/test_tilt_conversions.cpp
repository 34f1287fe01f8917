#include <gtest/gtest.h>

#include <limits>

#include "ros/messages/tilt_conversions.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Eigen::Quaterniond kLevel = Eigen::Quaterniond::Identity();
const Tilt kTilt{0.1, -0.2};

/// What a sensor says that is mounted level on a base that leans.
sensor_msgs::Imu leaning() {
  std_msgs::Header header;
  header.stamp = ros::Time(12.5);
  return to_message(YawRate{12.5, 0.4}, header, kTilt);
}

TEST(ToInertial, ReadsBackWhatIsWritten) {
  const auto sample = to_inertial(leaning(), kLevel);
  ASSERT_TRUE(sample && sample->up && sample->acceleration && sample->rate);
  EXPECT_EQ(sample->stamp, 12.5);
  EXPECT_NEAR((*sample->up - up_in_base(kTilt)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((*sample->acceleration - 9.81 * up_in_base(kTilt)).norm(), 0.0, 1e-12);
  const YawRate about_vertical{12.5, sample->rate->dot(up_in_base(kTilt))};
  EXPECT_NEAR(over_map(kTilt, about_vertical).rate, 0.4, 1e-12);
}

TEST(ToInertial, TurnsASensorThatIsMountedOtherwiseIntoTheBase) {
  const Eigen::Quaterniond mounted(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  sensor_msgs::Imu message = leaning();
  const Eigen::Quaterniond written(message.orientation.w, message.orientation.x, message.orientation.y,
                                   message.orientation.z);
  const Eigen::Quaterniond turned = written * mounted;
  message.orientation.x = turned.x();
  message.orientation.y = turned.y();
  message.orientation.z = turned.z();
  message.orientation.w = turned.w();
  const auto sample = to_inertial(message, mounted);
  ASSERT_TRUE(sample && sample->up);
  EXPECT_NEAR((*sample->up - up_in_base(kTilt)).norm(), 0.0, 1e-12);
}

TEST(ToInertial, LeavesOutWhatIsNotTold) {
  sensor_msgs::Imu message = leaning();
  message.orientation_covariance[0] = -1.0;
  EXPECT_FALSE(to_inertial(message, kLevel)->up);
  message.angular_velocity.y = kNan;
  EXPECT_FALSE(to_inertial(message, kLevel)->rate);
  message.linear_acceleration.x = kNan;
  EXPECT_FALSE(to_inertial(message, kLevel)) << "neither orientation nor acceleration";
  message = leaning();
  message.header.stamp = ros::Time();
  EXPECT_FALSE(to_inertial(message, kLevel));
  message = leaning();
  message.orientation = to_orientation(1.0, {});
  EXPECT_FALSE(to_inertial(message, kLevel)->up) << "level to the bit: nobody has filled it in";
}

TEST(ToOrientation, TurnsByYawThenPitchThenRoll) {
  const geometry_msgs::Quaternion q = to_orientation(0.7, kTilt);
  const Eigen::Quaterniond expected = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(kTilt.pitch, Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(kTilt.roll, Eigen::Vector3d::UnitX());
  EXPECT_NEAR(Eigen::Quaterniond(q.w, q.x, q.y, q.z).angularDistance(expected), 0.0, 1e-7);
}

}  // namespace
}  // namespace multipath_localization
