#include <gtest/gtest.h>

#include "evaluation/random_drive.hpp"

namespace multipath_localization {
namespace {

TEST(RandomDrive, IsTheSameForTheSameSeed) {
  const RandomDrive a = random_drive(5);
  const RandomDrive b = random_drive(5);
  ASSERT_EQ(a.drive.odometry.size(), b.drive.odometry.size());
  for (std::size_t i = 0; i < a.drive.odometry.size(); ++i) {
    ASSERT_EQ(a.drive.odometry[i].speed, b.drive.odometry[i].speed);
    ASSERT_EQ(a.drive.odometry[i].yaw_rate, b.drive.odometry[i].yaw_rate);
  }
  const std::vector<GnssFix> fixes = a.drive.fixes();
  const std::vector<GnssFix> again = b.drive.fixes();
  ASSERT_EQ(fixes.size(), again.size());
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    ASSERT_EQ(fixes[i].position, again[i].position);
    ASSERT_EQ(fixes[i].covariance, again[i].covariance);
  }
}

TEST(RandomDrive, HasTruthOfEveryFixAndOfEveryOneWhatIsWrongWithIt) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const RandomDrive made = random_drive(seed);
    const std::vector<GnssFix> fixes = made.drive.fixes();
    ASSERT_EQ(fixes.size(), made.fix_truths.size());
    for (std::size_t i = 0; i < fixes.size(); ++i) {
      const auto truth = truth_at(made.drive.truth, fixes[i].stamp);
      ASSERT_TRUE(truth);
      ASSERT_EQ(truth->stamp, fixes[i].stamp);
      const bool shadow = made.fix_truths[i].fault == FixFault::kShadow;
      ASSERT_TRUE(*truth->shadow || !shadow);
    }
    EXPECT_EQ(made.drive.odometry.size(), made.without_faults.size());
    EXPECT_EQ(made.drive.name, "random_" + std::to_string(seed));
  }
}

TEST(RandomDrive, StaysTheSameRobotWithAGyroAndVelocities) {
  const RandomDrive without = random_drive(9);
  const RandomDrive with = random_drive(9, {true, true});
  EXPECT_TRUE(without.drive.yaw_rates.empty());
  EXPECT_GT(with.drive.yaw_rates.size(), 1000u);
  EXPECT_GT(with.drive.measurements.size(), without.drive.measurements.size());
  EXPECT_EQ(with.drive.odometry.back().yaw_rate, without.drive.odometry.back().yaw_rate);
  ASSERT_EQ(with.drive.fixes().size(), without.drive.fixes().size());
  EXPECT_EQ(with.drive.fixes().back().position, without.drive.fixes().back().position);
}

TEST(RandomDrive, StaysTheSameRobotWithHeadings) {
  const RandomDrive without = random_drive(9);
  const RandomDrive with = random_drive(9, {false, false, false, true});
  EXPECT_GT(with.drive.measurements.size(), without.drive.measurements.size() + 100u);
  EXPECT_EQ(with.drive.fixes().back().position, without.drive.fixes().back().position);
}

TEST(RandomDrive, TellsTheLevelsOfRtkAlone) {
  int told = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomDrive made = random_drive(seed, {false, false, false, false, true});
    const bool rtk = made.robot.receiver.kind == ReceiverKind::kRtk;
    const std::vector<GnssFix> fixes = made.drive.fixes();
    for (std::size_t i = 0; i < fixes.size(); ++i) {
      ASSERT_EQ(fixes[i].level != FixLevel::kUntold, rtk);
      ASSERT_EQ(fixes[i].level == FixLevel::kFixed, rtk && made.fix_truths[i].level == kFixed);
    }
    told += rtk ? 1 : 0;
  }
  EXPECT_GT(told, 1);
}

TEST(RandomDrive, HasASecondReceiverBesideTheFirst) {
  const RandomDrive without = random_drive(9);
  const RandomDrive with = random_drive(9, {false, false, true});
  EXPECT_EQ(without.drive.receivers(), 1u);
  ASSERT_EQ(with.drive.receivers(), 2u);
  EXPECT_EQ(with.drive.fixes().back().position, without.drive.fixes().back().position);
  EXPECT_EQ(with.drive.fixes(1).front().antenna_in_base, Eigen::Vector2d(0.0, -0.8));
  EXPECT_EQ(with.fix_truths.size(), with.drive.fixes().size());
}

}  // namespace
}  // namespace multipath_localization
