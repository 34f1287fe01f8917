#include <gtest/gtest.h>

#include <cmath>

#include "estimators/multipath/heading_explanations.hpp"

namespace multipath_localization::multipath {
namespace {

/// Heads east, give or take 0.1 rad, and believes headings.
Hypothesis heading_east() {
  Hypothesis h;
  h.covariance.diagonal() << 0.01, 0.01, 0.01, 1e-4, 1e-8, 1e-6, 0.0, 1e-8, 0.01, 0.01, 0.0, 0.0;
  h.heading.drawn = h.heading.believed = true;
  return h;
}

/// Five headings of 0.02 rad within a second.
HeadingSighting sighting_of(double yaw) {
  HeadingSighting z;
  z.yaw = yaw;
  z.variance = 0.02 * 0.02;
  z.count = 5.0;
  z.duration = 1.0;
  return z;
}

TEST(HeadingExplanations, TurnTheHeadingAsFarAsSlowErrorsAllow) {
  Hypothesis h = heading_east();
  RandomStream random(1, 0, 0);
  explain_heading(h, sighting_of(0.1), random);
  EXPECT_FALSE(h.heading.outlier);
  EXPECT_GT(h.mean(kYaw), 0.03);
  EXPECT_LT(h.mean(kYaw), 0.1);
  EXPECT_LT(h.covariance(kYaw, kYaw), 0.007);
  EXPECT_GT(h.covariance(kYaw, kYaw), 0.02 * 0.02) << "a second tells less than what is declared";
}

TEST(HeadingExplanations, TakeTheMountingOff) {
  Hypothesis h = heading_east();
  h.heading.offset = 0.5;
  RandomStream random(1, 0, 0);
  explain_heading(h, sighting_of(0.5), random);
  EXPECT_NEAR(h.mean(kYaw), 0.0, 1e-9);
}

TEST(HeadingExplanations, HoldWhatIsFarOffForAnOutlier) {
  Hypothesis right = heading_east();
  Hypothesis wrong = heading_east();
  RandomStream first(1, 0, 0);
  RandomStream second(1, 0, 0);
  const double agreeing = explain_heading(right, sighting_of(0.0), first);
  const double reversed = explain_heading(wrong, sighting_of(kPi), second);
  EXPECT_GT(agreeing, reversed + 2.0);
  EXPECT_TRUE(wrong.heading.outlier);
  EXPECT_EQ(wrong.mean(kYaw), 0.0) << "an outlier corrects nothing";
}

TEST(HeadingExplanations, AreOutliersHoweverSureTheHypothesisIs) {
  for (const double variance : {1e-2, 1e-4, 1e-6}) {
    Hypothesis sure = heading_east();
    sure.covariance(kYaw, kYaw) = variance;
    RandomStream random(1, 0, 0);
    EXPECT_TRUE(std::isfinite(explain_heading(sure, sighting_of(kPi), random)));
    EXPECT_TRUE(sure.heading.outlier) << variance;
  }
}

TEST(HeadingExplanations, BelieveLessOfARobotThatTurns) {
  Hypothesis still = heading_east();
  Hypothesis turning = heading_east();
  HeadingSighting z = sighting_of(0.1);
  RandomStream first(1, 0, 0);
  RandomStream second(1, 0, 0);
  explain_heading(still, z, first);
  z.turn_rate = 1.0;
  explain_heading(turning, z, second);
  EXPECT_LT(turning.mean(kYaw), still.mean(kYaw));
}

TEST(HeadingExplanations, GiveAHeadingToOneThatIsAny) {
  Hypothesis h = heading_east();
  h.renew_heading(-2.0, 0.01);
  h.velocity.seeks_course = true;
  HeadingSighting z = sighting_of(1.0);
  z.from_start = Eigen::Vector2d(1.0, 0.0);
  h.mean.head<2>() = rotation(-2.0) * *z.from_start;
  RandomStream random(2, 0, 0);
  explain_heading(h, z, random);
  EXPECT_FALSE(h.velocity.seeks_course);
  EXPECT_NEAR(h.mean(kYaw), 1.0, 1e-9);
  EXPECT_NEAR((h.mean.head<2>() - rotation(1.0) * *z.from_start).norm(), 0.0, 1e-9)
      << "turned about the start";
}

}  // namespace
}  // namespace multipath_localization::multipath
