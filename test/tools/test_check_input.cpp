#include "found.hpp"
#include "healthy_robot.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {
namespace {

TEST(CheckTopics, NamesTheOneTopicOfTheType) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_topics(seen)));
  seen.types = {{"ublox/fix", "sensor_msgs/NavSatFix"}, {"odom", "nav_msgs/Odometry"}};
  EXPECT_TRUE(ToFix(check_topics(seen), "nothing on /gps/fix", "bag.launch bag:=FILE fix_topic:=/ublox/fix"));
  seen.from_bag = false;
  EXPECT_TRUE(ToFix(check_topics(seen), "/ublox/fix", "localization.launch fix:=/ublox/fix"));
}

TEST(CheckTopics, NeverNamesTheOutputOfALocalisation) {
  Observations seen = healthy_robot();
  seen.fixes.clear();
  seen.odometry.clear();
  seen.types = {{"gps/filtered", "sensor_msgs/NavSatFix"},
                {"robot/odometry/filtered_map", "nav_msgs/Odometry"},
                {"robot/odometry/gps", "nav_msgs/Odometry"}};
  EXPECT_TRUE(ToFix(check_topics(seen), "no message on /gps/fix", "start the driver"));
  EXPECT_TRUE(ToFix(check_topics(seen), "no message on /odom", "start the driver"));
  seen.types["wheels"] = "nav_msgs/Odometry";
  EXPECT_TRUE(ToFix(check_topics(seen), "nothing on /odom", "odom_topic:=/wheels"));
}

TEST(CheckTopics, SayWhenATopicIsOfAnotherTypeOrNotThere) {
  Observations seen = healthy_robot();
  seen.types = {{"gps/fix", "sensor_msgs/NavSatStatus"}, {"odom", "nav_msgs/Odometry"}};
  seen.fixes.clear();
  EXPECT_TRUE(
      ToFix(check_topics(seen), "is a sensor_msgs/NavSatStatus, not a", "publish sensor_msgs/NavSatFix"));
  seen.types.clear();
  seen.odometry.clear();
  EXPECT_TRUE(ToFix(check_topics(seen), "no message on /odom", "--odom-topic"));
}

TEST(CheckTopics, KnowOfWhatOdometryCouldBeMade) {
  Observations seen = healthy_robot();
  seen.odometry.clear();
  seen.types = {{"gps/fix", "sensor_msgs/NavSatFix"}, {"joint_states", "sensor_msgs/JointState"}};
  EXPECT_TRUE(
      ToFix(check_topics(seen), "no message on /odom", "/joint_states become odometry: robot.launch"));
  seen.types["car/drive"] = "ackermann_msgs/AckermannDriveStamped";
  EXPECT_TRUE(ToFix(check_topics(seen), "no message on /odom", "/car/drive become odometry: robot.launch"));
}

TEST(CheckTopics, TellAnotherVersionFromAMissingTopic) {
  Observations seen = healthy_robot();
  seen.odometry.clear();
  seen.other_versions = {{"odom", "nav_msgs/Odometry"}, {"tf_static", "tf2_msgs/TFMessage"}};
  EXPECT_TRUE(ToFix(check_topics(seen), "/odom is a nav_msgs/Odometry of another version", "rosbag check"));
  EXPECT_TRUE(
      ToFix(check_topics(seen), "/tf_static is a tf2_msgs/TFMessage of another version", "rosbag check"));
  EXPECT_FALSE(ToFix(check_topics(seen), "no message", ""));
}

TEST(CheckRates, WantOdometryOftenAndWithoutGaps) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_rates(seen)));
  for (std::size_t i = 0; i < seen.odometry.size(); ++i)
    seen.odometry[i].time = 1000.0 + 0.2 * static_cast<double>(i);
  EXPECT_TRUE(ToFix(check_rates(seen), "odom: 5.00 Hz", "10 Hz or more"));
  seen = healthy_robot();
  seen.odometry.erase(seen.odometry.begin() + 100, seen.odometry.begin() + 300);
  EXPECT_TRUE(ToFix(check_rates(seen), "longest gap 10.05 s", "max_gap: 11"));
}

TEST(CheckRates, DoNotTakeATunnelForASlowReceiver) {
  Observations seen = healthy_robot();
  for (std::size_t i = 20; i < seen.fixes.size(); ++i) seen.fixes[i].time += 2000.0;
  EXPECT_TRUE(Passes(check_rates(seen)));
  EXPECT_NE(check_rates(seen).front().what.find("5.00 Hz, longest gap 2000"), std::string::npos);
}

TEST(CheckStamps, FindZeroBackwardAndRepeatedOnes) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_stamps(seen)));
  seen.fixes[7].message.header.stamp = ros::Time();
  EXPECT_TRUE(ToFix(check_stamps(seen), "fix: 1 stamps of zero", "ros::Time::now()"));
  seen = healthy_robot();
  std::swap(seen.odometry[7], seen.odometry[8]);
  EXPECT_TRUE(ToFix(check_stamps(seen), "odom: 1 stamps go back", "rostopic info /odom"));
  seen = healthy_robot();
  seen.odometry.insert(seen.odometry.begin() + 7, seen.odometry[7]);
  EXPECT_TRUE(ToFix(check_stamps(seen), "odom: 1 stamps come twice", "rostopic info /odom"));
}

TEST(CheckClocks, FindAReceiverOnAnotherClock) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_clocks(seen)));
  for (auto& fix : seen.fixes) fix.message.header.stamp += ros::Duration(18.0);
  EXPECT_TRUE(ToFix(check_clocks(seen), "17.91 s ahead of the odometry", "chronyc makestep"));
  seen = healthy_robot();
  for (auto& fix : seen.fixes) fix.time += 7.0;
  EXPECT_TRUE(ToFix(check_clocks(seen), "7.1 s late", "history_length: 9"));
}

TEST(CheckClocks, SayNothingOfStampsThatNobodyFillsIn) {
  Observations seen = healthy_robot();
  for (auto& fix : seen.fixes) fix.message.header.stamp = ros::Time(0);
  EXPECT_TRUE(check_clocks(seen).empty());
}

TEST(CheckClocks, LiveTheHostsClockCounts) {
  Observations seen = healthy_robot();
  for (auto& odometry : seen.odometry) odometry.time += 60.0;
  for (auto& fix : seen.fixes) fix.time += 60.0;
  EXPECT_TRUE(Passes(check_clocks(seen))) << "a bag may have been recorded while another was played";
  seen.from_bag = false;
  EXPECT_TRUE(ToFix(check_clocks(seen), "odom: stamped 60.0 s behind the host's clock", "chronyc"));
}

TEST(CheckSimulatedTime, FindsClockAndParameterAtOdds) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(check_simulated_time(seen).empty());
  seen.clock = true;
  EXPECT_TRUE(ToFix(check_simulated_time(seen), "holds /clock", "rosbag filter"));
  seen.from_bag = false;
  EXPECT_TRUE(
      ToFix(check_simulated_time(seen), "/use_sim_time is not set", "rosparam set use_sim_time true"));
  seen.use_sim_time = true;
  EXPECT_TRUE(Passes(check_simulated_time(seen)));
  seen.clock = false;
  EXPECT_TRUE(ToFix(check_simulated_time(seen), "nobody publishes /clock", "rosbag play --clock"));
}

TEST(Diagnose, AHealthyRobotHasNothingToFix) {
  const Findings all = diagnose(healthy_robot());
  EXPECT_TRUE(Passes(all));
  for (const Finding& finding : all) EXPECT_EQ(finding.verdict, Finding::Verdict::kPass) << finding.what;
  EXPECT_GE(all.size(), 20U);
}

TEST(Diagnose, NothingAtAllIsSaidToBeMissing) {
  EXPECT_TRUE(ToFix(diagnose(Observations{}), "no message on /gps/fix", "start the driver"));
}

}  // namespace
}  // namespace multipath_localization
