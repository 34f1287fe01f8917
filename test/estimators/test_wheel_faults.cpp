#include <gtest/gtest.h>

#include <algorithm>

#include "default_localizer.hpp"
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

TEST(MultipathParticleFilter, SaysThatOdometryContradictsTheFixesWhileAnEncoderFails) {
  SimulatedDrive robot(2);
  Localizer localizer = default_localizer(2);
  robot.run(localizer, 60.0);
  robot.spoilt = [](const OdometryIncrement& u) { return OdometryIncrement{u.stamp, u.duration, 0.3, 2.0}; };
  double probability = 0.0;
  std::string reason;
  robot.run(localizer, 60.0, [&] {
    if (localizer.estimate().wheel_fault_probability <= probability) return;
    probability = localizer.estimate().wheel_fault_probability;
    reason = localizer.state_reason();
  });
  EXPECT_GT(probability, 0.8);
  EXPECT_NE(reason.find("odometry contradicts the fixes"), std::string::npos) << reason;
}

TEST(MultipathParticleFilter, DoubtsThePoseAfterAnEncoderFailedAndFindsTheWayBack) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    ASSERT_TRUE(localizer.estimate().aligned);
    robot.spoilt = dead_left_encoder;
    robot.run(localizer, 10.0);
    robot.spoilt = sound;
    bool doubted = false;
    robot.run(localizer, 120.0, [&] { doubted = doubted || localizer.state() == Trust::kAligning; });
    EXPECT_TRUE(doubted) << seed;
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 2.0) << seed;
    EXPECT_LT(nees(localizer.estimate(), robot.truth), 14.0) << seed;
  }
}

TEST(MultipathParticleFilter, GoesOnByTheFixesWhileBothWheelsAreLocked) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SimulatedDrive robot(seed);
    robot.bend = 0.02;
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.spoilt = standing_wheels;
    robot.run(localizer, 5.0);
    robot.spoilt = sound;
    robot.run(localizer, 5.0);
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 1.0) << seed;
  }
}

TEST(MultipathParticleFilter, KnowsHowLittleItKnowsWhenTheWayBendsMeanwhile) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.spoilt = standing_wheels;
    robot.run(localizer, 5.0);
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 3.0) << seed;
    EXPECT_LT(nees(localizer.estimate(), robot.truth), 9.0) << seed;
    robot.spoilt = sound;
    robot.run(localizer, 60.0);
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 1.5) << seed;
  }
}

TEST(MultipathParticleFilter, LeavesOdometryWithinSecondsWhenAnEncoderDiesAtOnce) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.spoilt = dead_left_encoder;
    robot.run(localizer, 6.0);
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 2.0) << seed;
    EXPECT_LT(nees(localizer.estimate(), robot.truth), 9.0) << seed;
  }
}

}  // namespace
}  // namespace multipath_localization
