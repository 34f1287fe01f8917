#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "good_fix.hpp"
#include "ros/fault_injector_node/fault_injector.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/messages/heading_conversions.hpp"

namespace multipath_localization {
namespace {

sensor_msgs::NavSatFix fix_at(double time) {
  sensor_msgs::NavSatFix fix = good_fix();
  fix.header.stamp = ros::Time(1000.0 + time);
  fix.latitude += 1e-6 * time;
  fix.altitude += 0.1 * time;
  return fix;
}

nav_msgs::Odometry odometry_at(double time) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = ros::Time(1000.0 + time);
  odometry.header.frame_id = "odom";
  odometry.pose.pose = to_message(Pose2{2.0 * time, 0.0, 0.0});
  odometry.twist.twist.linear.x = 2.0;
  return odometry;
}

FaultInjector injector(const std::string& yaml) {
  FaultInjectorParameters parameters;
  load(YAML::Load(yaml), parameters);
  return FaultInjector(parameters);
}

std::vector<sensor_msgs::NavSatFix> fixes_until(FaultInjector& faults, int seconds) {
  std::vector<sensor_msgs::NavSatFix> all;
  for (int i = 0; i < seconds; ++i) {
    for (const auto& fix : faults.take(fix_at(i))) all.push_back(fix);
  }
  return all;
}

TEST(FaultInjector, ConfigFileHoldsTheDefaults) {
  std::stringstream text;
  text << std::ifstream(std::string(CONFIG_DIR) + "/fault_injector.yaml").rdbuf();
  EXPECT_EQ(text.str(), describe(FaultInjectorParameters{}));
}

TEST(FaultInjector, TurnsHeadingsAndLetsThroughWhatIsNone) {
  FaultInjector faults = injector("heading: [{kind: offset, size: 1.0, start: 2.0, duration: 2.0}]");
  for (int i = 0; i < 6; ++i) {
    std_msgs::Header header;
    header.stamp = ros::Time(1000.0 + i);
    const auto out = faults.take_heading(to_message(Heading{1000.0 + i, 3.0, 0.01}, header));
    ASSERT_EQ(out.size(), 1U);
    const double expected = wrap_angle(i == 2 || i == 3 ? 4.0 : 3.0);
    EXPECT_NEAR(to_heading(out.front(), {}, Eigen::Quaterniond::Identity()).heading.yaw, expected, 1e-9) << i;
  }
  const sensor_msgs::Imu no_heading;
  EXPECT_EQ(faults.take_heading(no_heading).size(), 1U);
}

TEST(FaultInjector, ReadyFaultsLoad) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(CONFIG_DIR) + "/faults")) {
    FaultInjectorParameters parameters;
    EXPECT_NO_THROW(load(read_yaml(entry.path()), parameters)) << entry.path();
    EXPECT_NE(describe(parameters), describe(FaultInjectorParameters{})) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 10);
}

TEST(FaultInjector, RefusesADatumThatIsNone) {
  FaultInjectorParameters parameters;
  EXPECT_THROW(load(YAML::Load("datum: [139.7, 35.6]"), parameters), ParameterError) << "longitude first";
}

TEST(FaultInjector, WithoutFaultsMessagesGoThroughUnchanged) {
  FaultInjector faults = injector("{}");
  for (int i = 0; i < 5; ++i) {
    const auto out = faults.take(fix_at(i));
    ASSERT_EQ(out.size(), 1U);
    EXPECT_EQ(out.front(), fix_at(i));
    std::vector<sensor_msgs::NavSatFix> fixes;
    EXPECT_EQ(faults.take(odometry_at(i), fixes), odometry_at(i));
    EXPECT_TRUE(fixes.empty());
  }
  EXPECT_EQ(faults.active(), "none");
}

TEST(FaultInjector, WhatNoReaderWouldTakeGoesThroughUnchanged) {
  FaultInjector faults = injector("{fix: {biases: [{}]}, odometry: {losses: [{share: 1}]}}");
  sensor_msgs::NavSatFix fix = fix_at(1.0);
  fix.status.status = -1;
  EXPECT_EQ(faults.take(fix), std::vector<sensor_msgs::NavSatFix>{fix});
  nav_msgs::Odometry odometry = odometry_at(1.0);
  odometry.header.stamp = ros::Time();
  std::vector<sensor_msgs::NavSatFix> fixes;
  EXPECT_EQ(faults.take(odometry, fixes), odometry);
}

TEST(FaultInjector, ABiasMovesTheFixByItsMetres) {
  FaultInjector faults = injector("{fix: {biases: [{east: 8}]}}");
  const auto out = faults.take(fix_at(0.0));
  ASSERT_EQ(out.size(), 1U);
  const Eigen::Vector2d moved =
      berlin().to_map(to_geodetic(out.front())) - berlin().to_map(to_geodetic(fix_at(0.0)));
  EXPECT_NEAR((moved - Eigen::Vector2d(8.0, 0.0)).norm(), 0.0, 0.01);
  EXPECT_EQ(out.front().altitude, fix_at(0.0).altitude);
  EXPECT_EQ(out.front().position_covariance, fix_at(0.0).position_covariance);
  EXPECT_EQ(faults.active(), "fix: bias of 8 m east, 0 m north");
}

TEST(FaultInjector, AFrozenReceiverRepeatsItsPlaceToTheBit) {
  for (const char* noise : {"[]", "[{coloured_sigma: 2}]"}) {
    FaultInjector faults =
        injector(std::string("{fix: {freezes: [{start: 3, duration: 4}], noises: ") + noise + "}}");
    const auto out = fixes_until(faults, 9);
    ASSERT_EQ(out.size(), 9U);
    for (std::size_t i = 3; i < 7; ++i) {
      EXPECT_EQ(out[i].latitude, out[2].latitude);
      EXPECT_EQ(out[i].longitude, out[2].longitude);
      EXPECT_EQ(out[i].altitude, out[2].altitude);
      EXPECT_GT(out[i].header.stamp, out[i - 1].header.stamp);
    }
    EXPECT_NE(out[7].latitude, out[2].latitude);
  }
}

TEST(FaultInjector, LiesAboutCovarianceAndStatus) {
  FaultInjector faults = injector("{fix: {covariances: [{sigma_factor: 0.5}], statuses: [{status: 2}]}}");
  const auto out = faults.take(fix_at(0.0));
  ASSERT_EQ(out.size(), 1U);
  EXPECT_DOUBLE_EQ(out.front().position_covariance[0], 1.0);
  EXPECT_DOUBLE_EQ(out.front().position_covariance[4], 2.25);
  EXPECT_EQ(out.front().status.status, 2);
}

TEST(FaultInjector, LateFixesComeOutWithTheOdometryOfTheirTime) {
  FaultInjector faults = injector("{fix: {delays: [{delay: 0.5}]}}");
  std::vector<sensor_msgs::NavSatFix> fixes;
  faults.take(odometry_at(0.0), fixes);
  EXPECT_TRUE(faults.take(fix_at(0.0)).empty());
  faults.take(odometry_at(0.4), fixes);
  EXPECT_TRUE(fixes.empty());
  faults.take(odometry_at(0.6), fixes);
  ASSERT_EQ(fixes.size(), 1U);
  EXPECT_EQ(fixes.front(), fix_at(0.0));
}

TEST(FaultInjector, ThePoseOfSlippingOdometryIsThatOfItsTwist) {
  FaultInjector faults = injector("{odometry: {slips: [{start: 1, duration: 2, ratio: 0.5}]}}");
  std::vector<sensor_msgs::NavSatFix> fixes;
  std::optional<nav_msgs::Odometry> out;
  for (int i = 0; i <= 50; ++i) {
    out = faults.take(odometry_at(0.1 * i), fixes);
    ASSERT_TRUE(out);
    EXPECT_NEAR(out->twist.twist.linear.x, i >= 10 && i < 30 ? 3.0 : 2.0, 1e-9) << i;
  }
  EXPECT_NEAR(out->pose.pose.position.x, 10.0 + 2.0, 0.05);
}

TEST(FaultInjector, MessagesGetLostAfterTheirMotionWasCounted) {
  FaultInjector faults = injector("{odometry: {losses: [{share: 0.5}]}}");
  std::vector<sensor_msgs::NavSatFix> fixes;
  int lost = 0;
  for (int i = 0; i < 200; ++i) {
    const auto out = faults.take(odometry_at(0.1 * i), fixes);
    if (out) {
      EXPECT_EQ(*out, odometry_at(0.1 * i));
    }
    lost += out ? 0 : 1;
  }
  EXPECT_NEAR(lost, 100, 32);  // 4.5 sigma
}

TEST(FaultInjector, ALoopedBagGetsTheSameFaultsAgain) {
  FaultInjector faults = injector("{fix: {noises: [{white_sigma: 1}], losses: [{share: 0.3}]}}");
  const auto first = fixes_until(faults, 30);
  const auto second = fixes_until(faults, 30);
  EXPECT_LT(first.size(), 30U);
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace multipath_localization
