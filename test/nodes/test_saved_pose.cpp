#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "../evaluation/temporary_folder.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "nodes/saved_pose.hpp"

namespace multipath_localization {
namespace {

SavedPose some_pose() {
  SavedPose saved;
  saved.datum = {52.504570117, 13.373662771, 76.0109};
  saved.stamp = 2e9 + 0.123456;
  saved.base_in_map = {12.5, -7.25, 3.0};
  saved.covariance << 0.5, 0.1, 0.02, 0.1, 0.4, -0.01, 0.02, -0.01, 0.003;
  saved.base_in_odom = {1.0, 2.0, 0.5};
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
  EXPECT_EQ(read->stamp, saved.stamp);
  EXPECT_EQ(read->base_in_map.yaw, saved.base_in_map.yaw);
  EXPECT_EQ(read->covariance, saved.covariance);
  EXPECT_EQ(read->base_in_odom.y, saved.base_in_odom.y);
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
                                 {"odom: [1, ", "odom: ["}}) {
    std::string changed = text;
    ASSERT_NE(changed.find(from), std::string::npos) << from;
    folder.write("pose.yaml", changed.replace(changed.find(from), std::string(from).size(), to));
    EXPECT_THROW(read_saved_pose(file), ParameterError) << to;
  }
}

TEST(Resumed, RollsOnByTheOdometryOfTheTimeBetween) {
  const SavedPose saved = some_pose();
  const Pose2 rolled{2.0, 0.5, 0.25};
  const auto answer = resumed(saved, saved.stamp + 3.0, saved.base_in_odom * rolled, 60.0);
  ASSERT_TRUE(std::holds_alternative<PosePrior>(answer));
  const auto& prior = std::get<PosePrior>(answer);
  const Pose2 expected = saved.base_in_map * rolled;
  EXPECT_NEAR(prior.pose.x, expected.x, 1e-9);
  EXPECT_NEAR(prior.pose.y, expected.y, 1e-9);
  EXPECT_NEAR(angle_difference(prior.pose.yaw, expected.yaw), 0.0, 1e-9);
  EXPECT_EQ(prior.stamp, saved.stamp + 3.0);
  EXPECT_TRUE(prior.confirmed);
  EXPECT_GE(prior.covariance(0, 0), saved.covariance(0, 0));
}

TEST(Resumed, IsToBeConfirmedAgainWhenTheOdometryBeganAnew) {
  const SavedPose saved = some_pose();
  const auto answer = resumed(saved, saved.stamp + 3.0, Pose2{-500.0, 0.0, 0.0}, 60.0);
  ASSERT_TRUE(std::holds_alternative<PosePrior>(answer));
  EXPECT_EQ(std::get<PosePrior>(answer).pose.x, saved.base_in_map.x);
  EXPECT_FALSE(std::get<PosePrior>(answer).confirmed);
}

TEST(Resumed, NamesTheReasonOfWhatDoesNotCount) {
  const SavedPose saved = some_pose();
  const auto old = resumed(saved, saved.stamp + 61.5, saved.base_in_odom, 60.0);
  ASSERT_TRUE(std::holds_alternative<std::string>(old));
  EXPECT_EQ(std::get<std::string>(old), "it is 61.5 s old");
  const auto later = resumed(saved, saved.stamp - 5.0, saved.base_in_odom, 60.0);
  ASSERT_TRUE(std::holds_alternative<std::string>(later));
  EXPECT_EQ(std::get<std::string>(later), "it was saved 5.0 s after the odometry that comes now");
}

}  // namespace
}  // namespace multipath_localization
