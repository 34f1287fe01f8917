#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros/steering_node/scan_points.hpp"

namespace multipath_localization {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A beam straight ahead, then others to the left of it, a quarter turn apart.
sensor_msgs::LaserScan scan(std::vector<float> ranges) {
  sensor_msgs::LaserScan message;
  message.angle_increment = static_cast<float>(0.5 * kPi);
  message.range_min = 0.1F;
  message.range_max = 10.0F;
  message.ranges = std::move(ranges);
  return message;
}

/// 0.3 m ahead of the base's origin, half a metre high, and turned by that about its vertical [rad].
Eigen::Isometry3d mounted(double yaw) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(0.3, 0.0, 0.5));
  pose.rotate(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  return pose;
}

TEST(ScanPoints, LieInTheBaseWhereTheScannerSeesThem) {
  const ScanPoints ahead = scan_points(scan({2.0F, 3.0F}), mounted(0.0), {});
  ASSERT_EQ(ahead.in_base.size(), 2U);
  EXPECT_LT((ahead.in_base[0] - Eigen::Vector2d(2.3, 0.0)).norm(), 1e-6);
  EXPECT_LT((ahead.in_base[1] - Eigen::Vector2d(0.3, 3.0)).norm(), 1e-6);
  const ScanPoints turned = scan_points(scan({2.0F}), mounted(kPi), {});
  EXPECT_LT((turned.in_base[0] - Eigen::Vector2d(-1.7, 0.0)).norm(), 1e-6);
}

TEST(ScanPoints, OfAScannerUpsideDownAreMirrored) {
  Eigen::Isometry3d upside_down = Eigen::Isometry3d::Identity();
  upside_down.rotate(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  const ScanPoints points = scan_points(scan({kInfinity, 3.0F}), upside_down, {});
  ASSERT_EQ(points.in_base.size(), 1U);
  EXPECT_NEAR(points.in_base[0].y(), -3.0, 1e-6);
}

TEST(ScanPoints, KnowFreeBeamsFromThoseThatAreTooNearOrTellNothing) {
  EXPECT_TRUE(scan_points(scan({kInfinity, kNaN, 0.01F, 11.0F}), mounted(0.0), {}).in_base.empty());
  Footprint short_robot;
  short_robot.front = 0.3;
  EXPECT_EQ(scan_points(scan({-kInfinity}), mounted(0.0), short_robot).in_base.size(), 1U);
}

TEST(ScanPoints, AreNotTheRobotItself) {
  EXPECT_TRUE(scan_points(scan({0.2F}), mounted(0.0), {}).in_base.empty());
}

TEST(ScanPoints, OfAScanThatTellsNothingAreAFault) {
  EXPECT_EQ(scan_points(scan({kNaN, kNaN}), mounted(0.0), {}).fault, "scan without a range");
  EXPECT_EQ(scan_points(scan({}), mounted(0.0), {}).fault, "scan without a range");
  EXPECT_EQ(scan_points(scan(std::vector<float>(200000, 1.0F)), mounted(0.0), {}).fault,
            "scan of too many beams");
  sensor_msgs::LaserScan message = scan({1.0F});
  message.angle_increment = kNaN;
  EXPECT_EQ(scan_points(message, mounted(0.0), {}).fault, "scan of unknown angles");
  message = scan({1.0F});
  message.range_max = 0.0F;
  EXPECT_EQ(scan_points(message, mounted(0.0), {}).fault, "scan of unknown ranges");
  EXPECT_EQ(scan_points(scan({kInfinity}), mounted(0.0), {}).fault, "");
}

}  // namespace
}  // namespace multipath_localization
