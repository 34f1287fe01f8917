#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "../../evaluation/temporary_folder.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "ros/localization_node/saved_pose.hpp"

namespace multipath_localization {
namespace {

SavedPose some_pose() {
  SavedPose saved;
  saved.datum = {52.504570117, 13.373662771, 76.0109};
  saved.base_in_map = {12.5, -7.25, 3.0};
  saved.covariance << 0.5, 0.1, 0.02, 0.1, 0.4, -0.01, 0.02, -0.01, 0.003;
  saved.odometry = {2e9 + 0.123456, {40.0, 2.0, 0.5}, 1.5, -0.125};
  saved.confirmed = true;
  return saved;
}

TEST(SavedPose, ComesBackAsItWas) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/state/pose.yaml";
  EXPECT_FALSE(read_saved_pose(file));
  const SavedPose saved = some_pose();
  write_saved_pose(file, saved);
  const auto read = read_saved_pose(file);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->datum.latitude_deg, saved.datum.latitude_deg);
  EXPECT_EQ(read->odometry.stamp, saved.odometry.stamp);
  EXPECT_EQ(read->base_in_map.yaw, saved.base_in_map.yaw);
  EXPECT_EQ(read->covariance, saved.covariance);
  EXPECT_EQ(read->odometry.base_in_odom.y, saved.odometry.base_in_odom.y);
  EXPECT_EQ(read->odometry.speed, saved.odometry.speed);
  EXPECT_EQ(read->odometry.yaw_rate, saved.odometry.yaw_rate);
  EXPECT_TRUE(read->confirmed);
}

TEST(SavedPose, CutAnywhereOrChangedIsDamaged) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/pose.yaml";
  write_saved_pose(file, some_pose());
  std::stringstream whole;
  whole << std::ifstream(file).rdbuf();
  const std::string text = whole.str();
  for (std::size_t length = 0; length < text.size() - 2; ++length) {
    folder.write("pose.yaml", text.substr(0, length));
    EXPECT_THROW(read_saved_pose(file), ParameterError) << length;
  }
  for (const auto& [from, to] : {std::pair("13.373", "x"),
                                 {"confirmed: true", "confirmed: 3"},
                                 {"12.5", ".nan"},
                                 {"12.5", "1e308"},
                                 {"76.0109", "1e308"},
                                 {"covariance: [", "covariance: [-"},
                                 {"covariance: [", "covariance: [1e300, 1, 0, 1, 1, 0, 0, 0, 1] #"},
                                 {"covariance: [", "covariance: [1, 2, 0, -2, 1, 0, 0, 0, 1] #"},
                                 {"52.5", "152.5"},
                                 {"stamp: 2", "stamp: .inf #"},
                                 {"motion: [", "motion: [.nan, 0] #"},
                                 {"motion", "nothing"},
                                 {"motion: [1.5, -0.125]\n", ""},
                                 {"odom: [40, ", "odom: ["}}) {
    std::string changed = text;
    ASSERT_NE(changed.find(from), std::string::npos) << from;
    folder.write("pose.yaml", changed.replace(changed.find(from), std::string(from).size(), to));
    EXPECT_THROW(read_saved_pose(file), ParameterError) << to;
  }
}

/// What is started from `age` seconds after the save.
PosePrior start(const SavedPose& saved, const Pose2& base_in_odom, double age, double speed = 0.0) {
  const auto answer = resumed(saved, {saved.odometry.stamp + age, base_in_odom, speed, 0.0}, 60.0);
  EXPECT_TRUE(std::holds_alternative<PosePrior>(answer));
  return std::get<PosePrior>(answer);
}

/// Standard deviations of the place and of the heading.
double sigma_of(const PosePrior& prior) { return std::sqrt(prior.covariance(0, 0)); }
double yaw_sigma_of(const PosePrior& prior) { return std::sqrt(prior.covariance(2, 2)); }

bool starts_at(const PosePrior& prior, const Pose2& pose) {
  const Pose2 off = inverse(pose) * prior.pose;
  return off.position().norm() < 1e-9 && std::abs(off.yaw) < 1e-9;
}

TEST(Resumed, RollsOnByTheOdometryOfTheTimeBetween) {
  const SavedPose saved = some_pose();
  const Pose2 rolled{2.0, 0.5, 0.25};
  const PosePrior prior = start(saved, saved.odometry.base_in_odom * rolled, 3.0);
  EXPECT_TRUE(starts_at(prior, saved.base_in_map * rolled));
  EXPECT_EQ(prior.stamp, saved.odometry.stamp + 3.0);
  EXPECT_TRUE(prior.confirmed);
  EXPECT_GE(prior.covariance(0, 0), saved.covariance(0, 0));
  EXPECT_LT(sigma_of(prior), 1.0);
}

TEST(Resumed, IsNoMoreConfirmedThanWhatWasSaved) {
  SavedPose saved = some_pose();
  saved.confirmed = false;
  EXPECT_FALSE(start(saved, saved.odometry.base_in_odom, 3.0).confirmed);
}

TEST(Resumed, IsToBeConfirmedAgainWhenTheOdometryBeganAnew) {
  const SavedPose saved = some_pose();
  for (const Pose2& anew : {Pose2{}, Pose2{2.0, 0.5, 0.3}, Pose2{0.0, 0.0, 3.0}}) {
    const PosePrior prior = start(saved, anew, 15.0);
    EXPECT_FALSE(prior.confirmed);
    EXPECT_TRUE(starts_at(prior, saved.base_in_map));
    EXPECT_GT(sigma_of(prior), 15.0 * saved.odometry.speed) << "it may have rolled on for that long";
    EXPECT_GT(yaw_sigma_of(prior), 1.0);
  }
}

TEST(Resumed, IsToBeConfirmedAgainWhereOdometryThatWentOnLooksLikeOneThatBeganAnew) {
  const SavedPose saved = some_pose();
  const double age = 30.0;  // for which 45 m are not too far
  EXPECT_FALSE(start(saved, {}, age).confirmed);
  EXPECT_FALSE(start(saved, saved.odometry.base_in_odom, age).confirmed);
  EXPECT_FALSE(start(saved, saved.odometry.base_in_odom, 3.0, 15.0).confirmed) << "it is fast by now";
  EXPECT_TRUE(start(saved, saved.odometry.base_in_odom, 3.0).confirmed);
}

TEST(Resumed, IsToBeConfirmedAgainWhenTheRobotTurnedMoreThanItCan) {
  const SavedPose saved = some_pose();
  const Pose2 turned = saved.odometry.base_in_odom * Pose2{0.0, 0.0, 2.8};
  EXPECT_FALSE(start(saved, turned, 1.0).confirmed);
  EXPECT_TRUE(start(saved, turned, 6.0).confirmed);
}

TEST(Resumed, OfARobotThatStoodIsAsUncertainAsTheOdometryHasMoved) {
  SavedPose saved = some_pose();
  saved.odometry.speed = saved.odometry.yaw_rate = 0.0;
  const PosePrior driven = start(saved, saved.odometry.base_in_odom * Pose2{20.0, 0.0, 2.0}, 30.0);
  EXPECT_FALSE(driven.confirmed);
  EXPECT_GE(sigma_of(driven), 20.0) << "somebody drove it by hand";
  EXPECT_GE(yaw_sigma_of(driven), 2.0);
  const PosePrior relaunched = start(saved, {}, 30.0);
  EXPECT_FALSE(relaunched.confirmed);
  EXPECT_LT(sigma_of(relaunched), 1.0);
  EXPECT_GT(yaw_sigma_of(relaunched), 0.4);
}

TEST(Resumed, IsUsableHoweverFarTheOdometryIs) {
  const SavedPose saved = some_pose();
  const PosePrior prior = start(saved, {-1e7, 1e7, 0.0}, 3.0);
  EXPECT_FALSE(prior.confirmed);
  EXPECT_TRUE(usable(prior));
}

TEST(Resumed, NamesTheReasonOfWhatDoesNotCount) {
  const SavedPose saved = some_pose();
  OdometryState now = saved.odometry;
  now.stamp = saved.odometry.stamp + 61.5;
  const auto old = resumed(saved, now, 60.0);
  ASSERT_TRUE(std::holds_alternative<std::string>(old));
  EXPECT_EQ(std::get<std::string>(old), "it is 61.5 s old");
  now.stamp = saved.odometry.stamp - 5.0;
  const auto later = resumed(saved, now, 60.0);
  ASSERT_TRUE(std::holds_alternative<std::string>(later));
  EXPECT_EQ(std::get<std::string>(later), "it was saved 5.0 s after the odometry that comes now");
}

}  // namespace
}  // namespace multipath_localization
