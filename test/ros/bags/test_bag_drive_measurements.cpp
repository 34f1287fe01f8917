#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "evaluation/metrics.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "recorded_bag.hpp"
#include "ros/bags/bag_drive.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/messages/heading_conversions.hpp"

namespace multipath_localization {
namespace {

TEST(ReadBag, LateFixesArriveWithTheOdometryBeforeThem) {
  Recording recording;
  recording.arrival_delay = 2.5;
  const Drive drive = read_bag(record(recording), {}, kDatum);
  EXPECT_DOUBLE_EQ(drive.fixes().front().stamp, 1000.0);
  EXPECT_DOUBLE_EQ(drive.measurements.front().arrival, 1002.0);
}

TEST(ReadBag, LeavesOutWhatTheNodeRefusesAndSaysSo) {
  const std::string file = record({});
  {
    rosbag::Bag bag(file, rosbag::bagmode::Append);
    auto fix = fix_at(1021.0, {5.0, 21.0});
    fix.latitude = std::numeric_limits<double>::quiet_NaN();
    bag.write("/gps/fix", ros::Time(1021.0), fix);
    auto odometry = odometry_at(1021.0);
    odometry.twist.twist.linear.x = std::numeric_limits<double>::infinity();
    bag.write("/odom", ros::Time(1021.0), odometry);
  }
  const Drive drive = read_bag(file, {}, kDatum);
  EXPECT_EQ(drive.fixes().size(), 21u);
  EXPECT_EQ(drive.odometry.size(), 21u);
  EXPECT_EQ(drive.notices,
            (std::vector<std::string>{"/gps/fix: not finite, 1 times", "/odom: not finite, 1 times"}));
}

TEST(ReadBag, TakesHeadingsOfEitherTypeAndNoGyroFromThem) {
  const std::string imu = record({});
  {
    rosbag::Bag bag(imu, rosbag::bagmode::Append);
    std_msgs::Header header;
    header.stamp = ros::Time(1005.0);
    bag.write("/heading", header.stamp, to_message(Heading{1005.0, 1.5, 0.01}, header));
  }
  const auto heading_in = [](const Drive& drive) {
    Heading found;
    for (const RecordedMeasurement& recorded : drive.measurements) {
      if (const auto* heading = std::get_if<Heading>(&recorded.measurement)) found = *heading;
    }
    return found;
  };
  const Drive drive = read_bag(imu, {}, kDatum);
  EXPECT_NEAR(heading_in(drive).yaw, 1.5, 1e-9);
  EXPECT_EQ(heading_in(drive).stamp, 1005.0);
  EXPECT_TRUE(drive.yaw_rates.empty());

  const std::string pose = record({});
  {
    rosbag::Bag bag(pose, rosbag::bagmode::Append);
    auto message = stamped<geometry_msgs::PoseWithCovarianceStamped>(1006.0);
    message.pose.pose = to_message(Pose2{0.0, 0.0, -1.0});
    message.pose.covariance[35] = 0.04;
    bag.write("/heading", message.header.stamp, message);
  }
  EXPECT_NEAR(heading_in(read_bag(pose, {}, kDatum)).yaw, -1.0, 1e-9);
  EXPECT_NEAR(heading_in(read_bag(pose, {}, kDatum)).variance, 0.04, 1e-12);
}

TEST(ReadBag, AntennaIsWhereTheTransformsHaveIt) {
  const std::string file = record({});
  {
    rosbag::Bag bag(file, rosbag::bagmode::Append);
    bag.write("/tf_static", ros::Time(1001.0), antenna_at(0.4, -0.1));
  }
  const Drive drive = read_bag(file, {}, kDatum);
  EXPECT_EQ(drive.fixes().front().antenna_in_base, Eigen::Vector2d(0.4, -0.1));

  Recording unknown;
  unknown.with_antenna = false;
  const Drive without = read_bag(record(unknown), {}, kDatum);
  EXPECT_EQ(without.fixes().front().antenna_in_base, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(without.notices.size(), 1u);
}

TEST(ReadBag, FixedJointsOnTfPlaceTheAntennaAndMovingOnesDoNot) {
  Recording recording;
  recording.with_antenna = false;
  for (const double way : {0.0, 0.1}) {  // of the antenna from fix to fix
    const std::string file = record(recording);
    {
      rosbag::Bag bag(file, rosbag::bagmode::Append);
      for (int i = 0; i <= 20; ++i) {
        bag.write("/tf", ros::Time(1000.0 + i), antenna_at(0.4 + way * i, -0.1, "/gps"));
      }
    }
    const Drive drive = read_bag(file, {}, kDatum);
    EXPECT_EQ(drive.fixes().front().antenna_in_base,
              way == 0.0 ? Eigen::Vector2d(0.4, -0.1) : Eigen::Vector2d(0.0, 0.0));
    EXPECT_EQ(drive.notices.size(), way == 0.0 ? 0u : 1u);
    if (way == 0.0) continue;
    EXPECT_NE(drive.notices.front().find("moves on the robot"), std::string::npos);
  }
}

TEST(ReadBag, ReadsEpochsWithAndWithoutFixes) {
  Recording both;
  both.with_epoch = true;
  EXPECT_EQ(read_bag(record(both), {}, kDatum).measurements.size(), 42u);
  Recording raw = both;
  raw.with_fix = false;
  const Drive drive = read_bag(record(raw), {}, std::nullopt);
  ASSERT_EQ(drive.measurements.size(), 21u);
  EXPECT_TRUE(drive.fixes().empty());
  EXPECT_NEAR(drive.datum.latitude_deg, kDatum.latitude_deg, 1e-7) << "by the solutions in open sky";
  EXPECT_NEAR(drive.datum.longitude_deg, kDatum.longitude_deg, 1e-7);
  const auto& epoch = std::get<PseudorangeEpoch>(drive.measurements[3].measurement);
  EXPECT_DOUBLE_EQ(epoch.stamp, 1003.0);
  EXPECT_EQ(epoch.observations.size(), 13u);
  const auto solution = solve_position(epoch.observations, declared_weights(epoch.observations), {0, 0, 0});
  EXPECT_LT((solution->position.head<2>() - Eigen::Vector2d(5.0, 3.0)).norm(), 0.05);
}

TEST(ReadBag, PairsTheFixesOfTwoAntennas) {
  Recording recording;
  recording.with_fix = recording.with_antenna = false;
  recording.with_pair = true;
  const Drive drive = read_bag(record(recording), {}, std::nullopt);
  EXPECT_EQ(drive.measurements.size(), 20u);
  EXPECT_EQ(drive.fixes().size(), 40u);
  EXPECT_NEAR(*score_fixes(drive, 0.0).rmse_open, 0.0, 0.01);
  ASSERT_EQ(drive.notices.size(), 2u);
  EXPECT_EQ(drive.notices[1], "/gps/left/fix and /gps/right/fix: unpaired, 1 times");
}

}  // namespace
}  // namespace multipath_localization
