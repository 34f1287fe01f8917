#include <gtest/gtest.h>

#include "multipath_localization/estimators/dominant_cluster.hpp"

namespace multipath_localization {
namespace {

BeliefParticle particle(double x, double yaw, double weight, double sigma = 0.1) {
  BeliefParticle made;
  made.belief.mean(kX) = x;
  made.belief.mean(kYaw) = yaw;
  made.belief.covariance = sigma * sigma * Belief::Matrix::Identity();
  made.weight = weight;
  return made;
}

TEST(DominantCluster, IsTheHeavierOfTwoAndNeverBetweenThem) {
  const DominantCluster cluster =
      dominant_cluster({particle(0.0, 0.0, 0.2), particle(0.4, 0.0, 0.4), particle(20.0, 0.0, 0.4)});
  EXPECT_NEAR(cluster.belief.mean(kX), 0.2 / 0.6 * 0.0 + 0.4 / 0.6 * 0.4, 1e-12);
  EXPECT_NEAR(cluster.mass, 0.6, 1e-12);
}

TEST(DominantCluster, ManyLightHypothesesThatAgreeOutweighOneHeavy) {
  std::vector<BeliefParticle> particles = {particle(20.0, 0.0, 0.3)};
  for (int i = 0; i < 70; ++i) particles.push_back(particle(0.01 * i, 0.0, 0.01));
  EXPECT_NEAR(dominant_cluster(particles).belief.mean(kX), 0.345, 1e-9);
}

TEST(DominantCluster, HeadingsThatDisagreeAreNotAveraged) {
  const DominantCluster cluster =
      dominant_cluster({particle(0.0, 1.5, 0.4), particle(0.0, -1.5, 0.35), particle(0.0, 1.6, 0.25)});
  EXPECT_NEAR(cluster.belief.mean(kYaw), 1.5 + 0.1 * 0.25 / 0.65, 1e-3);
  EXPECT_NEAR(cluster.mass, 0.65, 1e-12);
}

TEST(DominantCluster, HeadingsAreAveragedAcrossTheSeam) {
  const DominantCluster cluster =
      dominant_cluster({particle(0.0, kPi - 0.1, 0.5), particle(0.0, -kPi + 0.1, 0.5)});
  EXPECT_NEAR(std::abs(cluster.belief.mean(kYaw)), kPi, 1e-9);
  EXPECT_NEAR(cluster.belief.covariance(kYaw, kYaw), 0.01 + 0.01, 1e-9);
}

TEST(DominantCluster, CovarianceHoldsSpreadWithinAndOverallSpreadEverything) {
  const DominantCluster cluster =
      dominant_cluster({particle(-0.5, 0.0, 0.4), particle(0.5, 0.0, 0.4), particle(10.0, 0.0, 0.2)});
  EXPECT_NEAR(cluster.belief.covariance(kX, kX), 0.01 + 0.25, 1e-9);
  EXPECT_NEAR(cluster.overall_position_covariance(0, 0), 0.01 + 0.8 * 0.25 + 0.2 * 100.0, 1e-9);
  EXPECT_NEAR(cluster.overall_position_covariance(1, 1), 0.01, 1e-9);
}

TEST(DominantCluster, TellsTheShareInShadow) {
  std::vector<BeliefParticle> particles = {particle(0.0, 0.0, 0.5), particle(0.1, 0.0, 0.25),
                                           particle(30.0, 0.0, 0.25)};
  particles[1].mode.shadow = particles[2].mode.shadow = true;
  EXPECT_NEAR(dominant_cluster(particles).shadow, 0.25 / 0.75, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
