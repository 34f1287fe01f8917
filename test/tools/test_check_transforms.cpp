#include "found.hpp"
#include "healthy_robot.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {
namespace {

TEST(CheckFrames, FindEmptyAndSlashedFramesOfFixes) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_frames(seen)));
  seen.fixes[0].message.header.frame_id = "";
  EXPECT_TRUE(ToFix(check_frames(seen), "header.frame_id is empty", "antenna: [X, Y]"));
  seen.fixes[0].message.header.frame_id = "/gps";
  EXPECT_TRUE(ToFix(check_frames(seen), "is /gps", "frame_id: gps"));
  for (const char* frame : {"map", "/map", "odom"}) {
    seen.fixes[0].message.header.frame_id = frame;
    EXPECT_TRUE(ToFix(check_frames(seen), "does not ride on the robot", "frame_id: gps"));
    EXPECT_TRUE(Passes(check_antenna(seen)));
  }
}

TEST(CheckFrames, NameTheParameterForOtherFramesOfOdometry) {
  Observations seen = healthy_robot();
  for (auto& odometry : seen.odometry) odometry.message.child_frame_id = "base_footprint";
  EXPECT_TRUE(
      ToFix(check_frames(seen), "child_frame_id is base_footprint", "base_link_frame: base_footprint"));
  for (auto& odometry : seen.odometry) odometry.message.header.frame_id = "wheel_odom";
  EXPECT_TRUE(ToFix(check_frames(seen), "frame_id is wheel_odom", "odom_frame: wheel_odom"));
  for (auto& odometry : seen.odometry) odometry.message.header.frame_id = "/map";
  EXPECT_TRUE(ToFix(check_frames(seen), "output of a localisation", "odom:="));
  for (auto& odometry : seen.odometry) odometry.message.header.frame_id = "";
  EXPECT_TRUE(ToFix(check_frames(seen), "odom: header.frame_id is empty", "\"odom\""));
}

TEST(CheckFrames, NeverTakeAFrameThatStandsForTheBase) {
  Observations seen = healthy_robot();
  for (auto& odometry : seen.odometry) odometry.message.child_frame_id = "odom";
  EXPECT_TRUE(ToFix(check_frames(seen), "child_frame_id is odom, which does not move",
                    "child_frame_id = \"base_link\""));
  seen = healthy_robot();
  for (auto& odometry : seen.odometry) odometry.message.header.frame_id = "base_link";
  EXPECT_TRUE(
      ToFix(check_frames(seen), "header.frame_id is base_link, which moves", "header.frame_id = \"odom\""));
}

TEST(CheckParents, FindTwoParentsAndTwoBroadcasters) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_parents(seen)));
  seen.transforms.push_back(broadcast("base_footprint", "base_link", "/state_publisher"));
  EXPECT_TRUE(ToFix(check_parents(seen),
                    "base_link has two parents: base_footprint (by /state_publisher), odom (by /base)",
                    "stop one of them"));
  seen = healthy_robot();
  seen.transforms.push_back(broadcast("odom", "/base_link", "/ekf_se_odom"));
  EXPECT_TRUE(
      ToFix(check_parents(seen), "odom -> base_link comes from /base and /ekf_se_odom", "publish_tf: false"));
}

TEST(CheckMapToOdom, FindAnotherLocalisation) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_map_to_odom(seen)));
  seen.transforms.push_back(broadcast("map", "odom", "/ekf_se_map"));
  EXPECT_TRUE(ToFix(check_map_to_odom(seen), "is in the bag, by /ekf_se_map", "bag.launch"));
  seen.from_bag = false;
  EXPECT_TRUE(ToFix(check_map_to_odom(seen), "is broadcast by /ekf_se_map", "rosnode kill /ekf_se_map"));
  seen.types["ekf_se_map/fix_report"] = "multipath_localization/FixReport";
  EXPECT_TRUE(Passes(check_map_to_odom(seen))) << "our own node";
}

TEST(CheckAntenna, WantsItKnownAndNear) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_antenna(seen)));
  seen.transforms.back().transform.transform.rotation.w = 0.0;
  seen.transforms.back().transform.transform.rotation.z = 1.0;
  EXPECT_TRUE(Passes(check_antenna(seen))) << "a point has no heading";
  seen.transforms.back() = broadcast("base_link", "gps", "/antenna", 300.0);
  EXPECT_TRUE(ToFix(check_antenna(seen), "off the robot", "in metres"));
  seen.transforms.pop_back();
  EXPECT_TRUE(ToFix(check_antenna(seen), "nobody says where gps is", "base_link -> gps"));
  seen.antenna = {0.3, -0.1};
  EXPECT_TRUE(Passes(check_antenna(seen)));
  EXPECT_NE(check_antenna(seen).front().what.find("0.30, -0.10"), std::string::npos);
}

TEST(CheckAntenna, IsNotLookedForInABaseOfAnotherName) {
  Observations seen = healthy_robot();
  seen.transforms = {broadcast("robot1/odom", "robot1/base_link", "/base"),
                     broadcast("robot1/base_link", "gps", "/antenna", 0.3)};
  for (auto& odometry : seen.odometry) odometry.message.child_frame_id = "robot1/base_link";
  EXPECT_TRUE(Untold(check_antenna(seen))) << "another transform would be one too many";
  EXPECT_TRUE(
      ToFix(check_frames(seen), "child_frame_id is robot1/base_link", "base_link_frame: robot1/base_link"));
}

TEST(CheckAntenna, FollowsTheTreeToTheBase) {
  Observations seen = healthy_robot();
  seen.transforms = {broadcast("/base_footprint", "/base_link", "/state", -0.5),
                     broadcast("/base_footprint", "/gps", "/state", 0.4)};
  EXPECT_TRUE(Passes(check_antenna(seen)));
  EXPECT_NE(check_antenna(seen).front().what.find("gps is at 0.90, 0.00, 0.00 in base_link"),
            std::string::npos);
  seen.transforms.erase(seen.transforms.begin());
  EXPECT_TRUE(ToFix(check_antenna(seen), "nobody says where gps is", "base_link -> gps"));
}

TEST(CheckAntenna, NamesWhatIsNoMast) {
  Observations seen = healthy_robot();
  seen.transforms.push_back(broadcast("base_link", "gps", "/turret", 0.9));
  EXPECT_TRUE(ToFix(check_antenna(seen), "moves on the robot", "antenna: [X, Y]"));
  seen.transforms = {broadcast("odom", "gps", "/beacon"), broadcast("odom", "base_link", "/base")};
  EXPECT_TRUE(ToFix(check_antenna(seen), "does not ride on the robot", "antenna: [X, Y]"));
}

}  // namespace
}  // namespace multipath_localization
