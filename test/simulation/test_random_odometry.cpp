#include <gtest/gtest.h>

#include <cmath>

#include "simulation/random_odometry.hpp"

namespace multipath_localization {
namespace {

/// 20 s at 2 m/s on a circle, 0.1 rad/s.
std::vector<MotionStep> circle() {
  std::vector<MotionStep> steps(2000);
  Pose2 pose;
  for (MotionStep& step : steps) {
    pose = pose * displacement({0.0, kWayStep, 2.0, 0.1});
    step = {pose, 2.0, 0.1};
  }
  return steps;
}

struct Sum {
  double time = 0.0;
  double way = 0.0;
  double turn = 0.0;
};

Sum sum(const std::vector<OdometryIncrement>& increments) {
  Sum all;
  for (const OdometryIncrement& u : increments) {
    all.time += u.duration;
    all.way += u.duration * u.speed;
    all.turn += u.duration * u.yaw_rate;
  }
  return all;
}

TEST(RandomOdometry, WithoutErrorsIsTheMotionAtEveryRate) {
  for (const int period_ms : {1, 5, 10, 20, 40, 100, 200}) {
    RandomOdometry odometry;
    odometry.period_ms = period_ms;
    const Sum all = sum(read_odometry(odometry, circle(), 1).increments);
    EXPECT_NEAR(all.time, 20.0, 1e-9);
    EXPECT_NEAR(all.way, 40.0, 1e-9);
    EXPECT_NEAR(all.turn, 2.0, 1e-9);
  }
}

TEST(RandomOdometry, ScaleTurnScaleAndCurvatureOffsetAddUpAsNamed) {
  RandomOdometry odometry;
  odometry.yaw = YawSource::kSkidSteer;
  odometry.speed_scale = 0.02;
  odometry.turn_scale = 0.2;
  odometry.curvature_offset = 0.01;
  const Sum all = sum(read_odometry(odometry, circle(), 1).increments);
  EXPECT_NEAR(all.way, 40.8, 1e-9);
  EXPECT_NEAR(all.turn, 2.4 + 0.4, 1e-9);
}

TEST(RandomOdometry, TicksLoseNothingForGood) {
  RandomOdometry odometry;
  odometry.period_ms = 1;
  odometry.tick = 0.02;
  const auto read = read_odometry(odometry, circle(), 1).increments;
  EXPECT_NEAR(sum(read).way, 40.0, 0.02);
  for (const OdometryIncrement& u : read) {
    const double ticks = u.speed * u.duration / 0.02;
    ASSERT_NEAR(ticks, std::round(ticks), 1e-6);
  }
}

TEST(RandomOdometry, FaultsOfWheelsCountInWhatIsReadAlone) {
  RandomOdometry odometry;
  odometry.faults = {{WheelFault::Kind::kLocked, {5.0, 2.0}, -1.0}};
  const ReadOdometry read = read_odometry(odometry, circle(), 1);
  EXPECT_NEAR(sum(read.increments).way, 36.0, 1e-6);
  EXPECT_NEAR(sum(read.increments).turn, 2.0, 1e-6);  // a gyro goes on
  EXPECT_NEAR(sum(read.without_faults).way, 40.0, 1e-6);
  EXPECT_TRUE(odometry.faulty(6.9, 7.1));
  EXPECT_FALSE(odometry.faulty(7.0, 8.0));
}

TEST(RandomOdometry, ADeadEncoderTurnsAWheeledRobotAndStopsAnyOther) {
  RandomOdometry odometry;
  odometry.yaw = YawSource::kWheels;
  odometry.wheel_separation = 0.5;
  odometry.faults = {{WheelFault::Kind::kDeadEncoder, {0.0, 100.0}, 1.0}};
  const Sum wheels = sum(read_odometry(odometry, circle(), 1).increments);
  EXPECT_NEAR(wheels.way, 0.5 * (40.0 + 0.25 * 2.0), 1e-6);
  EXPECT_NEAR(wheels.turn, (40.0 + 0.25 * 2.0) / 0.5, 1e-6);
  odometry.yaw = YawSource::kGyro;
  EXPECT_NEAR(sum(read_odometry(odometry, circle(), 1).increments).way, 0.0, 1e-9);
}

TEST(RandomOdometry, DopplerTellsTheMotionOnceASecond) {
  RandomOdometry odometry;
  odometry.yaw = YawSource::kDoppler;
  odometry.period_ms = 1000;
  const Sum all = sum(read_odometry(odometry, circle(), 1).increments);
  EXPECT_NEAR(all.way, 40.0, 1e-6);
  EXPECT_NEAR(all.turn, 1.9, 1e-6);  // the first velocity has none before it
}

TEST(RandomOdometry, SourcesHaveNames) { EXPECT_EQ(to_string(YawSource::kSkidSteer), "skid steer"); }

TEST(RandomOdometry, FastRobotsDoNotSteerByTheirDrivenWheels) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomStream random(seed, 0, 1);
    EXPECT_FALSE(draw_odometry(random, 20.0, 300.0).turns_by_wheels());
  }
}

}  // namespace
}  // namespace multipath_localization
