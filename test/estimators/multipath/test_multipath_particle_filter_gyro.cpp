#include <gtest/gtest.h>

#include <cmath>

#include "default_localizer.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

constexpr int kSeeds = 5;
constexpr double kSettled = 60.0;  ///< [s]

/// A skid steer whose wheels see 10 to 30 % more of a turn than there is, by the ground, and a gyro that is
/// off by `bias` [rad/s], of that sign and scale, where there is one.
struct SkidSteer {
  bool has_gyro = true;
  double gain = 1.0;
  double bias = 0.01;
};

/// Heading RMSE over three minutes of winding road behind the first one [rad].
double heading_rmse(const SkidSteer& robot, std::uint64_t seed) {
  Localizer localizer = default_localizer(seed);
  SimulatedDrive drive(seed);
  drive.fix_sigma = 1.0;
  drive.spoilt = [&](const OdometryIncrement& u) {
    const double true_rate = u.yaw_rate - drive.errors.gyro_bias;
    RandomStream random(seed, static_cast<std::uint32_t>(std::lround(20.0 * u.stamp)), 77);
    const double rate = robot.gain * true_rate + robot.bias + 0.003 * random.normal();
    if (robot.has_gyro) localizer.add(YawRate{u.stamp - 0.5 * u.duration, rate});
    OdometryIncrement skidding = u;
    skidding.yaw_rate = true_rate * (1.2 + 0.1 * std::sin(0.11 * u.stamp));
    return skidding;
  };
  double squares = 0.0;
  int count = 0;
  drive.run(localizer, 240.0, [&] {
    if (drive.time < kSettled) return;
    squares += std::pow(angle_difference(localizer.estimate().pose.yaw, drive.truth.yaw), 2);
    ++count;
  });
  return std::sqrt(squares / count);
}

double mean_heading_rmse(const SkidSteer& robot) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) sum += heading_rmse(robot, seed);
  return sum / kSeeds;
}

double by_wheels_alone() {
  SkidSteer robot;
  robot.has_gyro = false;
  static const double kRmse = mean_heading_rmse(robot);
  return kRmse;
}

TEST(MultipathParticleFilterGyro, KnowsTheHeadingOfASkidSteerByIt) {
  EXPECT_LT(mean_heading_rmse({}), 0.5 * by_wheels_alone());
}

TEST(MultipathParticleFilterGyro, IsNotRuinedByOneOfTheOtherSign) {
  SkidSteer robot;
  robot.gain = -1.0;
  EXPECT_LT(mean_heading_rmse(robot), 1.2 * by_wheels_alone());
}

TEST(MultipathParticleFilterGyro, IsNotRuinedByOneInDegrees) {
  SkidSteer robot;
  robot.gain = 57.3;
  EXPECT_LT(mean_heading_rmse(robot), 1.2 * by_wheels_alone());
}

}  // namespace
}  // namespace multipath_localization
