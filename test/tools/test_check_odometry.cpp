#include <cmath>

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
  EXPECT_TRUE(ToFix(check_twist(negative), "twist.linear.x is -1.00 times",
                    "drive forwards, and see whether twist.linear.x is positive"))
      << "fixes do not tell which end is the front";
  const auto mirrored = with_odometry([](auto& odometry) { odometry.twist.twist.angular.z *= -1.0; });
  EXPECT_TRUE(
      ToFix(check_twist(mirrored), "twist.angular.z is -1.00 times", "turn the sign of twist.angular.z"));
  const auto degrees = with_odometry([](auto& odometry) { odometry.twist.twist.angular.z *= 57.3; });
  EXPECT_TRUE(ToFix(check_twist(degrees), "twist.angular.z is 57.3", "times 0.017"));
}

TEST(CheckTwist, ReadsStampsThatLeapFurtherThanADurationReaches) {
  Observations seen = healthy_robot();
  for (std::size_t i = 0; i < seen.odometry.size() / 2; ++i)
    seen.odometry[i].message.header.stamp.sec += 3000000000U;
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

/// A robot with the fixes of the healthy one, and a figure of its odometry by time.
template <class Change>
Observations with_each(const Change& change) {
  Observations seen = healthy_robot();
  for (auto& odometry : seen.odometry) change(odometry.message, to_pose2(odometry.message.pose.pose)->yaw);
  return seen;
}

TEST(CheckTwist, FindsATwistInTheFrameOfThePoses) {
  const Observations seen = with_each([](nav_msgs::Odometry& odometry, double yaw) {
    const double v = odometry.twist.twist.linear.x;
    odometry.twist.twist.linear.x = v * std::cos(yaw);
    odometry.twist.twist.linear.y = v * std::sin(yaw);
  });
  const Findings found = check_twist(seen);
  EXPECT_TRUE(ToFix(found, "in the frame of the poses", "turn twist.linear by -yaw"));
  EXPECT_EQ(found.size(), 1U) << "no other remedy";
  for (const Findings& other : {check_scale(seen), check_turns(seen), check_scatter(seen)}) {
    for (const Finding& finding : other) EXPECT_NE(finding.verdict, Finding::Verdict::kFix) << finding.what;
  }
}

TEST(CheckTwist, SaysBothCausesWhereOneHeadingDoesNotTellThem) {
  Observations seen = healthy_robot();
  double way = 0.0;
  for (auto& odometry : seen.odometry) {
    way += 0.05;
    odometry.message.pose.pose = to_message(Pose2{way * std::cos(1.0), way * std::sin(1.0), 1.0});
    odometry.message.twist.twist.linear.x = std::cos(1.0);
    odometry.message.twist.twist.linear.y = std::sin(1.0);
    odometry.message.twist.twist.angular.z = 0.0;
  }
  EXPECT_TRUE(ToFix(check_twist(seen), "points 57 degrees beside", "drive a circle and look again"));
}

TEST(CheckTwist, NamesAQuaternionOfZerosAndNothingElse) {
  Observations seen = with_odometry(
      [](auto& odometry) { odometry.pose.pose.orientation.z = odometry.pose.pose.orientation.w = 0.0; });
  EXPECT_TRUE(ToFix(check_twist(seen), "2400 of 2400 poses is all zero", "createQuaternionMsgFromYaw"));
  EXPECT_EQ(check_twist(seen).size(), 1U);
  EXPECT_TRUE(Passes(check_scale(seen))) << "by the twist";
  for (auto& odometry : seen.odometry) odometry.message.twist.twist = geometry_msgs::Twist();
  EXPECT_EQ(check_twist(seen).size(), 1U);
  for (const Finding& finding : check_scale(seen)) EXPECT_NE(finding.verdict, Finding::Verdict::kFix);
}

TEST(CheckTwist, NamesPosesThatNeverTurnAndNothingElse) {
  const auto seen = with_odometry([](auto& odometry) {
    odometry.pose.pose.orientation.z = 0.0;
    odometry.pose.pose.orientation.w = 1.0;
  });
  EXPECT_TRUE(ToFix(check_twist(seen), "the poses move but never turn", "createQuaternionMsgFromYaw"));
  EXPECT_EQ(check_twist(seen).size(), 1U);
}

TEST(CheckTwist, IsNotMisledByTwoMessagesOfOneStampNorByBursts) {
  Observations seen = healthy_robot();
  for (std::size_t i = 0; i + 1 < seen.odometry.size(); i += 2) {
    seen.odometry[i].message.header.stamp = seen.odometry[i + 1].message.header.stamp;
  }
  EXPECT_TRUE(Passes(check_twist(seen)));
  Observations bursts = healthy_robot();
  for (std::size_t i = 1; i < bursts.odometry.size(); ++i) {
    auto& message = bursts.odometry[i].message;
    message.header.stamp =
        ros::Time(1000.0 + 0.3 * static_cast<double>(i / 6 + 1) + 0.003 * static_cast<double>(i % 6));
    const double step = (message.header.stamp - bursts.odometry[i - 1].message.header.stamp).toSec();
    message.twist.twist.linear.x *= 0.05 / step;
    message.twist.twist.angular.z *= 0.05 / step;
  }
  EXPECT_TRUE(Passes(check_twist(bursts)));
}

TEST(CheckTwist, SaysWhereARobotMovesSideways) {
  Observations seen = healthy_robot();
  Pose2 pose;
  for (std::size_t i = 0; i < seen.odometry.size(); ++i) {
    const OdometryIncrement u{0.0, 0.05, 1.0, 0.1, i % 400 < 200 ? 0.0 : 0.5};
    pose = pose * displacement(u);
    auto& message = seen.odometry[i].message;
    message.pose.pose = to_message(pose);
    message.twist.twist.linear.y = u.lateral_speed;
    message.twist.twist.angular.z = u.yaw_rate;
  }
  EXPECT_TRUE(Passes(check_twist(seen)));
  EXPECT_NE(check_twist(seen).front().what.find("moves sideways too"), std::string::npos);
  seen.fixes.clear();  // which did not go that way
  for (auto& odometry : seen.odometry) odometry.message.twist.twist.linear.y *= -1.0;
  EXPECT_TRUE(ToFix(check_twist(seen), "twist.linear.y is -1.00 times", "turn the sign of twist.linear.y"));
  for (auto& odometry : seen.odometry) odometry.message.twist.twist.linear.y = 0.0;
  EXPECT_TRUE(ToFix(check_twist(seen), "of which twist.linear.y knows nothing", "fill twist.linear.y"));
}

TEST(CheckTwist, LeavesOutASidewaysSpeedThatNeitherPosesNorFixesKnow) {
  const auto noisy = with_odometry([](auto& odometry) {
    odometry.twist.twist.linear.y = odometry.header.stamp.sec % 2 == 0 ? 0.4 : -0.4;
  });
  EXPECT_TRUE(ToFix(check_twist(noisy), "says", "localization.yaml, odometry: {lateral: false}"));
}

TEST(CheckTwist, BlamesTheOneThatTheFixesContradict) {
  const auto half = with_odometry([](auto& odometry) { odometry.twist.twist.linear.x = 0.5; });
  EXPECT_TRUE(ToFix(check_twist(half), "is 0.50 times", "in the base driver: twist.linear.x times 2.000"));
  Observations far = healthy_robot();
  for (auto& odometry : far.odometry) {
    odometry.message.pose.pose.position.x *= 2.0;
    odometry.message.pose.pose.position.y *= 2.0;
  }
  EXPECT_TRUE(ToFix(check_twist(far), "is 0.50 times", "in the base driver: the poses' way times 0.500"));
  far.fixes.clear();
  EXPECT_TRUE(
      ToFix(check_twist(far), "is 0.50 times", "either twist.linear.x times 2.000, or the poses' way"));
}

TEST(CheckTurns, FindsAMirroredYaw) {
  EXPECT_TRUE(Passes(check_turns(healthy_robot())));
  const auto twist = with_odometry([](auto& odometry) { odometry.twist.twist.angular.z *= -1.0; });
  EXPECT_TRUE(ToFix(check_turns(twist), "mirrored, or NED", "turn the sign of twist.angular.z"));
  const auto mirrored = with_odometry([](auto& odometry) {
    odometry.twist.twist.angular.z *= -1.0;
    odometry.pose.pose.position.y *= -1.0;
    odometry.pose.pose.orientation.z *= -1.0;
  });
  EXPECT_TRUE(ToFix(check_turns(mirrored), "mirrored, or NED", "yaw = -yaw"));
  const auto straight = with_odometry([](auto& odometry) { odometry.twist.twist.angular.z = 0.0; });
  EXPECT_TRUE(Untold(check_turns(straight)));
}

TEST(CheckTurns, NamesSignsThatAReceiversDriverMayHaveLost) {
  Observations seen = healthy_robot();
  for (auto& fix : seen.fixes) fix.message.longitude *= -1.0;
  EXPECT_TRUE(ToFix(check_turns(seen), "mirrored, or NED", "if the robot was not at [52.5123"))
      << "either may be the cause";
}

/// The healthy robot with the numbers of every place changed.
template <class Change>
Observations with_places(const Change& change) {
  Observations seen = healthy_robot();
  for (auto& fix : seen.fixes) change(fix.message.latitude, fix.message.longitude);
  return seen;
}

/// Only the coordinates are to fix.
void expect_misread(const Observations& seen, const std::string& as, const std::string& remedy) {
  EXPECT_TRUE(ToFix(check_coordinates(seen), as, remedy)) << as;
  EXPECT_TRUE(ToFix(check_coordinates(seen), "which puts the robot at [52.5123", remedy)) << as;
  for (const Finding& finding : diagnose(seen)) {
    const bool other = finding.what.find(as) == std::string::npos;
    EXPECT_FALSE(other && finding.verdict == Finding::Verdict::kFix) << finding.what;
  }
}

TEST(CheckCoordinates, FindNumbersThatAreMisread) {
  EXPECT_TRUE(check_coordinates(healthy_robot()).empty());
  expect_misread(with_places([](double& latitude, double& longitude) { std::swap(latitude, longitude); }),
                 "swapped", "each in its own field");
  const auto radians = [](double& latitude, double& longitude) {
    latitude *= kPi / 180.0;
    longitude *= kPi / 180.0;
  };
  expect_misread(with_places(radians), "in radians", "180 / pi");
  const auto in_minutes = [](double degrees) {
    return std::trunc(degrees) + 0.6 * (degrees - std::trunc(degrees));
  };
  const auto minutes = [&](double& latitude, double& longitude) {
    latitude = in_minutes(latitude);
    longitude = in_minutes(longitude);
  };
  expect_misread(with_places(minutes), "in degrees and minutes",
                 "after all, in the base driver: metres per tick");
}

TEST(CheckTurns, SeesAWideFigureOfEight) {
  Observations seen = healthy_robot();
  const LocalFrame map(Geodetic{52.5, 13.4, 40.0});
  Pose2 pose;
  seen.fixes.clear();
  for (std::uint32_t i = 0; i < seen.odometry.size(); ++i) {
    const double yaw_rate = i % 1200 < 600 ? 0.083 : -0.083;  // circles of 12 m
    pose = pose * displacement({0.0, 0.05, 1.0, yaw_rate});
    seen.odometry[i].message.pose.pose = to_message(pose);
    seen.odometry[i].message.twist.twist.angular.z = yaw_rate;
    if (i % 4 != 0) continue;
    RandomStream random(1, i, 0);
    GnssFix fix;
    fix.position = pose.position() + 0.3 * Eigen::Vector2d(random.normal(), random.normal());
    seen.fixes.push_back({to_message(fix, map, seen.odometry[i].message.header), seen.odometry[i].time});
  }
  EXPECT_TRUE(Passes(check_turns(seen)));
}

TEST(CheckScale, FindsAWrongWheelRadius) {
  EXPECT_TRUE(Passes(check_scale(healthy_robot())));
  const auto small = with_odometry([](auto& odometry) { odometry.twist.twist.linear.x = 0.8; });
  EXPECT_TRUE(ToFix(check_scale(small), "fixes go 1.2", "times 1.2"));
  const auto tiny = with_odometry([](auto& odometry) { odometry.twist.twist.linear.x = 0.5; });
  EXPECT_TRUE(ToFix(check_scale(tiny), "fixes go 2.0", "times 2.0")) << "however short the way by odometry";
  Observations parked = healthy_robot();
  parked.odometry.clear();
  EXPECT_TRUE(Untold(check_scale(parked)));
}

}  // namespace
}  // namespace multipath_localization
