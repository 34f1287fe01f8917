#include <gtest/gtest.h>

#include <cmath>

#include "estimators/multipath/odometry_jump.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

/// Feeds steady motion at 50 Hz for `duration` [s]; whether there was a jump, this time or before.
bool drive(OdometryJump& jump, double duration, double speed, double yaw_rate) {
  constexpr double kStep = 0.02;
  for (double t = 0.0; t < duration - 1e-9; t += kStep) jump.add({t, kStep, speed, yaw_rate});
  return jump.take().any();
}

TEST(OdometryJump, SeesWheelsLockSpinAndAnEncoderDie) {
  OdometryJump jump({}, OdometryNoise{});
  EXPECT_FALSE(drive(jump, 5.0, 2.0, 0.1));
  EXPECT_TRUE(drive(jump, 0.5, 0.0, 0.0)) << "locked";
  EXPECT_FALSE(drive(jump, 5.0, 0.0, 0.0)) << "once is enough";
  EXPECT_TRUE(drive(jump, 0.5, 2.0, 0.0)) << "free again";
  EXPECT_TRUE(drive(jump, 0.5, 1.0, 3.3)) << "left encoder dead";
}

TEST(OdometryJump, SeesAStrafeThatEndsAtOnce) {
  OdometryJump jump({}, OdometryNoise{});
  for (int i = 0; i < 100; ++i) jump.add({0.02 * i, 0.02, 0.0, 0.0, 1.0});
  EXPECT_FALSE(jump.take().any());
  EXPECT_TRUE(drive(jump, 0.5, 0.0, 0.0));
}

TEST(OdometryJump, TakesWhatARobotCanDoForSound) {
  OdometryJump jump({}, OdometryNoise{});
  double speed = 0.0;
  for (int i = 0; i < 50; ++i) jump.add({0.02 * i, 0.02, speed += 0.05, 0.0});  // 2.5 m/s^2
  for (int i = 0; i < 50; ++i) jump.add({0.02 * i, 0.02, speed, 0.1 * i});      // 5 rad/s^2
  for (int i = 0; i < 50; ++i) jump.add({0.02 * i, 0.02, speed -= 0.05, 5.0});
  EXPECT_FALSE(jump.take().any());
}

TEST(OdometryJump, DoesNotTakeDeclaredNoiseForAFault) {
  OdometryNoise noise;
  noise.distance = 0.2;
  noise.yaw = 0.3;
  OdometryJump jump({}, noise);
  OdometryJump trusting({}, OdometryNoise{});
  RandomStream random(1, 0, 0);
  for (int i = 0; i < 5000; ++i) {
    const double along = noise.distance * std::sqrt(2.0 / 0.02) * random.normal();
    const OdometryIncrement u{0.02 * i, 0.02, 2.0 + along, noise.yaw / std::sqrt(0.02) * random.normal()};
    jump.add(u);
    trusting.add(u);
  }
  EXPECT_FALSE(jump.take().any());
  EXPECT_TRUE(trusting.take().any());
}

}  // namespace
}  // namespace multipath_localization
