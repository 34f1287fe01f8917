#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "estimators/nishida/conventional_particle_filter.hpp"
#include "estimators/nishida/fix_particle_filter.hpp"
#include "estimators/nishida/nishida_particle_filter.hpp"
#include "plain_particle_filter.hpp"

// What the particle kernel computes, against the same method written plainly: weights to the digits, and
// where random numbers enter, the distribution over seeds.

namespace multipath_localization {
namespace {

constexpr double kSigma = 4.0;  ///< of fixes to a robot that stands [m]

PosePrior prior() {
  PosePrior prior;
  prior.covariance = Eigen::Vector3d(0.25, 0.25, 0.01).asDiagonal();
  return prior;
}

GnssFix fix_at(double stamp, const Eigen::Vector2d& position, double sigma) {
  GnssFix fix;
  fix.stamp = stamp;
  fix.position = position;
  fix.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
  return fix;
}

/// Fixes to a robot that stands: by turns near it, far to one side for long and as far to the other, so that
/// weights of which nothing is left in double precision come back.
std::vector<GnssFix> fixes_near_and_far() {
  std::vector<GnssFix> fixes;
  for (int k = 0; k < 60; ++k) {
    const Eigen::Vector2d near(std::sin(37.0 * k), std::cos(53.0 * k));
    const double far = k < 20 ? 0.0 : k < 40 ? 500.0 : -500.0;
    fixes.push_back(fix_at(k + 1.0, near + Eigen::Vector2d(far, far), kSigma));
  }
  return fixes;
}

/// What weights went through.
struct WeightsSeen {
  double rarest = 1.0;  ///< of all particles at all times
  double heaviest_at_end = 0.0;
};

/// Expects the filter's weights, of particles that stand and are never selected, to be those of logarithms.
WeightsSeen compare_with_logarithms(FixParticleFilterParameters parameters) {
  constexpr std::size_t kSize = 600;
  parameters.sampling.min_particles = parameters.sampling.max_particles = kSize;
  parameters.ring.ring_fraction = 0.0;
  parameters.ess_threshold = 0.0;
  FixParticleFilter filter(parameters, 1);
  filter.start(prior());
  BiasFilter bias_filter(parameters.bias);
  std::vector<double> logs(kSize, 0.0);
  std::vector<double> weights(kSize);
  WeightsSeen seen;
  for (const GnssFix& fix : fixes_near_and_far()) {
    filter.predict({fix.stamp, 1.0, 0.0, 0.0});
    const double radius =
        bias_filter.update(fix.position, filter.estimate().pose.position(), {kSigma, kSigma}, 1.0).norm();
    EXPECT_TRUE(filter.update(fix).accepted());
    const std::vector<Hypothesis> particles = filter.hypotheses();
    for (std::size_t i = 0; i < kSize; ++i) {
      logs[i] += plain_log_likelihood(parameters, fix, radius, particles[i].pose.position());
    }
    const double largest = *std::max_element(logs.begin(), logs.end());
    std::transform(logs.begin(), logs.end(), weights.begin(),
                   [=](double log) { return std::exp(log - largest); });
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < kSize; ++i) {
      const double weight = weights[i] / sum;
      EXPECT_NEAR(particles[i].weight, weight, 1e-6 * weight + 1e-300) << "of " << i << " at " << fix.stamp;
      seen.rarest = std::min(seen.rarest, weight);
    }
    seen.heaviest_at_end = 1.0 / sum;
  }
  return seen;
}

TEST(ParticleKernel, ConventionalWeightsAreThoseOfLogarithmsOverManyFixes) {
  const WeightsSeen seen = compare_with_logarithms(ConventionalParticleFilterParameters());
  EXPECT_LT(seen.rarest, 1e-300);
  EXPECT_LT(seen.heaviest_at_end, 0.5);  // those of which nothing was left came back
}

TEST(ParticleKernel, NishidaWeightsAreThoseOfLogarithmsOverManyFixes) {
  compare_with_logarithms(NishidaParticleFilterParameters());
}

/// What is compared: three components of the mean, spread and evenness of the weights.
using Figures = std::array<double, 5>;

constexpr double kStep = 0.1;  ///< [s]
constexpr int kStepsPerFix = 5;
constexpr int kSteps = 200;
constexpr int kStepsPerLook = 25;
constexpr std::uint64_t kSeeds = 200;

GnssFix fix_on_the_way(int step, const Pose2& truth) {
  const bool shadow = step > 80 && step <= 140;
  const Eigen::Vector2d noise(0.3 * std::sin(37.0 * step), 0.3 * std::cos(53.0 * step));
  return fix_at(kStep * step, truth.position() + noise + (shadow ? 3.0 : 0.0) * Eigen::Vector2d::UnitX(),
                0.3);
}

NishidaParticleFilterParameters mean_of_300() {
  NishidaParticleFilterParameters parameters;
  parameters.sampling.min_particles = parameters.sampling.max_particles = 300;
  parameters.point_estimate = PointEstimate::kMean;
  return parameters;
}

/// The figures over time of one seed.
template <class Filter, class Figure>
std::vector<Figures> over_time(Filter& filter, const Figure& figures) {
  filter.start(prior());
  std::vector<Figures> all;
  Pose2 truth;
  for (int step = 1; step <= kSteps; ++step) {
    const OdometryIncrement u{kStep * step, kStep, 2.0, 0.1};
    truth = truth * displacement(u);
    filter.predict(u);
    if (step % kStepsPerFix == 0) filter.update(fix_on_the_way(step, truth));
    if (step % kStepsPerLook == 0) all.push_back(figures(filter));
  }
  return all;
}

Figures of_kernel(const FixParticleFilter& filter) {
  const PoseEstimate e = filter.estimate();
  return {e.pose.x, e.pose.y, e.pose.yaw, std::log(e.covariance.trace()), std::log(e.effective_sample_size)};
}

Figures of_plain(const PlainParticleFilter& filter) {
  const Pose2 mean = filter.mean();
  const double floors = 2.0 * 0.1 * 0.1 + 0.01 * 0.01;  // added to what is published
  return {mean.x, mean.y, mean.yaw, std::log(filter.variances().sum() + floors),
          std::log(filter.effective_sample_size())};
}

struct Sample {
  double mean = 0.0;
  double variance = 0.0;
};

Sample sample(const std::vector<std::vector<Figures>>& runs, std::size_t time, std::size_t figure) {
  const auto count = static_cast<double>(runs.size());
  Sample result;
  for (const auto& run : runs) result.mean += run[time][figure] / count;
  for (const auto& run : runs) {
    result.variance += std::pow(run[time][figure] - result.mean, 2) / (count - 1.0);
  }
  return result;
}

TEST(ParticleKernel, HasTheDistributionOverSeedsOfThePlainFilter) {
  std::vector<std::vector<Figures>> kernel;
  std::vector<std::vector<Figures>> plain;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    FixParticleFilter fast(mean_of_300(), seed);
    kernel.push_back(over_time(fast, of_kernel));
    PlainParticleFilter slow(mean_of_300(), seed);
    plain.push_back(over_time(slow, of_plain));
  }
  for (std::size_t time = 0; time < kernel.front().size(); ++time) {
    for (std::size_t figure = 0; figure < std::tuple_size_v<Figures>; ++figure) {
      const Sample a = sample(kernel, time, figure);
      const Sample b = sample(plain, time, figure);
      const double error = std::sqrt((a.variance + b.variance) / kSeeds);
      EXPECT_LT(std::abs(a.mean - b.mean), 4.0 * error) << "figure " << figure << ", look " << time;
      // 0.05 is the standard error of the logarithm were they normal; some have long tails.
      EXPECT_LT(std::abs(std::log(std::sqrt(a.variance / b.variance))), 0.3)
          << "figure " << figure << ", look " << time;
    }
  }
}

}  // namespace
}  // namespace multipath_localization
