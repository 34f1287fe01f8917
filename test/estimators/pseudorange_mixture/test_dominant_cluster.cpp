#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "estimators/pseudorange_mixture/dominant_cluster.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

/// Adds `count` hypotheses round a pose, of this weight together.
void add_cluster(std::vector<WeightedBelief>& particles, const Pose2& centre, int count, double weight,
                 bool shadow) {
  for (int i = 0; i < count; ++i) {
    RandomStream random(1, 0, static_cast<std::uint32_t>(particles.size()));
    WeightedBelief particle;
    particle.belief.mean.head<3>() << centre.x + 0.2 * random.normal(), centre.y + 0.2 * random.normal(),
        wrap_angle(centre.yaw + 0.05 * random.normal());
    particle.belief.covariance.diagonal().setConstant(0.01);
    particle.in_shadow = shadow;
    particle.weight = weight / count;
    particles.push_back(particle);
  }
}

TEST(DominantCluster, IsTheHeavierOfTwoAndTheMeanLiesNotBetween) {
  std::vector<WeightedBelief> particles;
  add_cluster(particles, {0.0, 0.0, 1.0}, 100, 0.7, true);
  add_cluster(particles, {20.0, 5.0, 1.0}, 30, 0.3, false);
  const DominantCluster cluster = dominant_cluster(particles);
  EXPECT_NEAR(cluster.mass, 0.7, 1e-9);
  EXPECT_NEAR(cluster.shadow, 1.0, 1e-9);
  EXPECT_LT(cluster.belief.mean.head<2>().norm(), 0.1);
  EXPECT_NEAR(cluster.belief.mean(kYaw), 1.0, 0.03);
}

TEST(DominantCluster, CovarianceWithinIsNarrowAndOverallCoversBoth) {
  std::vector<WeightedBelief> particles;
  add_cluster(particles, {0.0, 0.0, 1.0}, 100, 0.7, true);
  add_cluster(particles, {20.0, 0.0, 1.0}, 30, 0.3, false);
  const DominantCluster cluster = dominant_cluster(particles);
  EXPECT_NEAR(cluster.belief.covariance(kX, kX), 0.01 + 0.04, 0.02);
  EXPECT_NEAR(cluster.overall_position_covariance(0, 0), 0.3 * 400.0, 6.0);
  EXPECT_NEAR(cluster.overall_position_covariance(1, 1), 0.05, 0.02);
}

TEST(DominantCluster, IsTheMomentsOfTheMixtureWhenAllAgree) {
  std::vector<WeightedBelief> particles;
  add_cluster(particles, {3.0, -4.0, -0.5}, 60, 1.0, false);
  Belief::Vector mean = Belief::Vector::Zero();
  for (const WeightedBelief& particle : particles) mean += particle.weight * particle.belief.mean;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const WeightedBelief& particle : particles) {
    const Eigen::Vector2d d = particle.belief.mean.head<2>() - mean.head<2>();
    covariance += particle.weight * (0.01 * Eigen::Matrix2d::Identity() + d * d.transpose());
  }
  const DominantCluster cluster = dominant_cluster(particles);
  EXPECT_NEAR(cluster.mass, 1.0, 1e-12);
  EXPECT_EQ(cluster.shadow, 0.0);
  EXPECT_LT((cluster.belief.mean.head<2>() - mean.head<2>()).norm(), 1e-12);
  EXPECT_LT((cluster.belief.covariance.topLeftCorner<2, 2>() - covariance).norm(), 1e-12);
  EXPECT_LT((cluster.overall_position_covariance - covariance).norm(), 1e-12);
}

TEST(DominantCluster, HeadingsApartAreClustersApart) {
  std::vector<WeightedBelief> particles;
  add_cluster(particles, {0.0, 0.0, 0.0}, 40, 0.4, false);
  add_cluster(particles, {0.0, 0.0, 2.0}, 60, 0.6, false);
  const DominantCluster cluster = dominant_cluster(particles);
  EXPECT_NEAR(cluster.mass, 0.6, 1e-9);
  EXPECT_NEAR(cluster.belief.mean(kYaw), 2.0, 0.03);
}

TEST(DominantCluster, HeadingsAreAveragedOnTheCircle) {
  std::vector<WeightedBelief> particles;
  add_cluster(particles, {0.0, 0.0, kPi}, 100, 1.0, false);
  const DominantCluster cluster = dominant_cluster(particles);
  EXPECT_NEAR(std::abs(cluster.belief.mean(kYaw)), kPi, 0.03);
  EXPECT_NEAR(cluster.belief.covariance(kYaw, kYaw), 0.01 + 0.0025, 0.002);
}

TEST(DominantCluster, ManyLightHypothesesBeatOneHeavy) {
  std::vector<WeightedBelief> particles;
  add_cluster(particles, {50.0, 0.0, 0.0}, 1, 0.2, false);
  add_cluster(particles, {0.0, 0.0, 0.0}, 200, 0.8, false);
  EXPECT_NEAR(dominant_cluster(particles).mass, 0.8, 1e-9);
}

}  // namespace
}  // namespace multipath_localization
