#include <gtest/gtest.h>

#include <cmath>

#include "estimators/multipath/velocity_explanations.hpp"

namespace multipath_localization::multipath {
namespace {

/// Heads east, give or take 0.1 rad, and believes velocities.
Hypothesis heading_east() {
  Hypothesis h;
  h.covariance.diagonal() << 0.01, 0.01, 0.01, 1e-4, 1e-8, 1e-6, 0.0, 1e-8, 0.01, 0.01, 0.0, 0.0;
  h.velocity.drawn = h.velocity.believed = true;
  return h;
}

/// Five velocities of 5 cm/s within a second, while the wheels drive 2 m/s ahead.
VelocitySighting sighting_of(const Eigen::Vector2d& velocity) {
  VelocitySighting z;
  z.velocity = velocity;
  z.driven.fill({2.0, 0.0});
  z.variance = 0.05 * 0.05;
  z.count = 5.0;
  z.duration = 1.0;
  z.usual_speed = 2.0;
  return z;
}

Eigen::Vector2d course(double yaw, double speed = 2.0) { return rotation(yaw) * Eigen::Vector2d(speed, 0.0); }

TEST(VelocityExplanations, TurnTheHeadingToTheCourse) {
  Hypothesis h = heading_east();
  RandomStream random(1, 0, 0);
  explain_velocity(h, sighting_of(course(0.1)), random);
  EXPECT_FALSE(h.velocity.outlier);
  EXPECT_NEAR(h.mean(kYaw), 0.1, 0.04);
  EXPECT_LT(h.covariance(kYaw, kYaw), 0.005);
}

TEST(VelocityExplanations, LearnTheScaleOfTheWheels) {
  Hypothesis h = heading_east();
  h.covariance(kScale, kScale) = 0.01;
  RandomStream random(1, 0, 0);
  explain_velocity(h, sighting_of(course(0.0, 1.8)), random);
  EXPECT_NEAR(h.mean(kScale), 0.1, 0.03);
}

TEST(VelocityExplanations, AreLessProbableTheLessTheyAgree) {
  Hypothesis right = heading_east();
  Hypothesis wrong = heading_east();
  RandomStream first(1, 0, 0);
  RandomStream second(1, 0, 0);
  const double agreeing = *explain_velocity(right, sighting_of(course(0.0)), first);
  const double reversed = *explain_velocity(wrong, sighting_of(course(kPi)), second);
  EXPECT_GT(agreeing, reversed + 3.0);
  EXPECT_TRUE(wrong.velocity.outlier);
  EXPECT_EQ(wrong.mean(kYaw), 0.0) << "a reflection corrects nothing";
}

TEST(VelocityExplanations, GiveTheCourseToAHeadingThatIsAny) {
  Hypothesis h = heading_east();
  h.renew_heading(-2.0, 0.01);
  h.velocity.seeks_course = true;
  VelocitySighting z = sighting_of(course(1.0));
  z.from_start = {1.0, 0.0};
  h.mean.head<2>() = rotation(-2.0) * z.from_start;
  RandomStream random(1, 0, 0);
  explain_velocity(h, z, random);
  EXPECT_FALSE(h.velocity.seeks_course);
  EXPECT_NEAR(h.mean(kYaw), 1.0, 1e-9);
  EXPECT_NEAR((h.mean.head<2>() - rotation(1.0) * z.from_start).norm(), 0.0, 1e-9)
      << "turned about the start";
  EXPECT_GT(h.covariance(kX, kX), 0.01) << "and as unsure as the course";
}

TEST(VelocityExplanations, TakeTheCourseOfARobotThatBacksUp) {
  Hypothesis h = heading_east();
  h.velocity.seeks_course = true;
  VelocitySighting z = sighting_of(course(kPi));
  z.driven.fill({-2.0, 0.0});
  RandomStream random(1, 0, 0);
  explain_velocity(h, z, random);
  EXPECT_NEAR(h.mean(kYaw), 0.0, 1e-9);
}

TEST(VelocityExplanations, TellTheWayOfWheelsThatFail) {
  Hypothesis h = heading_east();
  h.wheel_fault = {1.0, 0.1};
  VelocitySighting z = sighting_of(course(0.0));
  z.driven.fill({0.0, 0.0});
  RandomStream random(1, 0, 0);
  explain_velocity(h, z, random);
  EXPECT_NEAR(h.velocity.unseen.x(), 2.0, 1e-9);
  EXPECT_EQ(h.velocity.seen_time, 1.0);
}

}  // namespace
}  // namespace multipath_localization::multipath
