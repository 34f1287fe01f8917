#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "estimators/multipath/hypothesis_cloud.hpp"

namespace multipath_localization::multipath {
namespace {

CloudSettings settings(int particles) {
  CloudSettings settings;
  settings.particles = particles;
  return settings;
}

GnssFix fix_at(double x, double y, double sigma) {
  GnssFix fix;
  fix.position = {x, y};
  fix.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
  return fix;
}

Sighting sighting_at(double x, double y, double sigma) {
  Sighting z;
  z.fix = fix_at(x, y, sigma);
  z.duration = 1.0;
  z.usual_speed = 2.0;
  z.shadow_entry_rate = 1.0 / 60.0;
  return z;
}

double mass(const HypothesisCloud& cloud) {
  double sum = 0.0;
  for (const Hypothesis& h : cloud.hypotheses()) sum += std::exp(h.log_weight);
  return sum;
}

/// Drives 2 m/s along x with fixes that are right.
void drive(HypothesisCloud& cloud, int seconds, int from = 0) {
  for (int i = from + 1; i <= from + seconds; ++i) {
    OdometrySum odometry(OdometryNoise{});
    for (int k = 1; k <= 10; ++k) odometry.add({i - 1 + 0.1 * k, 0.1, 2.0, 0.0});
    cloud.propagate(odometry);
    RandomStream random(5, static_cast<std::uint32_t>(i), 0);
    const double off = 0.2 * random.normal();
    cloud.weigh(sighting_at(2.0 * i + off, 0.2 * random.normal(), 0.3));
  }
}

TEST(HypothesisCloud, StartsAllRoundTheCircleAndFindsTheHeading) {
  HypothesisCloud cloud(settings(500), 1);
  cloud.start(fix_at(0.0, 0.0, 0.3));
  EXPECT_GT(cloud.hypotheses().size(), 500U);
  EXPECT_GT(cloud.mixture().covariance(2, 2), 2.0);
  drive(cloud, 40);
  EXPECT_EQ(cloud.hypotheses().size(), 500U) << "fewer do once the heading is known";
  EXPECT_NEAR(cloud.mixture().mean(kYaw), 0.0, 0.1);
  EXPECT_LT(cloud.mixture().covariance(2, 2), 0.01);
  EXPECT_GT(cloud.mixture().agreement, 0.99);
  EXPECT_NEAR(mass(cloud), 1.0, 1e-9);
}

TEST(HypothesisCloud, CoversWhatLiesBetweenItsHypotheses) {
  HypothesisCloud cloud(settings(200), 2);
  cloud.start(fix_at(3.0, 4.0, 0.5));
  drive(cloud, 10);
  const Mixture& mixture = cloud.mixture();
  Eigen::Matrix2d between = Eigen::Matrix2d::Zero();
  for (const Hypothesis& h : cloud.hypotheses()) {
    const Eigen::Vector2d off = h.mean.head<2>() - mixture.mean.head<2>();
    between += std::exp(h.log_weight) * (off * off.transpose() + h.covariance.topLeftCorner<2, 2>());
  }
  EXPECT_LT((mixture.covariance.topLeftCorner<2, 2>() - between).norm(), 1e-9);
  EXPECT_EQ(mixture.covariance.llt().info(), Eigen::Success);
}

TEST(HypothesisCloud, StartsAtAPoseAsSureAsThatIs) {
  for (const double yaw_sigma : {0.05, 0.8, 10.0}) {
    PosePrior prior;
    prior.pose = {5.0, -2.0, 1.0};
    prior.covariance = Eigen::Vector3d(0.25, 0.25, yaw_sigma * yaw_sigma).asDiagonal();
    HypothesisCloud cloud(settings(300), 3);
    cloud.start(prior);
    EXPECT_LT((cloud.mixture().mean.head<2>() - Eigen::Vector2d(5.0, -2.0)).norm(), 1e-9);
    EXPECT_NEAR(cloud.mixture().covariance(0, 0), 0.25, 1e-9);
    const double claimed = std::sqrt(cloud.mixture().covariance(2, 2));
    EXPECT_NEAR(claimed, std::min(yaw_sigma, 1.8), 0.1 * claimed) << "1.8 is anywhere";
    EXPECT_NEAR(mass(cloud), 1.0, 1e-9);
  }
}

TEST(HypothesisCloud, TakesOnAnotherNumberOfHypotheses) {
  HypothesisCloud cloud(settings(400), 4);
  cloud.start(fix_at(0.0, 0.0, 0.3));
  drive(cloud, 40);
  for (const int particles : {100, 900}) {
    cloud.set(settings(particles));
    drive(cloud, 2, 40);
    EXPECT_EQ(cloud.hypotheses().size(), static_cast<std::size_t>(particles));
  }
}

TEST(HypothesisCloud, GrowsUnsureByWheelsThatMayFail) {
  HypothesisCloud cloud(settings(400), 5);
  cloud.start(fix_at(0.0, 0.0, 0.3));
  drive(cloud, 40);
  const double before = cloud.mixture().covariance(0, 0);
  cloud.let_wheels_fail(0.5, 2.0, 1.0, false, false);
  EXPECT_NEAR(cloud.mixture().wheel_fault, 0.5, 0.1);
  for (int i = 0; i < 10; ++i) cloud.let_wheels_fail(0.0, 2.0, 1.0, false, false);
  EXPECT_LT(cloud.mixture().wheel_fault, 0.1) << "slips end";
  EXPECT_GT(cloud.mixture().covariance(0, 0), before + 0.5);
}

TEST(HypothesisCloud, TakesAnotherInByItsShare) {
  HypothesisCloud cloud(settings(400), 7);
  cloud.start(fix_at(0.0, 0.0, 0.3));
  drive(cloud, 40);
  HypothesisCloud other(settings(200), 8);
  other.start(fix_at(100.0, 50.0, 0.3), cloud, 40.0);
  EXPECT_EQ(other.hypotheses().size(), 200U);
  EXPECT_LT((other.mixture().mean.head<2>() - Eigen::Vector2d(100.0, 50.0)).norm(), 1e-9);
  cloud.take_in(other, 0.25);
  EXPECT_EQ(cloud.hypotheses().size(), 400U);
  EXPECT_NEAR(mass(cloud), 1.0, 1e-9);
  double taken = 0.0;
  for (const Hypothesis& h : cloud.hypotheses()) taken += h.mean(kY) > 25.0 ? std::exp(h.log_weight) : 0.0;
  EXPECT_NEAR(taken, 0.25, 0.02);
}

TEST(HypothesisCloud, StartsAnewWithHalfOfWhatItHasLearnt) {
  HypothesisCloud learnt(settings(400), 9);
  learnt.start(fix_at(0.0, 0.0, 0.3));
  drive(learnt, 60);
  HypothesisCloud anew(settings(512), 10);
  anew.start(fix_at(0.0, 0.0, 0.3), learnt, 40.0);
  int known = 0;
  for (const Hypothesis& h : anew.hypotheses()) known += h.covariance(kScale, kScale) < 1e-4 ? 1 : 0;
  EXPECT_EQ(known, 256);
  EXPECT_GT(anew.mixture().covariance(2, 2), 2.0) << "of the heading nothing is kept";
}

TEST(HypothesisCloud, AStartBesideAnotherCloudSupposesNoLargerBiasThanItIsTold) {
  HypothesisCloud learnt(settings(400), 9);
  learnt.start(fix_at(0.0, 0.0, 0.3));
  EXPECT_GT(std::sqrt(learnt.mixture().covariance(0, 0)), 20.0) << "receivers start worse than they go on";
  HypothesisCloud anew(settings(400), 10);
  anew.start(fix_at(0.0, 0.0, 0.3), learnt, 10.0);
  EXPECT_LT(std::sqrt(anew.mixture().covariance(0, 0)), 10.0);
}

TEST(HypothesisCloud, ClearsToNothing) {
  HypothesisCloud cloud(settings(100), 6);
  cloud.start(fix_at(0.0, 0.0, 0.3));
  cloud.clear();
  EXPECT_TRUE(cloud.empty());
}

}  // namespace
}  // namespace multipath_localization::multipath
