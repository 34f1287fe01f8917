#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "filters/particle_set.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/filters/kalman.hpp"
#include "multipath_localization/filters/resampling.hpp"

namespace multipath_localization {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(ParticleSet, NormalisesWeightsFarBelowTheSmallestDouble) {
  std::vector<double> logs = {-5000.0, -5000.0 + std::log(3.0), -kInf};
  EXPECT_TRUE(normalise(logs));
  const auto weights = weights_of(logs);
  EXPECT_NEAR(weights[0], 0.25, 1e-12);
  EXPECT_NEAR(weights[1], 0.75, 1e-12);
  EXPECT_EQ(weights[2], 0.0);
}

TEST(ParticleSet, ParticlesThatAreAllExcludedBecomeEqual) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double excluded : {-kInf, nan}) {
    std::vector<double> logs(4, excluded);
    EXPECT_FALSE(normalise(logs));
    for (const double w : weights_of(logs)) EXPECT_NEAR(w, 0.25, 1e-12);
  }
}

TEST(ParticleSet, NanIsNoWeight) {
  std::vector<double> logs = {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0};
  EXPECT_TRUE(normalise(logs));
  EXPECT_EQ(weights_of(logs)[1], 0.0);
  EXPECT_NEAR(sum(weights_of(logs)), 1.0, 1e-12);
}

TEST(ParticleSet, EffectiveSampleSizeRunsFromOneToAll) {
  EXPECT_NEAR(effective_sample_size(std::vector<double>(1000, 1e-3)), 1000.0, 1e-9);
  EXPECT_NEAR(effective_sample_size({0.0, 1.0, 0.0}), 1.0, 1e-12);
  EXPECT_NEAR(effective_sample_size({0.5, 0.5, 0.0}), 2.0, 1e-12);
}

TEST(ParticleSet, MeanAndCovarianceOfYawDoNotDependOnTheCutOfTheCircle) {
  ParticleSet particles(2);
  particles.set_pose(0, {1.0, 2.0, kPi - 0.1});
  particles.set_pose(1, {3.0, 2.0, -kPi + 0.1});
  const PoseMoments result = moments(particles, {0.5, 0.5});
  EXPECT_NEAR(angle_difference(result.mean.yaw, kPi), 0.0, 1e-12);
  EXPECT_NEAR(result.mean.x, 2.0, 1e-12);
  EXPECT_NEAR(result.covariance(2, 2), 0.01, 1e-12);
  EXPECT_NEAR(result.covariance(0, 0), 1.0, 1e-12);
  EXPECT_NEAR(result.covariance(0, 2), 0.1, 1e-12);
}

TEST(ParticleSet, MomentsNeedNoNormalisedWeights) {
  ParticleSet particles(3);
  for (std::size_t i = 0; i < 3; ++i) particles.set_pose(i, {static_cast<double>(i), 0.0, 0.0});
  EXPECT_NEAR(moments(particles, {0.1, 0.0, 0.1}).mean.x, 1.0, 1e-12);
  EXPECT_NEAR(moments(particles, {0.1, 0.0, 0.1}).covariance(0, 0), 1.0, 1e-12);
}

TEST(ParticleSet, SelectionCopiesPosesWithEqualWeights) {
  ParticleSet particles(3);
  particles.set_pose(2, {1.0, 2.0, 3.0});
  const ParticleSet chosen = particles.selected({2, 2});
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen.pose(1).y, 2.0);
  EXPECT_NEAR(sum(weights_of(chosen.log_weight)), 1.0, 1e-12);
}

TEST(DominantCluster, IsTheHeavierOfTwoAndNeverBetweenThem) {
  ParticleSet particles(100);
  for (std::size_t i = 0; i < 100; ++i) {
    RandomStream random(6, 0, static_cast<std::uint32_t>(i));
    const double centre = i < 40 ? 0.0 : 10.0;
    particles.set_pose(i, {centre + 0.2 * random.normal(), 0.2 * random.normal(), 0.0});
  }
  const std::vector<double> weights(100, 0.01);
  const auto cluster = dominant_cluster(particles, weights, 2.0, 0.6);
  EXPECT_NEAR(sum(cluster), 0.6, 1e-9);
  EXPECT_NEAR(moments(particles, cluster).mean.x, 10.0, 0.1);
}

TEST(DominantCluster, PosesOfOtherHeadingAreNotMembers) {
  ParticleSet particles(10);
  for (std::size_t i = 0; i < 4; ++i) particles.yaw[i] = 2.0;
  EXPECT_NEAR(sum(dominant_cluster(particles, std::vector<double>(10, 0.1), 2.0, 0.6)), 0.6, 1e-9);
}

/// A random walk of variance `kQ` per step on the x axis, seen with variance `kR`: both filters over 20
/// steps.
class LinearGaussianLine : public ::testing::Test {
 protected:
  static constexpr double kQ = 0.3;
  static constexpr double kR = 0.5;
  static constexpr std::uint32_t kSteps = 20;

  static double measurement(std::uint32_t step) { return std::sin(0.7 * step) + 0.1 * step; }

  static Gaussian<1> kalman_filter() {
    using Matrix1d = Eigen::Matrix<double, 1, 1>;
    Gaussian<1> belief;
    for (std::uint32_t step = 0; step < kSteps; ++step) {
      kalman::predict<1>(belief, belief.mean, Matrix1d(1.0), Matrix1d(kQ));
      kalman::correct<1, 1>(belief, Matrix1d(measurement(step)) - belief.mean, Matrix1d(1.0), Matrix1d(kR));
    }
    return belief;
  }

  static PoseMoments particle_filter(std::size_t size, std::uint64_t seed) {
    ParticleSet particles(size);
    for (std::size_t i = 0; i < size; ++i) {
      particles.x[i] = RandomStream(seed, 1000, static_cast<std::uint32_t>(i)).normal();
    }
    std::vector<double> weights;
    for (std::uint32_t step = 0; step < kSteps; ++step) {
      for (std::size_t i = 0; i < size; ++i) {
        RandomStream random(seed, step, static_cast<std::uint32_t>(i));
        particles.x[i] += std::sqrt(kQ) * random.normal();
        const double error = measurement(step) - particles.x[i];
        particles.log_weight[i] -= 0.5 * error * error / kR;
      }
      normalise(particles.log_weight);
      weights = weights_of(particles.log_weight);
      if (step + 1 == kSteps || effective_sample_size(weights) > 0.5 * static_cast<double>(size)) continue;
      const double uniform = RandomStream(seed, step, 0xFFFFFFFFU).uniform();
      particles = particles.selected(systematic_resampling(weights, size, uniform));
    }
    return moments(particles, weights);
  }

  /// Root mean square error of the particle filter's mean against the Kalman filter's, over 10 seeds.
  static double rms_difference(std::size_t size) {
    const double mean = kalman_filter().mean(0);
    double sum_of_squares = 0.0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      sum_of_squares += std::pow(particle_filter(size, seed).mean.x - mean, 2);
    }
    return std::sqrt(sum_of_squares / 10.0);
  }
};

TEST_F(LinearGaussianLine, ParticleFilterTendsToTheKalmanFilter) {
  const double coarse = rms_difference(100);
  const double fine = rms_difference(10000);
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(coarse / fine, 4.0);  // 1 / sqrt(N) says 10
  EXPECT_LT(coarse / fine, 25.0);
  EXPECT_NEAR(particle_filter(10000, 1).covariance(0, 0), kalman_filter().covariance(0, 0), 0.01);
}

}  // namespace
}  // namespace multipath_localization
