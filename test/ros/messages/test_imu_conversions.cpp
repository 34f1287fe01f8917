#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros/messages/imu_conversions.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A message of a sensor that turns at 0.5 rad/s about the axis `up` of its own, at `time` [s].
sensor_msgs::Imu turning_about(const Eigen::Vector3d& up, double time) {
  sensor_msgs::Imu message;
  message.header.stamp = ros::Time(time);
  message.header.frame_id = "imu_link";
  message.orientation_covariance[0] = -1.0;
  message.linear_acceleration_covariance[0] = -1.0;
  message.angular_velocity.x = 0.5 * up.x();
  message.angular_velocity.y = 0.5 * up.y();
  message.angular_velocity.z = 0.5 * up.z();
  return message;
}

RotationFinder always(const Eigen::Quaterniond& rotation) {
  return [rotation](const std::string&) { return rotation; };
}

const Eigen::Quaterniond kLevel = Eigen::Quaterniond::Identity();

TEST(ImuReader, ReadsTheRateAboutTheVerticalOfTheBase) {
  ImuReader level(always(kLevel));
  EXPECT_NEAR(level.read(turning_about(Eigen::Vector3d::UnitZ(), 1.0)).yaw_rate.rate, 0.5, 1e-12);
  const Eigen::Quaterniond upside_down(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  ImuReader turned(always(upside_down));
  EXPECT_NEAR(turned.read(turning_about(-Eigen::Vector3d::UnitZ(), 1.0)).yaw_rate.rate, 0.5, 1e-12);
  EXPECT_TRUE(turned.frame_known());
}

TEST(ImuReader, TakesTheVerticalFromTheOrientation) {
  const Eigen::Quaterniond tilted(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  sensor_msgs::Imu message = turning_about(tilted.conjugate() * Eigen::Vector3d::UnitZ(), 1.0);
  message.orientation_covariance[0] = 0.0;
  message.orientation.w = tilted.w();
  message.orientation.y = tilted.y();
  ImuReader reader(always(kLevel));
  EXPECT_NEAR(reader.read(message).yaw_rate.rate, 0.5, 1e-12);
}

TEST(ImuReader, TakesTheVerticalFromGravityOnceThatIsKnown) {
  const Eigen::Vector3d up = Eigen::Vector3d(0.3, 0.0, 1.0).normalized();
  ImuReader reader(always(kLevel));
  double rate = 0.0;
  for (int i = 1; i <= 300; ++i) {
    sensor_msgs::Imu message = turning_about(up, 0.01 * i);
    message.linear_acceleration_covariance[0] = 0.0;
    message.linear_acceleration.x = 9.81 * up.x() + 3.0 * std::sin(i);
    message.linear_acceleration.z = 9.81 * up.z();
    rate = reader.read(message).yaw_rate.rate;
  }
  EXPECT_NEAR(rate, 0.5, 0.002);
}

TEST(ImuReader, BelievesGravityRatherThanAnOrientationThatIsUpsideDown) {
  ImuReader reader(always(kLevel));
  double rate = 0.0;
  for (int i = 1; i <= 300; ++i) {
    sensor_msgs::Imu message = turning_about(Eigen::Vector3d::UnitZ(), 0.01 * i);
    message.linear_acceleration_covariance[0] = message.orientation_covariance[0] = 0.0;
    message.linear_acceleration.z = 9.81;
    message.orientation.x = 1.0;
    rate = reader.read(message).yaw_rate.rate;
  }
  EXPECT_NEAR(rate, 0.5, 1e-9);
}

TEST(ImuReader, DoesNotTakeAccelerationsWithoutGravityForIt) {
  ImuReader reader(always(kLevel));
  double rate = 0.0;
  for (int i = 1; i <= 300; ++i) {
    sensor_msgs::Imu message = turning_about(Eigen::Vector3d::UnitZ(), 0.01 * i);
    message.linear_acceleration_covariance[0] = 0.0;
    message.linear_acceleration.x = 0.4;
    rate = reader.read(message).yaw_rate.rate;
  }
  EXPECT_NEAR(rate, 0.5, 1e-12);
}

TEST(ImuReader, SaysOnceThatAFrameIsUnknownAndTakesItForLevel) {
  ImuReader reader([](const std::string&) { return std::nullopt; });
  EXPECT_NEAR(reader.read(turning_about(Eigen::Vector3d::UnitZ(), 1.0)).yaw_rate.rate, 0.5, 1e-12);
  EXPECT_TRUE(reader.frame_is_news());
  reader.read(turning_about(Eigen::Vector3d::UnitZ(), 1.1));
  EXPECT_FALSE(reader.frame_is_news());
  EXPECT_FALSE(reader.frame_known());
}

TEST(ImuReader, RefusesWithAReason) {
  ImuReader reader(always(kLevel));
  const auto reason = [&](const std::function<void(sensor_msgs::Imu&)>& spoil) {
    sensor_msgs::Imu message = turning_about(Eigen::Vector3d::UnitZ(), 1.0);
    spoil(message);
    return reader.read(message).reason;
  };
  EXPECT_EQ(reason([](auto& m) { m.header.stamp = ros::Time(); }), Reason::kZeroStamp);
  EXPECT_EQ(reason([](auto& m) { m.angular_velocity_covariance[0] = -1.0; }), Reason::kUnused);
  EXPECT_EQ(reason([](auto& m) { m.angular_velocity.y = kNan; }), Reason::kNotFinite);
  EXPECT_EQ(reason([](auto& m) { m.angular_velocity.z = 30.0; }), Reason::kTooFast);
  EXPECT_EQ(reason([](auto& m) { m.header.frame_id = std::string(300, 'x'); }), Reason::kInvalidFrame);
  EXPECT_EQ(reason([](auto&) {}), Reason::kAccepted);
}

TEST(ImuReader, ReadsBackWhatIsWritten) {
  std_msgs::Header header;
  header.stamp = ros::Time(12.5);
  ImuReader reader(always(kLevel));
  const CheckedYawRate read = reader.read(to_message(YawRate{12.5, -0.75}, header));
  EXPECT_EQ(read.reason, Reason::kAccepted);
  EXPECT_EQ(read.yaw_rate.stamp, 12.5);
  EXPECT_EQ(read.yaw_rate.rate, -0.75);
}

}  // namespace
}  // namespace multipath_localization
