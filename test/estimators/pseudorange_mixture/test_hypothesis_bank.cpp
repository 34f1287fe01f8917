#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pseudorange_mixture/hypothesis_bank.hpp"

namespace multipath_localization {
namespace {

PseudorangeHypothesis hypothesis(double x, double yaw, double log_weight) {
  PseudorangeBelief belief;
  belief.mean(kX) = x;
  belief.mean(kYaw) = yaw;
  belief.covariance.diagonal().setConstant(1.0);
  belief.covariance(kYaw, kYaw) = 0.01;
  PseudorangeHypothesis result(belief, laws_of_wheels());
  result.log_weight = log_weight;
  return result;
}

TEST(HypothesisBank, WeightsSumToOneWhateverTheirScale) {
  const auto weights = weights_of({hypothesis(0, 0, -5000.0), hypothesis(9, 0, -5000.0 + std::log(3.0))});
  EXPECT_NEAR(weights[0], 0.25, 1e-12);
  EXPECT_NEAR(weights[1], 0.75, 1e-12);
}

TEST(HypothesisBank, ThinningDropsTheLightAndScalesTheRest) {
  std::vector<PseudorangeHypothesis> bank = {hypothesis(0, 0, 100.0), hypothesis(20, 0, 80.0),
                                             hypothesis(40, 0, 99.0)};
  thin_out(bank, 1e-4);
  ASSERT_EQ(bank.size(), 2U);
  EXPECT_EQ(bank[1].planar().mean(kX), 40.0);
  EXPECT_NEAR(std::exp(bank[0].log_weight) + std::exp(bank[1].log_weight), 1.0, 1e-12);
}

TEST(HypothesisBank, OfTwoThatAgreeTheHeavierInherits) {
  std::vector<PseudorangeHypothesis> bank = {hypothesis(0.1, kPi, std::log(0.2)),
                                             hypothesis(0.0, -kPi, std::log(0.5)),
                                             hypothesis(0.0, 1.0, std::log(0.3))};
  thin_out(bank, 1e-4);
  ASSERT_EQ(bank.size(), 2U);
  EXPECT_EQ(bank[0].planar().mean(kX), 0.0);
  EXPECT_NEAR(std::exp(bank[0].log_weight), 0.7, 1e-12);
  EXPECT_NEAR(std::exp(bank[1].log_weight), 0.3, 1e-12);
}

TEST(HypothesisBank, PlanarPartsCarryWeightAndMode) {
  std::vector<PseudorangeHypothesis> bank = {hypothesis(3.0, 0.5, 0.0)};
  const auto particles = planar(bank);
  ASSERT_EQ(particles.size(), 1U);
  EXPECT_EQ(particles[0].belief.mean(kX), 3.0);
  EXPECT_EQ(particles[0].belief.covariance(kYaw, kYaw), 0.01);
  EXPECT_FALSE(particles[0].in_shadow);
  EXPECT_NEAR(particles[0].weight, 1.0, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
