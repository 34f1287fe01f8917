#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pseudorange_particle/pseudorange_motion.hpp"

namespace multipath_localization {
namespace {

PseudorangeMotionParameters quiet() {
  PseudorangeMotionParameters parameters;
  parameters.doppler_walk = parameters.odometry_walk = parameters.height_walk = 0.0;
  parameters.yaw_walk = parameters.gyro_bias_walk = 0.0;
  return parameters;
}

const OdometryIncrement kTurning{1.0, 0.5, 4.0, 0.2};

TEST(PseudorangeMotion, FollowsTheOdometryWithoutDoppler) {
  RandomStream random(1, 0, 0);
  Pose2 pose{3.0, 1.0, 0.7};
  PseudorangeParticle particle;
  particle.errors = {0.02, 0.01};
  const Pose2 expected = moved(pose, kTurning, particle.errors);
  move(pose, particle, kTurning, kTurning, quiet(), random);
  EXPECT_DOUBLE_EQ(pose.x, expected.x);
  EXPECT_DOUBLE_EQ(pose.y, expected.y);
  EXPECT_DOUBLE_EQ(pose.yaw, expected.yaw);
}

TEST(PseudorangeMotion, MovesByVelocityTimesDurationAsEquation8) {
  PseudorangeMotionParameters parameters = quiet();
  parameters.velocity_follows_odometry = false;
  RandomStream random(1, 0, 0);
  Pose2 pose{3.0, 1.0, 0.7};
  PseudorangeParticle particle;
  particle.height = 5.0;
  particle.velocity = Eigen::Vector3d(2.0, -1.0, 0.4);
  move(pose, particle, {1.0, 0.5, 0.0, 0.0}, kTurning, parameters, random);
  EXPECT_DOUBLE_EQ(pose.x, 4.0);
  EXPECT_DOUBLE_EQ(pose.y, 0.5);
  EXPECT_DOUBLE_EQ(particle.height, 5.2);
  EXPECT_EQ(*particle.velocity, Eigen::Vector3d(2.0, -1.0, 0.4));
}

TEST(PseudorangeMotion, VelocityTurnsAndGrowsWithTheOdometry) {
  RandomStream random(1, 0, 0);
  Pose2 pose{0.0, 0.0, 0.0};
  PseudorangeParticle particle;
  particle.velocity = Eigen::Vector3d(3.0, 0.0, 0.0);
  OdometryIncrement before = kTurning;
  before.speed = 3.5;
  move(pose, particle, kTurning, before, quiet(), random);
  EXPECT_NEAR(particle.velocity->x(), 3.0 * std::cos(0.1) + 0.5, 1e-12);
  EXPECT_NEAR(particle.velocity->y(), 3.0 * std::sin(0.1), 1e-12);
  EXPECT_NEAR(pose.yaw, 0.1, 1e-12);
}

TEST(PseudorangeMotion, NoiseIsARandomWalkWhateverTheRate) {
  PseudorangeMotionParameters parameters = quiet();
  parameters.doppler_walk = 0.4;
  for (const int steps : {1, 20}) {
    double sum = 0.0;
    for (std::uint32_t i = 0; i < 4000; ++i) {
      RandomStream random(7, static_cast<std::uint32_t>(steps), i);
      Pose2 pose;
      PseudorangeParticle particle;
      particle.velocity = Eigen::Vector3d::Zero();
      for (int k = 0; k < steps; ++k) {
        move(pose, particle, {0.0, 2.0 / steps, 1.0, 0.0}, {0.0, 1.0, 1.0, 0.0}, parameters, random);
      }
      sum += pose.x * pose.x;
    }
    EXPECT_NEAR(sum / 4000.0, 2.0 * 0.16, 0.03);
  }
}

TEST(PseudorangeMotion, StandsStillWithStandingWheels) {
  RandomStream random(1, 0, 0);
  Pose2 pose{1.0, 2.0, 0.5};
  PseudorangeParticle particle;
  move(pose, particle, {1.0, 0.5, 0.0, 0.0}, kTurning, {}, random);
  EXPECT_EQ(pose.x, 1.0);
  EXPECT_EQ(pose.yaw, 0.5);
  EXPECT_EQ(particle.height, 0.0);
}

TEST(PseudorangeMotion, CourseSetsAnUnknownHeadingAndBarelyMovesAKnownOne) {
  const OdometryIncrement straight{1.0, 0.1, 4.0, 0.0};
  PseudorangeParticle particle;
  particle.course_variance = kPi * kPi / 3.0;
  Pose2 pose{0.0, 0.0, 2.5};
  adopt_velocity(pose, particle, {0.0, 4.0, 0.0}, Eigen::Vector2d::Zero(), straight);
  EXPECT_NEAR(pose.yaw, 0.5 * kPi, 0.01);
  EXPECT_LT(particle.course_variance, 0.01);
  particle.course_variance = 1e-6;
  adopt_velocity(pose, particle, {4.0, 0.0, 0.0}, Eigen::Vector2d::Zero(), straight);
  EXPECT_NEAR(pose.yaw, 0.5 * kPi, 0.01);
}

TEST(PseudorangeMotion, CourseOfAReversingRobotPointsBackwards) {
  PseudorangeParticle particle;
  particle.course_variance = 3.0;
  Pose2 pose{0.0, 0.0, 0.1};
  adopt_velocity(pose, particle, {-2.0, 0.0, 0.0}, Eigen::Vector2d::Zero(), {1.0, 0.1, -2.0, 0.0});
  EXPECT_NEAR(pose.yaw, 0.0, 0.02);
}

TEST(PseudorangeMotion, CourseOfAStrafingRobotPointsToItsSide) {
  for (const double lateral_speed : {2.0, -2.0}) {
    Pose2 pose{0.0, 0.0, 0.4};
    PseudorangeParticle particle;
    particle.course_variance = 1e6;
    adopt_velocity(pose, particle, {2.0, 0.0, 0.0}, Eigen::Vector2d::Zero(),
                   {1.0, 0.1, 0.0, 0.0, lateral_speed});
    EXPECT_NEAR(angle_difference(pose.yaw, lateral_speed > 0.0 ? -0.5 * kPi : 0.5 * kPi), 0.0, 1e-3);
  }
}

TEST(PseudorangeMotion, VelocityIsThatOfTheBaseNotOfItsAntenna) {
  PseudorangeParticle particle;
  Pose2 pose{0.0, 0.0, 0.5 * kPi};
  // Forwards at 4 m/s, turning left; the antenna 2 m ahead swings left with 1 m/s.
  adopt_velocity(pose, particle, {-1.0, 4.0, 0.0}, {2.0, 0.0}, {1.0, 0.1, 4.0, 0.5});
  EXPECT_NEAR(particle.velocity->x(), 0.0, 1e-12);
  EXPECT_NEAR(particle.velocity->y(), 4.0, 1e-12);
}

TEST(PseudorangeMotion, StandingTellsNoCourse) {
  PseudorangeParticle particle;
  particle.course_variance = 3.0;
  Pose2 pose{0.0, 0.0, 1.0};
  adopt_velocity(pose, particle, {0.1, 0.1, 0.0}, Eigen::Vector2d::Zero(), {1.0, 0.1, 0.0, 0.0});
  EXPECT_EQ(pose.yaw, 1.0);
  EXPECT_EQ(particle.course_variance, 3.0);
}

}  // namespace
}  // namespace multipath_localization
