#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pseudorange_mixture/receiver_prior.hpp"

namespace multipath_localization {
namespace {

using State = PseudorangeBelief;

constexpr auto kGlonass = static_cast<std::size_t>(Constellation::kGlonass);
constexpr auto kGalileo = static_cast<std::size_t>(Constellation::kGalileo);

/// A satellite and an offset, in that order.
SatelliteSlots slots() {
  SatelliteSlots all;
  all.admit({{Constellation::kGlonass, 3}, {Constellation::kGlonass, std::nullopt}}, 0.0);
  return all;
}

ReceiverPrior unknown() {
  ReceiverPrior prior;
  prior.up_variance = 625.0;
  prior.offset_variance.fill(225.0);
  prior.zenith_delay_variance = 16.0;
  return prior;
}

PseudorangeBelief belief(double up_variance, double offset_variance, double zenith_delay_variance) {
  PseudorangeBelief all;
  all.append(4.0);
  all.append(offset_variance);
  all.mean(State::kUp) = 30.0;
  all.mean(State::kZenithDelay) = 2.0;
  all.mean(State::state_of(1)) = -7.0;
  all.covariance(State::kUp, State::kUp) = up_variance;
  all.covariance(State::kZenithDelay, State::kZenithDelay) = zenith_delay_variance;
  return all;
}

TEST(ReceiverPrior, IsWhatWasFollowedWithTwiceItsSigma) {
  const ReceiverPrior prior = receiver_prior(belief(9.0, 1.0, 0.25), slots(), unknown(), 0.0);
  EXPECT_EQ(prior.up, 30.0);
  EXPECT_NEAR(prior.up_variance, 36.0, 1e-9);
  EXPECT_EQ(prior.offset[kGlonass], -7.0);
  EXPECT_NEAR(prior.offset_variance[kGlonass], 4.0, 1e-9);
  EXPECT_EQ(prior.zenith_delay, 2.0);
  EXPECT_NEAR(prior.zenith_delay_variance, 1.0, 1e-9);
}

TEST(ReceiverPrior, KnowsNoMoreOfAConstellationThatWasNotSeen) {
  const ReceiverPrior prior = receiver_prior(belief(9.0, 1.0, 0.25), slots(), unknown(), 0.0);
  EXPECT_EQ(prior.offset[kGalileo], 0.0);
  EXPECT_EQ(prior.offset_variance[kGalileo], 225.0);
}

TEST(ReceiverPrior, IsNeverLessSureThanOneOfAReceiverJustSwitchedOn) {
  const ReceiverPrior prior = receiver_prior(belief(1e4, 1e4, 1e4), slots(), unknown(), 1e6);
  EXPECT_EQ(prior.up_variance, 625.0);
  EXPECT_EQ(prior.offset_variance[kGlonass], 225.0);
  EXPECT_EQ(prior.zenith_delay_variance, 16.0);
}

TEST(ReceiverPrior, IsLessSureOfTheHeightOfAPlaceFarOff) {
  const auto variance = [](double position_sigma) {
    return receiver_prior(belief(1.0, 1.0, 1.0), slots(), unknown(), position_sigma * position_sigma)
        .up_variance;
  };
  EXPECT_NEAR(variance(100.0), variance(0.0) + 25.0, 1e-9);
}

TEST(MakeAsSure, SetsVariancesAndKeepsThePlaceWithItsClocks) {
  PseudorangeBelief made = belief(625.0, 225.0, 16.0);
  made.covariance(State::kClock, State::kClock) = 625.0;
  made.covariance(State::kUp, State::kClock) = made.covariance(State::kClock, State::kUp) = 500.0;
  ReceiverPrior prior = unknown();
  prior.up = 70.0;
  prior.up_variance = 25.0;
  prior.offset_variance[kGlonass] = 4.0;
  prior.zenith_delay = 1.5;
  prior.zenith_delay_variance = 1.0;
  make_as_sure(made, slots(), prior);
  EXPECT_EQ(made.mean(State::kUp), 30.0);
  EXPECT_EQ(made.mean(State::state_of(1)), -7.0);
  EXPECT_EQ(made.mean(State::kZenithDelay), 1.5);
  EXPECT_NEAR(made.covariance(State::kUp, State::kUp), 25.0, 1e-9);
  EXPECT_NEAR(made.covariance(State::kUp, State::kClock) / std::sqrt(25.0 * 625.0), 0.8, 1e-9);
  EXPECT_NEAR(made.covariance(State::state_of(1), State::state_of(1)), 4.0, 1e-9);
  EXPECT_EQ(made.covariance(State::state_of(0), State::state_of(0)), 4.0);
}

}  // namespace
}  // namespace multipath_localization
