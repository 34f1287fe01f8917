#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pseudorange_mixture/pseudorange_bank.hpp"

namespace multipath_localization {
namespace {

PseudorangeHypothesis hypothesis(double x, double yaw, double weight) {
  PseudorangeBelief belief;
  belief.mean(kX) = x;
  belief.mean(kYaw) = yaw;
  belief.covariance.diagonal().setConstant(1.0);
  belief.covariance(kYaw, kYaw) = 0.01;
  PseudorangeHypothesis result(belief, laws_of_wheels());
  result.log_weight = std::log(weight);
  return result;
}

class Bank : public testing::Test {
 protected:
  PseudorangeBank bank_{OdometryNoise(), ReceiverStateNoise()};
  SatelliteSlots slots_;
};

TEST_F(Bank, ClusterIsOfOneHeadingAndPlaceOfAny) {
  bank_.add({hypothesis(0.0, 0.0, 0.6), hypothesis(0.0, 2.0, 0.4)});
  bank_.refresh(false);
  EXPECT_NEAR(bank_.cluster().mass, 0.6, 1e-9);
  EXPECT_NEAR(bank_.place().mass, 1.0, 1e-9);
  bank_.refresh(true);
  EXPECT_NEAR(bank_.place().mass, 0.6, 1e-9) << "the heading is known";
}

TEST_F(Bank, OdometrySummedUpMovesABeliefAtOnceAndTheHypothesesWhenAsked) {
  bank_.add({hypothesis(0.0, 0.0, 1.0)});
  bank_.refresh(true);
  EXPECT_NEAR(bank_.add(OdometryIncrement{1.0, 1.0, 2.0, 0.0}), 1.0, 1e-12);
  EXPECT_NEAR(bank_.current(bank_.cluster().belief).mean(kX), 2.0, 1e-9);
  EXPECT_NEAR(bank_.cluster().belief.mean(kX), 0.0, 1e-12);
  bank_.move(laws_of_wheels(), slots_);
  bank_.refresh(true);
  EXPECT_NEAR(bank_.cluster().belief.mean(kX), 2.0, 1e-9);
  EXPECT_NEAR(bank_.current(bank_.cluster().belief).mean(kX), 2.0, 1e-9) << "nothing is summed up";
}

TEST_F(Bank, HypothesesFollowTheSlots) {
  bank_.add({hypothesis(0.0, 0.0, 1.0)});
  const SlotOwner satellite{Constellation::kGps, 5};
  bank_.follow(slots_.admit({satellite}, 0.0));
  const PseudorangeBelief& belief = bank_.heaviest().likeliest();
  ASSERT_EQ(belief.mean.size(), PseudorangeBelief::kFixed + 1);
  EXPECT_EQ(belief.covariance(PseudorangeBelief::kFixed, PseudorangeBelief::kFixed),
            bank_.unknown_variance(satellite));
  bank_.follow(slots_.retire(1.0));
  EXPECT_EQ(bank_.heaviest().likeliest().mean.size(), PseudorangeBelief::kFixed);
}

TEST_F(Bank, HeaviestIsTheOneOfMostWeight) {
  bank_.add({hypothesis(1.0, 0.0, 0.2), hypothesis(2.0, 0.0, 0.5), hypothesis(3.0, 0.0, 0.3)});
  EXPECT_EQ(bank_.heaviest().planar().mean(kX), 2.0);
  bank_.clear();
  EXPECT_TRUE(bank_.empty());
}

}  // namespace
}  // namespace multipath_localization
