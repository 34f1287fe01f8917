#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "multipath_localization/estimators/hypothesis_banks.hpp"

namespace multipath_localization {
namespace {

/// `sizes[k]` particles of each class with random weights that sum to `weights[k]`.
std::vector<BeliefParticle> banks(const ClassCounts& sizes, const PerClass& weights) {
  RandomStream random(3, 0, 0);
  std::vector<BeliefParticle> particles;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    const std::size_t first = particles.size();
    double sum = 0.0;
    for (std::size_t i = 0; i < sizes[k]; ++i) {
      BeliefParticle particle;
      particle.receiver = k;
      particle.mode.shadow = i % 2 == 0;
      particle.belief.mean(kX) = 100.0 * static_cast<double>(k) + static_cast<double>(i);
      particle.belief.renew_bias(1.0);
      sum += particle.weight = 0.5 + random.uniform();
      particles.push_back(particle);
    }
    for (std::size_t i = first; i < particles.size(); ++i) particles[i].weight *= weights[k] / sum;
  }
  return particles;
}

void expect_weights(const std::vector<BeliefParticle>& particles, const PerClass& expected,
                    double tolerance) {
  const PerClass actual = class_weights(particles);
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) EXPECT_NEAR(actual[k], expected[k], tolerance) << k;
}

constexpr ClassCounts kSizes = {40, 30, 10, 15, 5};
constexpr PerClass kWeights = {0.5, 0.3, 0.1, 0.06, 0.04};

TEST(PriorProbabilities, AreNotNothingForAClassThatCanBeEntered) {
  ReceiverClasses classes;
  classes.street.prior = 0.6;
  classes.canyon.prior = 0.2;
  classes.noisy.prior = classes.drifting.prior = classes.wheel_fault.prior = 0.0;
  classes.drifting.entry_rate = 0.0;
  const PerClass probability = prior_probabilities(classes);
  EXPECT_NEAR(probability[0], 0.75, 1e-6);
  EXPECT_NEAR(probability[1], 0.25, 1e-6);
  EXPECT_GT(probability[2], 0.0);
  EXPECT_LT(probability[2], 1e-6);
  EXPECT_EQ(probability[3], 0.0);
  EXPECT_GT(probability[kWheelFault], 0.0);
}

TEST(PriorProbabilities, ThereIsAtLeastOneClass) {
  ReceiverClasses classes;
  for (ReceiverClass* receiver :
       {&classes.street, &classes.canyon, &classes.noisy, &classes.drifting, &classes.wheel_fault}) {
    receiver->prior = receiver->entry_rate = 0.0;
  }
  EXPECT_THROW(prior_probabilities(classes), ParameterError);
}

TEST(ClassCounts, SumToTheCountAndKeepTheFloor) {
  const double tiny = 1e-9;
  const std::vector<PerClass> cases = {
      {0.25, 0.25, 0.25, 0.25},  {0.4, 0.3, 0.2, 0.1},    {1.0 - 3 * tiny, tiny, tiny, tiny},
      {0.5, 0.49, 0.005, 0.005}, {0.34, 0.33, 0.33, 0.0}, {0.0, 1.0, 0.0, 0.0}};
  for (const std::size_t count : {20UL, 101UL, 400UL}) {
    for (const double floor : {0.0, 0.05, 0.2}) {
      for (const PerClass& weights : cases) {
        const ClassCounts counts = class_counts(weights, count, floor);
        EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), count);
        for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
          if (weights[k] == 0.0) {
            EXPECT_EQ(counts[k], 0U);
            continue;
          }
          EXPECT_GE(counts[k], std::clamp(floor * static_cast<double>(count), 1.0, 2.0));
        }
      }
    }
  }
}

TEST(ClassCounts, AreProportionalAboveTheFloor) {
  const ClassCounts counts = class_counts({0.4, 0.3, 0.2, 0.1}, 400, 0.05);
  EXPECT_EQ(counts, (ClassCounts{160, 120, 80, 40}));
}

TEST(Reweigh, WithinAClassAsTheLikelihoodsSay) {
  const std::vector<BeliefParticle> before = banks(kSizes, kWeights);
  std::vector<double> log_likelihood(before.size());
  RandomStream random(4, 0, 0);
  for (double& l : log_likelihood) l = 3.0 * random.normal();
  for (const double exponent : {0.0, 0.3, 1.0}) {
    std::vector<BeliefParticle> after = before;
    reweigh(after, log_likelihood, exponent);
    for (std::size_t i = 1; i < after.size(); ++i) {
      if (after[i].receiver != after[i - 1].receiver) continue;
      const double expected =
          before[i].weight / before[i - 1].weight * std::exp(log_likelihood[i] - log_likelihood[i - 1]);
      EXPECT_NEAR(after[i].weight / after[i - 1].weight / expected, 1.0, 1e-9);
    }
  }
}

TEST(Reweigh, BetweenClassesByTheEvidenceToTheExponent) {
  const std::vector<BeliefParticle> before = banks(kSizes, kWeights);
  std::vector<double> log_likelihood(before.size());
  RandomStream random(5, 0, 0);
  for (std::size_t i = 0; i < before.size(); ++i)
    log_likelihood[i] = 0.7 * static_cast<double>(before[i].receiver) + random.normal();
  PerClass evidence{};
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::size_t k = before[i].receiver;
    evidence[k] += before[i].weight / kWeights[k] * std::exp(log_likelihood[i]);
  }
  for (const double exponent : {0.0, 0.5, 1.0}) {
    PerClass expected{};
    double total = 0.0;
    for (std::size_t k = 0; k < kReceiverClassCount; ++k)
      total += expected[k] = kWeights[k] * std::pow(evidence[k], exponent);
    for (double& weight : expected) weight /= total;
    std::vector<BeliefParticle> after = before;
    reweigh(after, log_likelihood, exponent);
    expect_weights(after, exponent == 0.0 ? kWeights : expected, 1e-12);
  }
}

TEST(Reweigh, SurvivesLikelihoodsBeyondTheRangeOfNumbers) {
  std::vector<BeliefParticle> particles = banks(kSizes, kWeights);
  std::vector<double> log_likelihood(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) log_likelihood[i] = -1e13 * static_cast<double>(i + 1);
  reweigh(particles, log_likelihood, 1.0);
  double sum = 0.0;
  for (const BeliefParticle& particle : particles) {
    EXPECT_GT(particle.weight, 0.0);
    sum += particle.weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(particles[0].weight, 1.0, 1e-12);
}

TEST(MixClasses, KeepsTheTotalAndMovesTheFlow) {
  ReceiverClasses classes;
  classes.street.entry_rate = 0.1;
  classes.canyon.entry_rate = 0.05;
  classes.noisy.entry_rate = 0.0;
  classes.drifting.entry_rate = 0.02;
  classes.wheel_fault.entry_rate = 0.01;
  const double dt = 0.5;
  PerClass expected = kWeights;
  for (std::size_t from = 0; from < kReceiverClassCount; ++from) {
    for (std::size_t to = 0; to < kReceiverClassCount; ++to) {
      const double flow = kWeights[from] * (1.0 - std::exp(-classes[to].entry_rate * dt));
      if (from == to) continue;
      expected[from] -= flow;
      expected[to] += flow;
    }
  }
  std::vector<BeliefParticle> particles = banks(kSizes, kWeights);
  RandomStream random(6, 0, 0);
  mix_classes(particles, classes, entry_probabilities(classes, dt), random);
  expect_weights(particles, expected, 1e-12);
  EXPECT_EQ(particles.size(), 100U);
}

TEST(MixClasses, LosesNothingToAClassWithoutHypotheses) {
  ReceiverClasses classes;
  classes.canyon.entry_rate = 0.5;
  std::vector<BeliefParticle> particles = banks({40, 0, 30, 30}, {0.5, 0.0, 0.3, 0.2});
  RandomStream random(6, 0, 0);
  mix_classes(particles, classes, entry_probabilities(classes, 1.0), random);
  const PerClass weights = class_weights(particles);
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-12);
}

TEST(MixClasses, ReseedsABeatenBankFromTheWinner) {
  ReceiverClasses classes;
  classes.street.entry_rate = classes.drifting.entry_rate = classes.noisy.entry_rate = 0.0;
  classes.canyon.entry_rate = 1e-6;
  std::vector<BeliefParticle> particles = banks(kSizes, {1.0, 1e-12, 0.0, 0.0});
  RandomStream random(7, 0, 0);
  mix_classes(particles, classes, entry_probabilities(classes, 1.0), random);
  int newcomers = 0;
  for (const BeliefParticle& particle : particles) {
    if (particle.receiver != kCanyon || particle.belief.mean(kX) >= 100.0) continue;
    ++newcomers;
    EXPECT_TRUE(particle.mode.shadow);
    EXPECT_TRUE(particle.mode.noisy);
    EXPECT_EQ(particle.belief.mean.tail<2>(), Eigen::Vector2d::Zero());
    const double sigma = classes.canyon.shadow_bias_sigma;
    EXPECT_EQ(particle.belief.covariance(kBiasX, kBiasX), sigma * sigma);
  }
  EXPECT_GE(newcomers, 15);  // 30 draws of a victim, with replacement, from a bank of 30
}

TEST(ResampleBanks, KeepsClassWeightsAndTheNumberOfParticles) {
  for (const double fraction : {0.0, 0.5, 1.0}) {
    std::vector<BeliefParticle> particles = banks({25, 25, 25, 25}, {0.9, 0.07, 0.02, 0.01});
    RandomStream random(8, 0, 0);
    resample_banks(particles, 100, 0.05, fraction, random);
    EXPECT_EQ(particles.size(), 100U);
    expect_weights(particles, {0.9, 0.07, 0.02, 0.01}, 1e-12);
    ClassCounts counts{};
    for (const BeliefParticle& particle : particles) ++counts[particle.receiver];
    EXPECT_EQ(counts, (ClassCounts{83, 7, 5, 5}));
  }
}

TEST(ResampleBanks, DrawsInProportionToTheWeightsWithinABank) {
  std::vector<BeliefParticle> particles = banks({50, 30, 10, 10}, {0.5, 0.3, 0.1, 0.1});
  double others = 0.0;
  for (std::size_t i = 1; i < 50; ++i) others += particles[i].weight = 0.1 / 49.0;
  particles[0].weight = 0.5 - others;
  RandomStream random(9, 0, 0);
  resample_banks(particles, 100, 0.05, 0.5, random);
  int copies = 0;
  for (const BeliefParticle& particle : particles) copies += particle.belief.mean(kX) == 0.0 ? 1 : 0;
  EXPECT_NEAR(copies, 40, 1);  // 0.4 of 0.5
}

TEST(ResampleBanks, GoesOverToAnotherNumberOfParticles) {
  for (const std::size_t count : {40U, 100U, 1000U}) {
    std::vector<BeliefParticle> particles = banks({50, 30, 10, 10}, {0.5, 0.3, 0.1, 0.1});
    RandomStream random(11, 0, 0);
    resample_banks(particles, count, 0.05, 0.5, random);
    EXPECT_EQ(particles.size(), count);
    expect_weights(particles, {0.5, 0.3, 0.1, 0.1}, 1e-12);
  }
}

TEST(ResampleBanks, LeavesHealthyBanksAlone) {
  const std::vector<BeliefParticle> before = banks({50, 30, 10, 10}, {0.5, 0.3, 0.1, 0.1});
  std::vector<BeliefParticle> particles = before;
  RandomStream random(10, 0, 0);
  resample_banks(particles, 100, 0.05, 0.5, random);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(particles[i].weight, before[i].weight);
    EXPECT_EQ(particles[i].belief.mean, before[i].belief.mean);
  }
}

}  // namespace
}  // namespace multipath_localization
