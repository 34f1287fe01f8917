#include <gtest/gtest.h>

#include <algorithm>

#include "good_epoch.hpp"
#include "ros/inputs/antenna_frames.hpp"
#include "ros/messages/drive_messages.hpp"
#include "ros/messages/earth_frame.hpp"

namespace multipath_localization {
namespace {

/// Two increments, a late fix, a pair and an epoch of one time, and truth.
Drive small_drive() {
  Drive drive;
  drive.datum = berlin().datum();
  drive.odometry = {{10.0, 0.1, 2.0, 0.0}, {10.1, 0.1, 2.0, 0.5}};
  GnssFix fix;
  fix.stamp = 10.0;
  fix.position = {3.0, 4.0};
  fix.antenna_in_base = {0.5, 0.0};
  DualAntennaFix pair{10.1, fix, fix};
  pair.left.stamp = pair.right.stamp = 10.1;
  pair.left.antenna_in_base = {0.0, 0.5};
  PseudorangeEpoch epoch;
  epoch.stamp = 10.1;
  epoch.observations = observed(open_sky(), {3.0, 4.0, 0.0}, 5.0, 6.0);
  drive.measurements = {{pair, 10.1}, {epoch, 10.1}, {fix, 10.2}};
  drive.truth = {{10.1, {3.0, 4.0, 1.0}, true, true}, {10.2, {3.2, 4.0, 1.0}, true, {}}};
  return drive;
}

std::vector<TopicMessage> all_of(const Drive& drive, DriveMessages& messages) {
  std::vector<TopicMessage> all;
  for (const DriveEvent& event : events_of(drive)) {
    for (const TopicMessage& made : messages.of(event)) all.push_back(made);
  }
  return all;
}

DriveMessages later_by(double shift) {
  return {berlin().datum(), RobotFrames(), [shift](double time) { return ros::Time(time + shift); }};
}

TEST(EventsOf, AreByTimeOdometryFirstAndTruthLast) {
  const Drive drive = small_drive();
  DriveMessages messages = later_by(0.0);
  std::vector<std::string> topics;
  for (const TopicMessage& made : all_of(drive, messages)) topics.push_back(made.topic);
  EXPECT_EQ(topics, (std::vector<std::string>{"odom", "odom", "gps/left/fix", "gps/right/fix", "gnss/epoch",
                                              "truth", "truth/bias", "gps/fix", "truth"}));
}

TEST(DriveMessages, AreStampedByTheirOwnTimesOnTheGivenClock) {
  const Drive drive = small_drive();
  DriveMessages messages = later_by(90.0);
  const std::vector<TopicMessage> all = all_of(drive, messages);
  const auto& fix = std::get<sensor_msgs::NavSatFix>(all[7].message);
  EXPECT_NEAR(fix.header.stamp.toSec(), 100.0, 1e-6);
  EXPECT_EQ(fix.header.frame_id, "gps");
  const auto& epoch = std::get<GnssEpoch>(all[4].message);
  EXPECT_NEAR(epoch.header.stamp.toSec(), 100.1, 1e-6);
  EXPECT_EQ(epoch.pseudoranges.size(), open_sky().size());
}

TEST(DriveMessages, TellMotionSideways) {
  Drive drive = small_drive();
  drive.odometry[1].lateral_speed = -0.4;
  DriveMessages messages = later_by(0.0);
  const std::vector<TopicMessage> all = all_of(drive, messages);
  EXPECT_EQ(std::get<nav_msgs::Odometry>(all[1].message).twist.twist.linear.y, -0.4);
}

TEST(DriveMessages, SumUpTheOdometryUntilItRestarts) {
  const Drive drive = small_drive();
  DriveMessages messages = later_by(0.0);
  const auto x_of_last = [&] {
    return std::get<nav_msgs::Odometry>(all_of(drive, messages)[1].message).pose.pose.position.x;
  };
  EXPECT_NEAR(x_of_last(), 0.4, 1e-3);
  EXPECT_NEAR(x_of_last(), 0.8, 1e-3);
  messages.restart();
  EXPECT_NEAR(x_of_last(), 0.4, 1e-3);
}

TEST(DriveMessages, PlaceTheAntennasAndTheMap) {
  const Drive drive = small_drive();
  const auto transforms = later_by(0.0).static_transforms(drive).transforms;
  ASSERT_EQ(transforms.size(), 5U);
  EXPECT_EQ(transforms[0].header.frame_id, kEarthFrame);
  const std::optional<Geodetic> datum = datum_of(*to_isometry(transforms[0].transform));
  ASSERT_TRUE(datum);
  EXPECT_NEAR(datum->latitude_deg, drive.datum.latitude_deg, 1e-9);
  const auto left = std::find_if(transforms.begin(), transforms.end(),
                                 [](const auto& t) { return t.child_frame_id == "gps_left"; });
  ASSERT_NE(left, transforms.end());
  EXPECT_EQ(left->header.frame_id, "base_link");
  EXPECT_EQ(left->transform.translation.y, 0.5);
}

TEST(DriveMessages, TellWhereFixesAreBiased) {
  const Drive drive = small_drive();
  DriveMessages messages = later_by(0.0);
  const std::vector<TopicMessage> all = all_of(drive, messages);
  EXPECT_EQ(std::get<geometry_msgs::Vector3Stamped>(all[6].message).vector.z, 1.0);
}

}  // namespace
}  // namespace multipath_localization
