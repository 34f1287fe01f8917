#include <gtest/gtest.h>

#include "multipath_localization/evaluation/sensor_noise.hpp"
#include "tuning_drive.hpp"

namespace multipath_localization {
namespace {

TEST(SensorNoise, FindsTheNoiseOfADriveUnderOpenSky) {
  const KnownSensors sensors;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SensorNoise noise = sensor_noise(tuning_drive(sensors, 20.0, seed), 60.0);
    ASSERT_TRUE(noise.fix && noise.scale && noise.gyro_bias && noise.delay);
    EXPECT_GE(noise.quiet, 15U);
    EXPECT_NEAR(noise.fix->white_sigma, sensors.white, 0.05 * sensors.white);
    EXPECT_NEAR(noise.scale->value, 1.0 / 1.02, 0.003);
    EXPECT_NEAR(noise.gyro_bias->value, sensors.gyro_bias, 7e-4);
    EXPECT_NEAR(noise.delay->value, 0.0, 0.05);
    ASSERT_TRUE(noise.distance_noise && noise.yaw_noise);
    EXPECT_NEAR(*noise.yaw_noise, sensors.yaw, 0.6 * sensors.yaw);
    EXPECT_NEAR(*noise.distance_noise, sensors.distance, 0.6 * sensors.distance);
  }
}

TEST(SensorNoise, TellsWhiteFromWanderingNoise) {
  KnownSensors sensors;
  sensors.coloured = 0.8;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SensorNoise noise = sensor_noise(tuning_drive(sensors, 20.0, seed), 60.0);
    ASSERT_TRUE(noise.fix);
    EXPECT_NEAR(noise.fix->white_sigma, 0.3, 0.05);
    EXPECT_NEAR(noise.fix->coloured_sigma, 0.8, 0.25);
    ASSERT_TRUE(noise.fix->time_constant);
    EXPECT_NEAR(*noise.fix->time_constant, 5.0, 2.0);
  }
}

TEST(SensorNoise, FindsADelay) {
  KnownSensors sensors;
  sensors.delay = 0.3;
  const SensorNoise noise = sensor_noise(tuning_drive(sensors, 10.0, 1), 60.0);
  ASSERT_TRUE(noise.delay);
  EXPECT_NEAR(noise.delay->value, 0.3, 0.05);
}

TEST(SensorNoise, LeavesStretchesInShadowOut) {
  Drive drive = tuning_drive({}, 20.0, 1);
  for (RecordedMeasurement& recorded : drive.measurements) {
    auto& fix = std::get<GnssFix>(recorded.measurement);
    const double time = fix.stamp - 1e6;
    if (time > 300.0 && time < 600.0)
      fix.position += 5.0 * Eigen::Vector2d(std::sin(0.1 * time), std::cos(0.07 * time));
  }
  const SensorNoise noise = sensor_noise(drive, 60.0);
  EXPECT_EQ(noise.stretches, 19U);
  EXPECT_NEAR(static_cast<double>(noise.quiet), 13.5, 1.5);
  EXPECT_NEAR(noise.fix->white_sigma, 0.3, 0.015);
}

TEST(SensorNoise, OfAShortOrParkedDriveNothingIsTold) {
  EXPECT_FALSE(sensor_noise({}, 60.0).fix);
  EXPECT_FALSE(sensor_noise(tuning_drive({}, 0.5, 1), 60.0).fix);
  const SensorNoise few = sensor_noise(tuning_drive({}, 3.5, 1), 60.0);
  EXPECT_TRUE(few.fix);
  EXPECT_FALSE(few.yaw_noise) << "three stretches";
  Drive parked = tuning_drive({}, 5.0, 1);
  for (OdometryIncrement& increment : parked.odometry) increment.speed = 0.0;
  EXPECT_FALSE(sensor_noise(parked, 60.0).fix);
}

}  // namespace
}  // namespace multipath_localization
