#include <gtest/gtest.h>

#include "noisy_drive.hpp"
#include "tools/tuning/noise_fit.hpp"

namespace multipath_localization {
namespace {

constexpr std::uint64_t kSeeds = 2;

NoiseFit fit(const NoisyDrive& robot, std::uint64_t seed) {
  const Drive drive = robot.record(seed);
  return fit_noise(drive.odometry, drive.fixes());
}

/// Told, and within a factor of two of the truth.
void expect_told(const Told& number, double truth, const std::string& what) {
  EXPECT_TRUE(number.told()) << what << " " << number.low << ".." << number.high;
  EXPECT_GT(number.value, truth / 2.0) << what;
  EXPECT_LT(number.value, truth * 2.0) << what;
}

TEST(NoiseFit, TellsCoarseOdometryFromCoarseFixes) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const NoiseFit told = fit({{0.2, 0.02, 0.3, 0.3, 20.0}}, seed);
    expect_told(told.distance, 0.2, "distance");
    expect_told(told.yaw, 0.02, "yaw");
    expect_told(told.white, 0.3, "white");
    EXPECT_NEAR(told.scale.value, 0.01, 4.0 * told.scale.sigma);
    EXPECT_NEAR(told.gyro_bias.value, 0.003, 4.0 * told.gyro_bias.sigma);
  }
}

TEST(NoiseFit, TellsFineOdometryByFineFixes) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const NoiseFit told = fit({{0.006, 0.003, 0.01, 0.01, 20.0}}, seed);
    expect_told(told.distance, 0.006, "distance");
    expect_told(told.yaw, 0.003, "yaw");
    expect_told(told.white, 0.01, "white");
  }
}

TEST(NoiseFit, BoundsOdometryThatFixesAreTooCoarseFor) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const NoiseFit told = fit({{0.006, 0.003, 0.4, 0.5, 20.0}}, seed);
    EXPECT_FALSE(told.distance.told());
    EXPECT_TRUE(told.distance.high_told);
    EXPECT_GT(told.distance.high, 0.006);
    EXPECT_LT(told.distance.high, 0.12);
    EXPECT_GT(told.yaw.high, 0.003 / 1.5);
    EXPECT_LT(told.yaw.high, 0.012);
    expect_told(told.white, 0.4, "white");
    expect_told(told.wander, 0.5, "wander");
    EXPECT_GT(told.wander_time.high, 10.0);
    EXPECT_LT(told.wander_time.low, 40.0);
  }
}

TEST(NoiseFit, TellsTheDelayOfTheStamps) {
  for (const double delay : {-0.15, 0.3}) {
    NoisyDrive robot{{0.006, 0.003, 0.2, 0.3, 20.0}};
    robot.duration = 150.0;
    robot.delay = delay;
    const NoiseFit told = fit(robot, 1);
    EXPECT_TRUE(told.delay.low_told);
    EXPECT_NEAR(told.delay.value, delay, 0.06);
    EXPECT_LT(told.delay.low, delay);
    EXPECT_GT(told.delay.high, delay);
    EXPECT_LT(told.delay.high - told.delay.low, 0.2);
  }
}

TEST(NoiseFit, TellsNoDelayByOdometryThatLeaps) {
  NoisyDrive robot{{0.006, 0.003, 0.2, 0.3, 20.0}};
  robot.duration = 150.0;
  robot.delay = 0.3;
  Drive drive = robot.record(1);
  const NoiseFit steady = fit_noise(drive.odometry, drive.fixes());
  EXPECT_FALSE(steady.odometry_leaps);
  EXPECT_TRUE(steady.delay.low_told);
  for (std::size_t i = 500; i < drive.odometry.size(); i += 500) {
    drive.odometry[i].speed += 0.4 / drive.odometry[i].duration;  // an encoder that makes up 0.4 m of ticks
  }
  const NoiseFit leaping = fit_noise(drive.odometry, drive.fixes());
  EXPECT_TRUE(leaping.odometry_leaps);
  EXPECT_FALSE(leaping.delay.low_told);
}

TEST(NoiseFit, LoneOutliersCountForLittle) {
  Drive drive = NoisyDrive{{0.02, 0.01, 0.2, 0.3, 20.0}, 200.0}.record(1);
  std::vector<GnssFix> fixes = drive.fixes();
  for (std::size_t i = 30; i < fixes.size(); i += 60) fixes[i].position.x() += 20.0;
  const NoiseFit told = fit_noise(drive.odometry, fixes);
  expect_told(told.white, 0.2, "white");
  EXPECT_LT(told.yaw.low, 0.01);
  EXPECT_GT(told.yaw.high, 0.01);
  EXPECT_LT(told.yaw.high, 0.03);
}

TEST(NoiseFit, SaysNothingOfARobotThatStands) {
  Drive drive = NoisyDrive{}.record(1);
  for (OdometryIncrement& increment : drive.odometry) increment.speed = increment.yaw_rate = 0.0;
  const NoiseFit told = fit_noise(drive.odometry, drive.fixes());
  EXPECT_FALSE(told.distance.told());
  EXPECT_FALSE(told.white.told());
  EXPECT_FALSE(told.delay.low_told);
}

}  // namespace
}  // namespace multipath_localization
