#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/NavSatFix.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <limits>
#include <string>

#include "../models/sky.hpp"
#include "multipath_localization/evaluation/metrics.hpp"
#include "multipath_localization/models/pseudorange.hpp"
#include "nodes/bag_drive.hpp"
#include "nodes/earth_frame.hpp"
#include "nodes/epoch_conversions.hpp"

namespace multipath_localization {
namespace {

const Geodetic kDatum{48.0, 11.0, 500.0};

struct Recording {
  bool with_antenna = true;  ///< the static transform to it, at the base
  bool with_fix = true;
  bool with_epoch = false;
  bool with_pair = false;    ///< of antennas half a metre to the left and to the right
  std::string prefix = "/";  ///< of topics
  bool with_truth = true;
  bool with_shadow = true;
  bool with_heading = true;
  double arrival_delay = 0.0;       ///< of fixes [s]
  Eigen::Vector2d bias{8.0, -3.0};  ///< in shadow, which is the second half
};

template <class Message>
Message stamped(double stamp) {
  Message message;
  message.header.stamp.fromSec(stamp);
  return message;
}

nav_msgs::Odometry odometry_at(double stamp) {
  auto message = stamped<nav_msgs::Odometry>(stamp);
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose.orientation.w = 1.0;
  message.twist.twist.linear.x = 1.0;
  return message;
}

geometry_msgs::PoseStamped truth_at_time(double stamp, double north, bool with_heading) {
  auto message = stamped<geometry_msgs::PoseStamped>(stamp);
  message.header.frame_id = "map";
  message.pose.position.x = 5.0;
  message.pose.position.y = north;
  message.pose.orientation.z = with_heading ? std::sqrt(0.5) : 0.0;
  message.pose.orientation.w = with_heading ? std::sqrt(0.5) : 1.0;
  return message;
}

sensor_msgs::NavSatFix fix_at(double stamp, const Eigen::Vector2d& position) {
  const Geodetic point = LocalFrame(kDatum).to_geodetic(position);
  auto message = stamped<sensor_msgs::NavSatFix>(stamp);
  message.header.frame_id = "gps";
  message.latitude = point.latitude_deg;
  message.longitude = point.longitude_deg;
  message.altitude = point.altitude;
  message.position_covariance[0] = message.position_covariance[4] = 4.0;
  message.position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_DIAGONAL_KNOWN;
  return message;
}

/// Of an antenna at that position whose clock is 100 km off.
GnssEpoch epoch_at(double stamp, const Eigen::Vector2d& position) {
  PseudorangeEpoch epoch;
  epoch.observations = observed(open_sky(), {position.x(), position.y(), 0.0}, -1e5, -1e5);
  GnssEpoch message = to_message(epoch, LocalFrame(kDatum), {});
  message.header.stamp.fromSec(stamp);
  message.header.frame_id = "gps";
  return message;
}

tf2_msgs::TFMessage antenna_at(double x, double y, const std::string& frame = "gps") {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  geometry_msgs::TransformStamped& transform = message.transforms.front();
  transform.header.frame_id = "base_link";
  transform.child_frame_id = frame;
  transform.transform.translation.x = x;
  transform.transform.translation.y = y;
  transform.transform.rotation.w = 1.0;
  return message;
}

void write_pair(rosbag::Bag& bag, double stamp, const Eigen::Vector2d& position) {
  auto left = fix_at(stamp, position + Eigen::Vector2d(-0.5, 0.0));
  auto right = fix_at(stamp, position + Eigen::Vector2d(0.5, 0.0));
  left.header.frame_id = "gps_left";
  right.header.frame_id = "gps_right";
  bag.write("/gps/left/fix", ros::Time(stamp), left);
  if (stamp != 1003.0) bag.write("/gps/right/fix", ros::Time(stamp), right);
}

/// Twenty seconds north at 1 m/s from (5, 0), in shadow from the tenth on; every topic at 1 Hz, the right one
/// of two antennas without a fix in the third.
std::string record(const Recording& recording) {
  const std::string file = testing::TempDir() + "bag_drive_under_test.bag";
  rosbag::Bag bag(file, rosbag::bagmode::Write);
  const auto name = [&](const std::string& topic) { return recording.prefix + topic; };
  if (recording.with_antenna) bag.write("/tf_static", ros::Time(1000.0), antenna_at(0.0, 0.0));
  if (recording.with_pair) {
    bag.write("/tf_static", ros::Time(1000.0), antenna_at(0.0, 0.5, "gps_left"));
    bag.write("/tf_static", ros::Time(1000.0), antenna_at(0.0, -0.5, "gps_right"));
  }
  for (int i = 0; i <= 20; ++i) {
    const double stamp = 1000.0 + i;
    const ros::Time now(stamp);
    const bool shadow = i >= 10;
    bag.write(name("odom"), now, odometry_at(stamp));
    const Eigen::Vector2d error = shadow ? recording.bias : Eigen::Vector2d(0.0, 0.0);
    const Eigen::Vector2d position = Eigen::Vector2d(5.0, i) + error;
    const ros::Time arrival(stamp + recording.arrival_delay);
    if (recording.with_fix) bag.write(name("gps/fix"), arrival, fix_at(stamp, position));
    if (recording.with_epoch) bag.write(name("gnss/epoch"), arrival, epoch_at(stamp, position));
    if (recording.with_pair) write_pair(bag, stamp, position);
    if (recording.with_truth) bag.write(name("truth"), now, truth_at_time(stamp, i, recording.with_heading));
    if (!recording.with_shadow) continue;
    auto flag = stamped<geometry_msgs::Vector3Stamped>(stamp);
    flag.vector.z = shadow ? 1.0 : 0.0;
    bag.write(name("truth/bias"), now, flag);
  }
  bag.close();
  return file;
}

std::string failure_of(const std::string& file, const BagTopics& topics) {
  try {
    read_bag(file, topics, std::nullopt);
  } catch (const DriveError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadBag, FindsTheDatumUnderOpenSky) {
  const Drive drive = read_bag(record({}), {}, std::nullopt);
  EXPECT_NEAR(drive.datum.latitude_deg, kDatum.latitude_deg, 1e-7);
  EXPECT_NEAR(drive.datum.longitude_deg, kDatum.longitude_deg, 1e-7);
  const Score fixes = score_fixes(drive, 0.0);
  EXPECT_EQ(fixes.epochs, 21u);
  EXPECT_NEAR(*fixes.rmse_open, 0.0, 0.01);
  EXPECT_NEAR(*fixes.rmse_shadow, std::hypot(8.0, 3.0), 0.01);
  EXPECT_EQ(drive.notices.size(), 1u) << "says what it took for the datum";
}

TEST(ReadBag, TakesTheDatumItIsGiven) {
  Recording recording;
  recording.with_shadow = false;
  recording.bias = {8.0, 8.0};
  const Drive drive = read_bag(record(recording), {}, kDatum);
  EXPECT_NEAR(*score_fixes(drive, 1015.0).rmse, std::hypot(8.0, 8.0), 0.01);
  EXPECT_TRUE(drive.notices.empty());
}

TEST(ReadBag, ReadsTruthHeadingOnlyWhereItWasFilledIn) {
  const Drive drive = read_bag(record({}), {}, kDatum);
  EXPECT_TRUE(drive.truth.front().has_yaw);
  EXPECT_NEAR(drive.truth.front().base_in_map.yaw, 0.5 * kPi, 1e-9);
  Recording without;
  without.with_heading = false;
  EXPECT_FALSE(read_bag(record(without), {}, kDatum).truth.front().has_yaw);
}

TEST(ReadBag, FindsTopicsWithAndWithoutSlashAndByName) {
  Recording bare;
  bare.prefix = "";
  EXPECT_EQ(read_bag(record(bare), {}, kDatum).fixes().size(), 21u);

  Recording named;
  named.prefix = "/robot/";
  const std::string file = record(named);
  BagTopics asked;
  asked.truth = "robot/truth";
  const Drive drive = read_bag(file, asked, kDatum);
  EXPECT_EQ(drive.fixes().size(), 21u) << "the only NavSatFix";
  EXPECT_EQ(drive.odometry.size(), 21u) << "the only Odometry";
  EXPECT_EQ(drive.truth.size(), 21u);
  EXPECT_TRUE(drive.truth.front().shadow.has_value());
  asked.fix = "/nowhere";
  EXPECT_NE(failure_of(file, asked).find("no topic /nowhere"), std::string::npos);
  asked.fix = "/robot/odom";
  EXPECT_NE(failure_of(file, asked).find("not a sensor_msgs/NavSatFix"), std::string::npos);
}

TEST(ReadBag, WithoutTruthNothingIsScored) {
  Recording recording;
  recording.with_truth = recording.with_shadow = false;
  const Drive drive = read_bag(record(recording), {}, std::nullopt);
  EXPECT_TRUE(drive.truth.empty());
  EXPECT_NEAR(drive.fixes().front().position.norm(), 0.0, 1e-6) << "the first fix is the datum";
  EXPECT_EQ(drive.notices.size(), 1u);
}

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

TEST(ReadBag, AntennaIsWhereTheStaticTransformsHaveIt) {
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

TEST(ReadBag, TakesTheDatumThatEarthTells) {
  const std::string file = record({});
  {
    rosbag::Bag bag(file, rosbag::bagmode::Append);
    tf2_msgs::TFMessage earth;
    earth.transforms.resize(1);
    earth.transforms[0].header.frame_id = "earth";
    earth.transforms[0].child_frame_id = "map";
    earth.transforms[0].transform = map_in_earth(LocalFrame(Geodetic{48.001, 11.0, 500.0}));
    bag.write("/tf_static", ros::Time(1001.0), earth);
  }
  const Drive drive = read_bag(file, {}, std::nullopt);
  EXPECT_NEAR(drive.datum.latitude_deg, 48.001, 1e-12) << "and not the median of the fixes";
  EXPECT_EQ(read_bag(file, {}, kDatum).datum.latitude_deg, kDatum.latitude_deg) << "given, it is that";
}

TEST(ReadBag, SaysThatItHoldsNoGnss) {
  Recording recording;
  recording.with_fix = false;
  EXPECT_NE(failure_of(record(recording), {}).find("no sensor_msgs/NavSatFix"), std::string::npos);
}

TEST(ReadBag, RefusesWhatIsNoBag) { EXPECT_NE(failure_of("/no/such.bag", {}), ""); }

}  // namespace
}  // namespace multipath_localization
