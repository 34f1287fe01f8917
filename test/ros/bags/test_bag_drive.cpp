#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <string>

#include "evaluation/metrics.hpp"
#include "recorded_bag.hpp"
#include "ros/bags/bag_drive.hpp"
#include "ros/messages/earth_frame.hpp"
#include "ros/messages/gnss_message.hpp"

namespace multipath_localization {
namespace {

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

/// A recording with some fixes more at the beginning.
std::string with_first(const Recording& recording, const Geodetic& place, int fixes) {
  const std::string file = record(recording);
  rosbag::Bag bag(file, rosbag::bagmode::Append);
  for (int i = 0; i < fixes; ++i) {
    sensor_msgs::NavSatFix fix = fix_at(990.0 + i, {0.0, 0.0});
    fix.latitude = place.latitude_deg;
    fix.longitude = place.longitude_deg;
    bag.write("/gps/fix", ros::Time(990.0 + i), fix);
  }
  return file;
}

TEST(ReadBag, TakesNoDatumFromNonsense) {
  Recording recording;
  recording.with_truth = recording.with_shadow = false;
  recording.bias = {0.0, 0.0};
  const auto expect_sound = [](const Drive& drive, Reason reason, unsigned fixes) {
    EXPECT_NEAR(drive.datum.latitude_deg, kDatum.latitude_deg, 1e-3);
    EXPECT_EQ(drive.fixes().size(), 21u);
    EXPECT_EQ(drive.left_out[kFixKind].of(reason), fixes);
  };
  expect_sound(read_bag(with_first(recording, {0.0, 0.0, 0.0}, 5), {}, std::nullopt),
               Reason::kInvalidPosition, 5);
  expect_sound(read_bag(with_first(recording, {50.0, 8.0, 0.0}, 1), {}, std::nullopt),
               Reason::kInvalidPosition, 1);
  expect_sound(read_bag(with_first(recording, {50.0, 8.0, 0.0}, 6), {}, std::nullopt),
               Reason::kInvalidPosition, 6);
  recording.with_truth = recording.with_shadow = true;
  expect_sound(read_bag(with_first(recording, {50.0, 8.0, 0.0}, 6), {}, std::nullopt),
               Reason::kInvalidPosition, 6);
}

TEST(ReadBag, NamesADatumFarFromAllFixes) {
  const Drive drive = read_bag(record({}), {}, Geodetic{0.0, 0.0, 0.0});
  EXPECT_TRUE(drive.fixes().empty());
  EXPECT_EQ(drive.left_out[kFixKind].of(Reason::kInvalidPosition), 21u);
  EXPECT_NE(drive.notices.back().find("is 5260 km from"), std::string::npos) << drive.notices.back();
  EXPECT_NE(drive.notices.back().find("--datum 48.0"), std::string::npos) << drive.notices.back();
}

TEST(ReadBag, SaysThatItHoldsNoGnss) {
  Recording recording;
  recording.with_fix = false;
  EXPECT_NE(failure_of(record(recording), {}).find("no sensor_msgs/NavSatFix"), std::string::npos);
}

/// A copy of a bag in which every message of that type is changed.
template <class Message, class Change>
std::string with_each(const std::string& file, const Change& change) {
  const std::string copy = testing::TempDir() + "changed_under_test.bag";
  const rosbag::Bag in(file);
  rosbag::Bag out(copy, rosbag::bagmode::Write);
  for (const rosbag::MessageInstance& message : rosbag::View(in)) {
    const auto known = message.instantiate<Message>();
    if (!known) {
      out.write(message.getTopic(), message.getTime(), message);
      continue;
    }
    change(*known);
    out.write(message.getTopic(), message.getTime(), *known);
  }
  return copy;
}

TEST(ReadBag, SaysWhyNothingIsUsable) {
  const auto without = [](auto& fix) { fix.status.status = -1; };
  EXPECT_NE(failure_of(with_each<sensor_msgs::NavSatFix>(record({}), without), {})
                .find("no usable fix or epoch (/gps/fix: no fix, 21 times)"),
            std::string::npos);
  const auto unstamped = [](auto& odometry) { odometry.header.stamp = ros::Time(0); };
  EXPECT_NE(failure_of(with_each<nav_msgs::Odometry>(record({}), unstamped), {})
                .find("no usable odometry (/odom: zero stamp, 21 times)"),
            std::string::npos);
}

TEST(ReadBag, SaysHowFarFixesAndTruthAreApart) {
  const auto ahead = [](auto& fix) { fix.header.stamp += ros::Duration(7200.0); };
  EXPECT_NE(
      failure_of(with_each<sensor_msgs::NavSatFix>(record({}), ahead), {}).find("begin 7200.0 s after it"),
      std::string::npos);
}

TEST(ReadBag, NamesOdometryThatIsTheOutputOfALocalisation) {
  const auto in_map = [](auto& odometry) { odometry.header.frame_id = "/map"; };
  const Drive drive = read_bag(with_each<nav_msgs::Odometry>(record({}), in_map), {}, kDatum);
  ASSERT_FALSE(drive.notices.empty());
  EXPECT_NE(drive.notices.back().find("odometry is in frame map"), std::string::npos);
}

TEST(ReadBag, RefusesMessagesOfAnotherVersion) {
  Recording recording;
  recording.with_epoch = recording.with_pair = true;
  const std::string file = record(recording);
  for (const auto& [topic, type] :
       std::map<std::string, std::string>{{"/odom", "nav_msgs/Odometry"},
                                          {"/gps/fix", "sensor_msgs/NavSatFix"},
                                          {"/gps/left/fix", "sensor_msgs/NavSatFix"},
                                          {"/gnss/epoch", "multipath_localization/GnssEpoch"},
                                          {"/tf_static", "tf2_msgs/TFMessage"},
                                          {"/truth", "geometry_msgs/PoseStamped"},
                                          {"/truth/bias", "geometry_msgs/Vector3Stamped"}}) {
    for (const char* md5sum : {"*", "0123456789abcdef0123456789abcdef"}) {
      const std::string other = with_other_version(file, topic, md5sum);
      EXPECT_EQ(failure_of(other, {}), other + ": " + topic + " is a " + type + " of another version");
    }
  }
}

TEST(ReadBag, RefusesATopicOfTwoTypes) {
  const std::string file = record({});
  {
    rosbag::Bag bag(file, rosbag::bagmode::Append);
    bag.write("/gps/fix", ros::Time(1021.0), odometry_at(1021.0));
    bag.write("/gps/fix", ros::Time(1022.0), fix_at(1022.0, {5.0, 22.0}));
  }
  BagTopics asked;
  asked.odometry = "odom";
  EXPECT_NE(failure_of(file, asked).find("/gps/fix is a nav_msgs/Odometry, not a sensor_msgs/NavSatFix"),
            std::string::npos);
}

/// Odometry and fixes of later seconds behind those of a recording.
std::string recorded_on(double first, double last) {
  const std::string file = record({});
  rosbag::Bag bag(file, rosbag::bagmode::Append);
  for (double stamp = first; stamp <= last; stamp += 1.0) {
    const ros::Time recorded(2000.0 + stamp);
    bag.write("/odom", recorded, odometry_at(stamp));
    bag.write("/gps/fix", recorded, fix_at(stamp, {5.0, 20.0}));
  }
  return file;
}

TEST(ReadBag, ASilenceOfOdometryIsARestart) {
  const Drive drive = read_bag(recorded_on(1028.0, 1032.0), {}, kDatum);
  ASSERT_EQ(drive.restarts.size(), 1u);
  EXPECT_DOUBLE_EQ(drive.restarts.front(), 1029.0) << "as the node, which takes the second one after it";
  EXPECT_EQ(drive.odometry.size(), 21u + 4u);
  EXPECT_EQ(drive.fixes().size(), 21u + 5u);
  ASSERT_FALSE(drive.notices.empty());
  EXPECT_NE(drive.notices.front().find("no odometry for 9.0 s from 1020.00 on (20.0 s from the start)"),
            std::string::npos)
      << drive.notices.front();
}

TEST(ReadBag, RefusesTimeThatGoesBack) {
  EXPECT_NE(failure_of(recorded_on(900.0, 905.0), {}).find("/odom goes back in time, from 1020.0"),
            std::string::npos);
}

}  // namespace
}  // namespace multipath_localization
