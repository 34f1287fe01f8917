#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/random.hpp"
#include "simd/particle_cloud.hpp"

namespace multipath_localization {
namespace {

constexpr PoseNeighbourhood kEverything{{}, std::numeric_limits<double>::infinity(), 2.0 * kPi};

/// 40 % round the origin, 60 % round (10, 0).
ParticleCloud two_clusters(std::size_t size) {
  ParticleCloud cloud;
  cloud.reset(size);
  for (std::size_t i = 0; i < size; ++i) {
    RandomStream random(6, 0, static_cast<std::uint32_t>(i));
    const double centre = i % 5 < 2 ? 0.0 : 10.0;
    cloud.set_pose(i, {centre + 0.2 * random.normal(), 0.2 * random.normal(), 0.0});
  }
  return cloud;
}

/// Weighs by a Gaussian in x; labels are the place along y.
bool weigh_by_x(ParticleCloud& cloud, double centre, double precision) {
  return cloud.weigh([=](const PoseBlock& poses, double* log_weight, double* factor, float* label) {
    for (std::size_t i = 0; i < poses.size; ++i) {
      log_weight[i] -= precision * (poses.x[i] - centre) * (poses.x[i] - centre);
      factor[i] = 1.0;
      label[i] = static_cast<float>(poses.y[i]);
    }
  });
}

TEST(ParticleCloud, DominantNeighbourhoodIsTheHeavierOfTwoAndNeverBetweenThem) {
  for (const std::size_t size : {100U, 3000U}) {
    ParticleCloud cloud = two_clusters(size);
    const PoseNeighbourhood dominant = cloud.dominant_neighbourhood(2.0, 0.6);
    const PoseSums sums = cloud.choose_members(dominant);
    EXPECT_NEAR(sums.members.w, 0.6, 1e-9);
    EXPECT_NEAR(member_moments(sums, dominant.centre).mean.x, 10.0, 0.1);
    EXPECT_NEAR(sums.all.w, 1.0, 1e-9);
  }
}

TEST(ParticleCloud, PosesOfOtherHeadingAreNotMembers) {
  ParticleCloud cloud;
  cloud.reset(10);
  for (std::size_t i = 0; i < 4; ++i) cloud.set_pose(i, {0.0, 0.0, 2.0});
  EXPECT_NEAR(cloud.choose_members(cloud.dominant_neighbourhood(2.0, 0.6)).members.w, 0.6, 1e-9);
}

TEST(ParticleCloud, WeightsMakeTheDominantCluster) {
  ParticleCloud cloud = two_clusters(3000);
  EXPECT_TRUE(weigh_by_x(cloud, 0.0, 0.5));
  EXPECT_NEAR(cloud.choose_members(cloud.dominant_neighbourhood(2.0, 0.6)).members.w, 1.0, 1e-9);
  EXPECT_LT(cloud.weights().effective_sample_size(), 1200.0);
}

TEST(ParticleCloud, LikelihoodsThatUnderflowStillTellParticlesApart) {
  ParticleCloud cloud = two_clusters(1000);
  EXPECT_TRUE(weigh_by_x(cloud, 1e4, 1e3));
  EXPECT_NEAR(cloud.choose_members(cloud.dominant_neighbourhood(2.0, 0.6)).members.w, 1.0, 1e-9);
  EXPECT_GT(cloud.choose_members({{10.0, 0.0, 0.0}, 2.0, 0.6}).members.w, 0.99);
}

TEST(ParticleCloud, MeasurementThatExcludesAllLeavesEqualWeightsAndTheNextCountsAgain) {
  ParticleCloud cloud = two_clusters(700);
  EXPECT_FALSE(weigh_by_x(cloud, 0.0, std::numeric_limits<double>::infinity()));
  EXPECT_NEAR(cloud.weights()[3], 1.0 / 700.0, 1e-12);
  EXPECT_TRUE(weigh_by_x(cloud, 0.0, 0.5));
  EXPECT_NEAR(cloud.choose_members({{}, 2.0, 0.6}).members.w, 1.0, 1e-9);
}

TEST(ParticleCloud, AReplacedWeightStandsBesideTheNormalisedOnes) {
  ParticleCloud cloud = two_clusters(100);
  weigh_by_x(cloud, 0.0, 0.0);
  cloud.set_log_weight(0, std::log(0.5));
  weigh_by_x(cloud, 0.0, 0.0);
  EXPECT_NEAR(cloud.weights()[0], 0.5 / (0.5 + 0.99), 1e-9);
}

TEST(ParticleCloud, FactorsMultiplyFromOneMeasurementToTheNext) {
  ParticleCloud cloud = two_clusters(100);
  for (int k = 0; k < 3; ++k) {
    cloud.weigh([](const PoseBlock& poses, double*, double* factor, float*) {
      for (std::size_t i = 0; i < poses.size; ++i) factor[i] = i == 0 ? 3.0 : 1.0;
    });
  }
  EXPECT_NEAR(cloud.weights()[0], 27.0 / (27.0 + 99.0), 1e-9);
  cloud.set_log_weight(0, std::log(0.5));
  cloud.weigh([](const PoseBlock& poses, double*, double* factor, float*) {
    std::fill(factor, factor + poses.size, 1.0);
  });
  EXPECT_NEAR(cloud.weights()[0], 0.5 / (0.5 + 99.0 / 126.0), 1e-9);
}

TEST(ParticleCloud, SelectionCopiesPosesAndLabelsWithEqualWeights) {
  ParticleCloud cloud = two_clusters(1000);
  weigh_by_x(cloud, 0.0, 0.5);
  cloud.choose_members({{0.0, 0.0, 0.0}, 2.0, 0.6});
  const Pose2 pose = cloud.pose(701);
  cloud.select(std::vector<std::uint32_t>(1500, 701));
  ASSERT_EQ(cloud.size(), 1500U);
  EXPECT_EQ(cloud.pose(1499).x, pose.x);
  EXPECT_EQ(cloud.label(1499), static_cast<float>(pose.y));
  EXPECT_NEAR(cloud.mean_label(), pose.y, 1e-6);
  EXPECT_NEAR(cloud.weights()[77], 1.0 / 1500.0, 1e-12);
  EXPECT_NEAR(cloud.move({}, [](const PoseBlock&, std::uint32_t) {}).members.w, 1.0, 1e-9);
}

}  // namespace
}  // namespace multipath_localization
