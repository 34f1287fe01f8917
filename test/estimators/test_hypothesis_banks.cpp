#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "multipath_localization/estimators/hypothesis_banks.hpp"

namespace multipath_localization {
namespace {

/// 100 hypotheses, class by turns, weighted unevenly; x numbers them.
std::vector<BeliefParticle> some_particles() {
  std::vector<BeliefParticle> particles(100);
  double sum = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles[i].receiver = i % kReceiverClassCount;
    particles[i].belief.mean(kX) = static_cast<double>(i);
    particles[i].weight = 1.0 + std::sin(static_cast<double>(i));
    sum += particles[i].weight;
  }
  for (BeliefParticle& particle : particles) particle.weight /= sum;
  return particles;
}

double total(const std::vector<BeliefParticle>& particles) {
  return std::accumulate(particles.begin(), particles.end(), 0.0,
                         [](double sum, const BeliefParticle& particle) { return sum + particle.weight; });
}

TEST(ClassCounts, AddUpInProportionWithAShareForEveryLivingClass) {
  const ClassCounts counts = class_counts({0.7, 0.29, 0.01, 0.0}, 200, 0.05);
  EXPECT_EQ(counts[1], 58U);
  EXPECT_EQ(counts[2], 10U);
  EXPECT_EQ(counts[3], 0U);
  EXPECT_EQ(counts[0], 132U);
}

TEST(Reweigh, IsBayesWhenNotTempered) {
  std::vector<BeliefParticle> particles = some_particles();
  std::vector<double> log_likelihood;
  std::vector<double> expected;
  double sum = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    log_likelihood.push_back(-1000.0 - std::cos(3.0 * static_cast<double>(i)));
    expected.push_back(particles[i].weight * std::exp(log_likelihood[i] + 1000.0));
    sum += expected[i];
  }
  reweigh(particles, log_likelihood, 1.0);
  for (std::size_t i = 0; i < particles.size(); ++i)
    EXPECT_NEAR(particles[i].weight, expected[i] / sum, 1e-12);
}

TEST(Reweigh, FullyTemperedEvidenceMovesNothingBetweenClasses) {
  std::vector<BeliefParticle> particles = some_particles();
  const PerClass before = class_weights(particles);
  std::vector<double> log_likelihood(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    log_likelihood[i] = -2.0 * static_cast<double>(particles[i].receiver) - 0.1 * static_cast<double>(i);
  }
  reweigh(particles, log_likelihood, 0.0);
  for (std::size_t k = 0; k < kReceiverClassCount; ++k)
    EXPECT_NEAR(class_weights(particles)[k], before[k], 1e-9);
  EXPECT_GT(particles[0].weight, 100.0 * particles[96].weight);
}

TEST(Reweigh, NoLikelihoodMakesAWeightVanishOrTheSumDrift) {
  std::vector<BeliefParticle> particles = some_particles();
  std::vector<double> log_likelihood(particles.size(), -1e6);
  log_likelihood[0] = 0.0;
  reweigh(particles, log_likelihood, 1.0);
  EXPECT_NEAR(total(particles), 1.0, 1e-12);
  for (const BeliefParticle& particle : particles) EXPECT_GT(particle.weight, 0.0);
}

TEST(ResampleBanks, KeepsNumberAndWeightOfEveryClass) {
  std::vector<BeliefParticle> particles = some_particles();
  for (BeliefParticle& particle : particles) particle.weight *= particle.belief.mean(kX) < 8.0 ? 50.0 : 0.1;
  const double sum = total(particles);
  for (BeliefParticle& particle : particles) particle.weight /= sum;
  const PerClass before = class_weights(particles);
  RandomStream random(1, 0, 0);
  resample_banks(particles, 0.05, 0.5, random);
  EXPECT_EQ(particles.size(), 100U);
  for (std::size_t k = 0; k < kReceiverClassCount; ++k)
    EXPECT_NEAR(class_weights(particles)[k], before[k], 1e-12);
  for (const BeliefParticle& particle : particles) {
    EXPECT_EQ(static_cast<std::size_t>(particle.belief.mean(kX)) % kReceiverClassCount, particle.receiver);
  }
}

TEST(ResampleBanks, LeavesBalancedBanksAlone) {
  std::vector<BeliefParticle> particles = some_particles();
  for (BeliefParticle& particle : particles) particle.weight = 0.01;
  RandomStream random(1, 0, 0);
  resample_banks(particles, 0.05, 0.5, random);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    EXPECT_EQ(particles[i].belief.mean(kX), static_cast<double>(i));
  }
}

TEST(MixClasses, MovesWeightAtTheEntryRates) {
  std::vector<BeliefParticle> particles = some_particles();
  const PerClass before = class_weights(particles);
  ReceiverClasses classes;
  classes.street.entry_rate = 0.1;
  classes.canyon.entry_rate = classes.noisy.entry_rate = classes.drifting.entry_rate = 0.0;
  RandomStream random(1, 0, 0);
  mix_classes(particles, classes, 2.0, random);
  const PerClass after = class_weights(particles);
  EXPECT_NEAR(total(particles), 1.0, 1e-9);
  for (std::size_t k = 1; k < kReceiverClassCount; ++k)
    EXPECT_NEAR(after[k], before[k] * std::exp(-0.2), 1e-9);
}

TEST(MixClasses, NewcomersKeepTheirPoseAndForgetTheirBias) {
  std::vector<BeliefParticle> particles = some_particles();
  for (BeliefParticle& particle : particles) particle.belief.mean(kBiasX) = 20.0;
  ReceiverClasses classes;
  classes.street.entry_rate = 1.0;
  RandomStream random(1, 0, 0);
  mix_classes(particles, classes, 3.0, random);
  int newcomers = 0;
  for (const BeliefParticle& particle : particles) {
    const std::size_t origin = static_cast<std::size_t>(particle.belief.mean(kX)) % kReceiverClassCount;
    if (origin == particle.receiver) continue;
    ++newcomers;
    EXPECT_EQ(particle.belief.mean(kBiasX), 0.0);
  }
  EXPECT_GT(newcomers, 5);
}

}  // namespace
}  // namespace multipath_localization
