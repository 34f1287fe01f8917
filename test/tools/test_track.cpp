#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <sensor_msgs/NavSatFix.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "multipath_localization/guidance/waypoint_file.hpp"
#include "support/csv.hpp"
#include "tools/track/track.hpp"

namespace multipath_localization {
namespace {

namespace fs = std::filesystem;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const std::string kTopic = "/gps/filtered";

sensor_msgs::NavSatFix fix(double stamp, double latitude, double altitude = 30.0) {
  sensor_msgs::NavSatFix message;
  message.header.stamp = ros::Time(stamp);
  message.latitude = latitude;
  message.longitude = 139.0;
  message.altitude = altitude;
  return message;
}

class Track : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string bag_of(const std::vector<sensor_msgs::NavSatFix>& fixes) const {
    const std::string file = folder_ / "a.bag";
    rosbag::Bag bag(file, rosbag::bagmode::Write);
    for (const auto& message : fixes) bag.write(kTopic, message.header.stamp, message);
    return file;
  }

  std::string refusal(const std::string& bag, const std::string& topic) const {
    try {
      read_track(bag, topic);
    } catch (const DriveError& error) {
      return error.what();
    }
    return "";
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / "track_test";
};

TEST_F(Track, HasAPointForEachStepAndTheLast) {
  std::vector<sensor_msgs::NavSatFix> fixes;
  for (int i = 0; i <= 100; ++i) fixes.push_back(fix(1e9 + i, 35.0 + i * 1e-7));  // 11 mm apart
  const std::vector<TrackPoint> track = read_track(bag_of(fixes), kTopic);
  ASSERT_EQ(track.size(), 7U) << "1.1 m, every 0.2 m";
  EXPECT_EQ(track.front().place.latitude_deg, 35.0);
  EXPECT_EQ(track.back().place.latitude_deg, fixes.back().latitude);
}

TEST_F(Track, LeavesOutWhatIsNoPlace) {
  sensor_msgs::NavSatFix none = fix(1e9 + 1, 36.0);
  none.status.status = sensor_msgs::NavSatStatus::STATUS_NO_FIX;
  EXPECT_EQ(read_track(bag_of({fix(1e9, 35.0), none, fix(1e9 + 2, kNaN), fix(1e9 + 3, 91.0)}), kTopic).size(),
            1U);
  EXPECT_NE(refusal(bag_of({none}), kTopic).find("tells no place"), std::string::npos);
}

TEST_F(Track, NamesTheTopicsThereAre) {
  const std::string bag = bag_of({fix(1e9, 35.0)});
  EXPECT_NE(
      refusal(bag, "/gps/fix").find("no topic /gps/fix; of sensor_msgs/NavSatFix there are: /gps/filtered"),
      std::string::npos);
  EXPECT_NE(refusal(folder_ / "missing.bag", kTopic), "");
}

TEST_F(Track, IsReadBackAsARoute) {
  const std::vector<TrackPoint> track = {{ros::Time(1700000000.5), {35.123456789, 139.5, 30.25}},
                                         {ros::Time(1700000001.0), {35.2, -139.5, kNaN}}};
  const std::string gpx = gpx_of(track);
  EXPECT_NE(gpx.find("<ele>30.250</ele><time>2023-11-14T22:13:20.500000Z</time>"), std::string::npos) << gpx;
  EXPECT_EQ(gpx.find("nan"), std::string::npos);
  for (const auto& [name, text] : {std::pair{"a.gpx", gpx}, {"a.geojson", geojson_of(track)}}) {
    std::ofstream(folder_ / name) << text;
    const WaypointList read = read_waypoints(folder_ / name).value();
    ASSERT_EQ(read.points.size(), 2U) << name;
    EXPECT_LT((read.points[0] - Eigen::Vector2d(35.123456789, 139.5)).norm(), 1e-9) << name;
    EXPECT_LT((read.points[1] - Eigen::Vector2d(35.2, -139.5)).norm(), 1e-9) << name;
  }
}

}  // namespace
}  // namespace multipath_localization
