#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros/inputs/odometry_reader.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

nav_msgs::Odometry message(double stamp, double speed = 0.0, double yaw_rate = 0.0, const Pose2& pose = {}) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = ros::Time(stamp);
  odometry.header.frame_id = "odom";
  odometry.pose.pose = to_message(pose);
  odometry.twist.twist.linear.x = speed;
  odometry.twist.twist.angular.z = yaw_rate;
  return odometry;
}

OdometryReader reader() { return OdometryReader(OdometryParameters{}, "map"); }

TEST(OdometryReader, TakesTheLaterTwistOverTheTimeBetweenTwo) {
  OdometryReader odometry = reader();
  EXPECT_EQ(odometry.read(message(10.0, 1.0)).reason, Reason::kAccepted);
  const CheckedOdometry checked = odometry.read(message(10.5, -2.0, 0.25));
  ASSERT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_EQ(checked.increment.stamp, 10.5);
  EXPECT_NEAR(checked.increment.duration, 0.5, 1e-9);
  EXPECT_EQ(checked.increment.speed, -2.0) << "as of wheels whose ticks are divided by that time";
  EXPECT_EQ(checked.increment.yaw_rate, 0.25);
}

/// Way and turn read of `seconds` at 1 m/s, the poses `scale` times as far, from time 10 on.
double way_read(OdometryReader& odometry, double seconds, double scale, double twist, bool burst = false) {
  double way = 0.0, x = 0.0;
  double before = 10.0;
  for (int i = 1; i <= std::lround(seconds / 0.02); ++i) {
    const double on_time = 10.0 + 0.02 * i;
    const double stamp = burst ? on_time - 0.019 * ((i - 1) % 5) * 0.9 : on_time;
    x += scale * 0.02;
    const double said = burst ? twist * 0.02 / (stamp - before) : twist;
    const CheckedOdometry checked = odometry.read(message(stamp, said, 0.0, {x, 0.0, 0.0}));
    if (checked.reason != Reason::kAccepted) continue;
    before = stamp;
    way += checked.increment.speed * checked.increment.duration;
  }
  return way;
}

TEST(OdometryReader, GoesByThePosesWhereTheyAreTheTwistsMotion) {
  OdometryReader alike = reader();
  EXPECT_NEAR(way_read(alike, 40.0, 1.0, 1.05), 40.0 + 0.05, 0.02) << "but for the first second";
  OdometryReader far = reader();
  EXPECT_NEAR(way_read(far, 40.0, 1.5, 1.0), 40.0, 0.02) << "the poses are something else";
  OdometryReader none = reader();
  EXPECT_NEAR(way_read(none, 40.0, 0.0, 1.0), 40.0, 0.02) << "nobody fills in the pose";
}

TEST(OdometryReader, APoseThatWasSetAnewIsNoMotion) {
  OdometryReader odometry = reader();
  way_read(odometry, 10.0, 1.0, 1.0);
  const CheckedOdometry jumped = odometry.read(message(20.02, 1.0, 0.0, {0.3, 0.0, 0.0}));
  EXPECT_EQ(jumped.reason, Reason::kAccepted);
  EXPECT_EQ(jumped.increment.speed, 1.0);
  EXPECT_EQ(odometry.read(message(20.04, 1.0, 0.0, {0.32, 0.0, 0.0})).increment.speed, 1.0);
}

TEST(OdometryReader, APoseWithoutOrientationIsNoMotion) {
  OdometryReader odometry = reader();
  const auto bare = [](double stamp, double speed, double x) {
    nav_msgs::Odometry said = message(stamp, speed, 0.0, {x, 0.0, 0.0});
    said.pose.pose.orientation.w = 0.0;
    return said;
  };
  EXPECT_EQ(odometry.read(bare(10.0, 0.0, 0.0)).reason, Reason::kAccepted) << "stands";
  EXPECT_EQ(odometry.read(bare(10.1, 0.0, 0.1)).reason, Reason::kInvalidOrientation)
      << "moves, and who knows how";
  EXPECT_EQ(odometry.read(bare(10.2, 1.0, 0.2)).reason, Reason::kAccepted) << "the twist tells";
}

TEST(OdometryReader, TakesPoseDifferencesWhereTheTwistIsEmpty) {
  for (const double speed : {1.5, -1.5}) {
    OdometryReader odometry = reader();
    Pose2 pose{4.0, 5.0, 3.0};
    odometry.read(message(10.0, 0.0, 0.0, pose));
    OdometryIncrement driven{10.1, 0.1, speed, 0.7};
    pose = pose * displacement(driven);
    const CheckedOdometry checked = odometry.read(message(10.1, 0.0, 0.0, pose));
    ASSERT_EQ(checked.reason, Reason::kAccepted);
    EXPECT_NEAR(checked.increment.speed, speed, 1e-6) << "signed";
    EXPECT_NEAR(checked.increment.yaw_rate, 0.7, 1e-6);
  }
}

TEST(OdometryReader, ReadsMotionSidewaysFromTwistAndPoseUnlessToldNotTo) {
  const OdometryIncrement driven{10.1, 0.1, 0.4, 0.7, -0.6};
  const Pose2 from{4.0, 5.0, 3.0};
  for (const bool twist : {true, false}) {
    for (const bool lateral : {true, false}) {
      OdometryParameters parameters;
      parameters.lateral = lateral;
      OdometryReader odometry(parameters, "map");
      nav_msgs::Odometry first = message(10.0, twist ? 0.4 : 0.0, twist ? 0.7 : 0.0, from);
      nav_msgs::Odometry second =
          message(10.1, twist ? 0.4 : 0.0, twist ? 0.7 : 0.0, from * displacement(driven));
      first.twist.twist.linear.y = second.twist.twist.linear.y = twist ? -0.6 : 0.0;
      odometry.read(first);
      const OdometryIncrement read = odometry.read(second).increment;
      EXPECT_NEAR(read.speed, 0.4, 1e-6);
      EXPECT_NEAR(read.yaw_rate, 0.7, 1e-6);
      EXPECT_NEAR(read.lateral_speed, lateral ? -0.6 : 0.0, 1e-6);
    }
  }
}

TEST(OdometryReader, AnIntegrationByTheYawAtOneEndIsNoMotionSideways) {
  for (const double share : {0.0, 0.5, 1.0}) {  // of the turn, by which the driver's chord is turned
    OdometryReader odometry = reader();
    odometry.read(message(10.0, 0.0, 0.0, {4.0, 5.0, 3.0}));
    const double turn = 0.06;
    const Pose2 moved{0.1 * std::cos(share * turn), 0.1 * std::sin(share * turn), turn};
    const OdometryIncrement read =
        odometry.read(message(10.1, 0.0, 0.0, Pose2{4.0, 5.0, 3.0} * moved)).increment;
    EXPECT_EQ(read.lateral_speed, 0.0) << share;
    EXPECT_NEAR(read.speed, 1.0, 1e-3);
  }
}

TEST(OdometryReader, StandsStillWhereNeitherTwistNorPoseMoves) {
  OdometryReader odometry = reader();
  odometry.read(message(10.0, 0.0, 0.0, {1.0, 1.0, 1.0}));
  const CheckedOdometry checked = odometry.read(message(10.1, 0.0, 0.0, {1.0, 1.0, 1.0}));
  EXPECT_EQ(checked.increment.speed, 0.0);
  EXPECT_EQ(checked.increment.yaw_rate, 0.0);
}

TEST(OdometryReader, RefusesStampsThatDoNotAdvance) {
  OdometryReader odometry = reader();
  odometry.read(message(10.0, 1.0));
  odometry.read(message(10.1, 1.0));
  EXPECT_EQ(odometry.read(message(10.1, 1.0)).reason, Reason::kOldStamp) << "repeated";
  EXPECT_EQ(odometry.read(message(10.05, 1.0)).reason, Reason::kOldStamp) << "going back";
  EXPECT_EQ(odometry.read(message(10.08, 1.0)).reason, Reason::kOldStamp) << "still no jump";
  EXPECT_EQ(odometry.read(message(0.0, 1.0)).reason, Reason::kZeroStamp);
  EXPECT_EQ(odometry.read(message(10.2, 1.0)).reason, Reason::kAccepted);
}

TEST(OdometryReader, RefusesStampsBeyondTheClocksEnd) {
  nav_msgs::Odometry late = message(10.0, 1.0);
  late.header.stamp = ros::Time(4294967295u, 0);
  EXPECT_EQ(reader().read(late).reason, Reason::kFutureStamp);
}

TEST(OdometryReader, BridgesWhatWasRefused) {
  OdometryReader odometry = reader();
  odometry.read(message(10.0, 1.0));
  odometry.read(message(10.1, kNan));
  EXPECT_NEAR(odometry.read(message(10.2, 1.0)).increment.duration, 0.2, 1e-9);
}

TEST(OdometryReader, OneStampAstrayIsRefusedAndForgotten) {
  for (const double astray : {5.0, 1e6}) {
    OdometryReader odometry = reader();
    odometry.read(message(10.0, 1.0));
    const CheckedOdometry refused = odometry.read(message(astray, 1.0));
    EXPECT_EQ(refused.reason, astray > 10.0 ? Reason::kFutureStamp : Reason::kOldStamp);
    EXPECT_FALSE(refused.restarted);
    const CheckedOdometry next = odometry.read(message(10.1, 1.0));
    EXPECT_EQ(next.reason, Reason::kAccepted);
    EXPECT_FALSE(next.restarted);
  }
}

TEST(OdometryReader, TwoStampsInARowThatJumpedStartAfresh) {
  for (const double jump : {5.0, 100.0}) {
    OdometryReader odometry = reader();
    odometry.read(message(10.0, 1.0));
    EXPECT_FALSE(odometry.read(message(jump, 1.0)).restarted);
    const CheckedOdometry second = odometry.read(message(jump + 0.1, 1.0));
    EXPECT_EQ(second.reason, Reason::kAccepted);
    EXPECT_TRUE(second.restarted);
    EXPECT_NEAR(odometry.read(message(jump + 0.2, 1.0)).increment.duration, 0.1, 1e-9);
  }
}

TEST(OdometryReader, RefusesNumbersThatAreNone) {
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    nav_msgs::Odometry odometry = message(10.0);
    odometry.pose.pose.orientation.y = bad;
    EXPECT_EQ(reader().read(odometry).reason, Reason::kNotFinite);
    EXPECT_EQ(reader().read(message(10.0, bad)).reason, Reason::kNotFinite);
    EXPECT_EQ(reader().read(message(10.0, 0.0, bad)).reason, Reason::kNotFinite);
  }
  EXPECT_EQ(reader().read(message(10.0, 0.0, 0.0, {1e308, 0.0, 0.0})).reason, Reason::kInvalidPosition);
  nav_msgs::Odometry turned = message(10.0);
  turned.pose.pose.orientation.w = 3.0;
  EXPECT_EQ(reader().read(turned).reason, Reason::kInvalidOrientation);
}

TEST(OdometryReader, RefusesSpeedsNoRobotReaches) {
  EXPECT_EQ(reader().read(message(10.0, 1e308)).reason, Reason::kTooFast);
  EXPECT_EQ(reader().read(message(10.0, -51.0)).reason, Reason::kTooFast);
  EXPECT_EQ(reader().read(message(10.0, 0.0, 21.0)).reason, Reason::kTooFast);
  nav_msgs::Odometry sideways = message(10.0);
  sideways.twist.twist.linear.y = -51.0;
  EXPECT_EQ(reader().read(sideways).reason, Reason::kTooFast);
}

TEST(OdometryReader, SurvivesAPoseThatWasSetBack) {
  OdometryReader odometry = reader();
  odometry.read(message(10.0, 0.0, 0.0, {50.0, 0.0, 0.0}));
  EXPECT_EQ(odometry.read(message(10.1, 0.0, 0.0, {0.0, 0.0, 0.0})).reason, Reason::kTooFast);
  const CheckedOdometry next = odometry.read(message(10.2, 0.0, 0.0, {0.1, 0.0, 0.0}));
  EXPECT_EQ(next.reason, Reason::kAccepted);
  EXPECT_NEAR(next.increment.speed, 1.0, 1e-6);
}

TEST(OdometryReader, RefusesOurOwnOutputFedBack) {
  nav_msgs::Odometry own = message(10.0);
  own.header.frame_id = "/map";
  EXPECT_EQ(reader().read(own).reason, Reason::kInvalidFrame);
}

TEST(OdometryReader, ClearStartsAfresh) {
  OdometryReader odometry = reader();
  odometry.read(message(10.0, 1.0));
  odometry.clear();
  EXPECT_EQ(odometry.read(message(5.0, 1.0)).reason, Reason::kAccepted);
}

}  // namespace
}  // namespace multipath_localization
