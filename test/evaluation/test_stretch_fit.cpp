#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "multipath_localization/evaluation/stretch_fit.hpp"
#include "tuning_drive.hpp"

namespace multipath_localization {
namespace {

/// Fixes of a drive of two minutes, but for the first and the last five seconds.
std::vector<GnssFix> inner_fixes(const Drive& drive) {
  std::vector<GnssFix> inner;
  for (const GnssFix& fix : drive.fixes()) {
    if (fix.stamp > 1e6 + 5.0 && fix.stamp < 1e6 + 115.0) inner.push_back(fix);
  }
  return inner;
}

TEST(FitStretch, FindsScaleGyroBiasAndDelayOfPerfectSensors) {
  KnownSensors sensors;
  sensors.distance = sensors.yaw = sensors.white = 0.0;
  sensors.delay = 0.35;
  const Drive drive = tuning_drive(sensors, 2.0, 1);
  const auto fit = fit_stretch(drive.odometry, inner_fixes(drive));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->scale, 1.0 / 1.02, 1e-3);
  EXPECT_NEAR(fit->gyro_bias, 0.004, 1e-4);
  EXPECT_NEAR(fit->delay, 0.35, 0.01);
  EXPECT_LT(fit->rms, 0.02);
  EXPECT_NEAR(fit->duration, 110.0, 0.5);
  EXPECT_NEAR(fit->way, 132.0, 20.0);
}

TEST(FitStretch, IsAsSureAsItIsRight) {
  KnownSensors sensors;
  sensors.distance = sensors.yaw = 0.0;
  double nees = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Drive drive = tuning_drive(sensors, 2.0, seed);
    const auto fit = fit_stretch(drive.odometry, inner_fixes(drive));
    ASSERT_TRUE(fit);
    const Eigen::Vector3d error(fit->scale - 1.0 / 1.02, fit->gyro_bias - 0.004, fit->delay);
    nees += error.dot(fit->covariance.ldlt().solve(error)) / 20.0;
  }
  EXPECT_GT(nees, 1.2);  // 3 in the mean, over 60 degrees of freedom
  EXPECT_LT(nees, 5.5);
}

TEST(FitStretch, AFewFixesFarOffChangeLittle) {
  KnownSensors sensors;
  sensors.distance = sensors.yaw = 0.0;
  const Drive drive = tuning_drive(sensors, 2.0, 1);
  std::vector<GnssFix> fixes = inner_fixes(drive);
  for (std::size_t i = 0; i < fixes.size(); i += 20) fixes[i].position.x() += 30.0;
  const auto fit = fit_stretch(drive.odometry, fixes);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->scale, 1.0 / 1.02, 0.005);
  EXPECT_NEAR(fit->gyro_bias, 0.004, 5e-4);
}

TEST(FitStretch, WantsFixesMotionAndOdometryAllThrough) {
  const Drive drive = tuning_drive({}, 2.0, 1);
  const std::vector<GnssFix> fixes = inner_fixes(drive);
  EXPECT_FALSE(fit_stretch(drive.odometry, {fixes.begin(), fixes.begin() + 10}));
  EXPECT_FALSE(fit_stretch(drive.odometry, drive.fixes())) << "odometry ends with the fixes";
  std::vector<OdometryIncrement> holed = drive.odometry;
  holed.erase(holed.begin() + 500, holed.begin() + 600);
  EXPECT_FALSE(fit_stretch(holed, fixes));
  std::vector<OdometryIncrement> parked = drive.odometry;
  for (OdometryIncrement& increment : parked) increment.speed = 0.0;
  EXPECT_FALSE(fit_stretch(parked, fixes));
}

}  // namespace
}  // namespace multipath_localization
