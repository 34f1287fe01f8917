#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "default_localizer.hpp"
#include "shares.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

OdometryIncrement sound(const OdometryIncrement& u) { return u; }

OdometryIncrement standing_wheels(const OdometryIncrement& u) { return {u.stamp, u.duration, 0.0, 0.0}; }

/// The left wheel stands, of two that are 0.6 m apart.
OdometryIncrement dead_left_encoder(const OdometryIncrement& u) {
  const double right = u.speed + 0.3 * u.yaw_rate;
  return {u.stamp, u.duration, 0.5 * right, right / 0.6};
}

TEST(MultipathParticleFilter, SaysThatOdometryContradictsTheFixesWhileWheelsAreLocked) {
  SimulatedDrive robot(2);
  Localizer localizer = default_localizer(2);
  robot.run(localizer, 60.0);
  robot.spoilt = standing_wheels;
  double probability = 0.0;
  robot.run(localizer, 20.0,
            [&] { probability = std::max(probability, localizer.estimate().wheel_fault_probability); });
  EXPECT_GT(probability, 0.8);
}

TEST(MultipathParticleFilter, GoesOnByTheFixesWhileBothWheelsAreLocked) {
  for (const double duration : {5.0, 30.0}) {
    const double kept = share_of_seeds(6, [&](std::uint64_t seed) {
      SimulatedDrive robot(seed);
      robot.bend = 0.02;
      Localizer localizer = default_localizer(seed);
      robot.run(localizer, 60.0);
      robot.spoilt = standing_wheels;
      robot.run(localizer, duration);
      robot.spoilt = sound;
      robot.run(localizer, 10.0);
      return position_error(localizer.estimate(), robot.truth).norm() < 1.5;
    });
    EXPECT_GE(kept, 0.8) << duration;
  }
}

TEST(MultipathParticleFilter, FindsTheWayBackAfterAnEncoderFailed) {
  const double back = share_of_seeds(6, [](std::uint64_t seed) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.spoilt = dead_left_encoder;
    robot.run(localizer, 10.0);
    robot.spoilt = sound;
    robot.run(localizer, 60.0);
    return position_error(localizer.estimate(), robot.truth).norm() < 2.0 &&
           nees(localizer.estimate(), robot.truth) < 14.0;
  });
  EXPECT_GE(back, 0.8);
}

TEST(MultipathParticleFilter, AnEncoderThatFailsDuringAnOutageMakesThePoseUnsure) {
  const auto after_an_outage = [](std::uint64_t seed, bool failing) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.receiving = false;
    robot.run(localizer, 10.0);
    if (failing) robot.spoilt = dead_left_encoder;
    robot.run(localizer, 3.0);
    robot.spoilt = sound;
    robot.run(localizer, 20.0);
    return std::pair(localizer.estimate().position_covariance_overall.trace(),
                     nees(localizer.estimate(), robot.truth));
  };
  double sound_variance = 0.0;
  double failing_variance = 0.0;
  const double honest = share_of_seeds(6, [&](std::uint64_t seed) {
    sound_variance += after_an_outage(seed, false).first;
    const auto [variance, error] = after_an_outage(seed, true);
    failing_variance += variance;
    return error < 9.0;
  });
  EXPECT_GT(failing_variance, 10.0 * sound_variance);
  EXPECT_GE(honest, 0.8);
}

}  // namespace
}  // namespace multipath_localization
