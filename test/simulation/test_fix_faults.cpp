#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../core/german_locale.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/fault_interval.hpp"
#include "simulation/fix_faults.hpp"

namespace multipath_localization {
namespace {

constexpr double kStart = 1e6;

/// The fix number `i` of a receiver that drives north, five fixes a second.
GnssFix fix_at(std::size_t i) {
  GnssFix fix;
  fix.stamp = kStart + 0.2 * static_cast<double>(i);
  fix.position = {10.0, static_cast<double>(i)};
  fix.covariance = 0.09 * Eigen::Matrix2d::Identity();
  return fix;
}

/// What comes out of `count` fixes, delivered at once, until an hour later.
std::vector<SpoiltFix> spoilt(const FixFaultParameters& parameters, std::size_t count,
                              std::uint64_t seed = 1) {
  FixFaults faults(parameters, seed, kStart);
  for (std::size_t i = 0; i < count; ++i) faults.take(fix_at(i), fix_at(i).stamp);
  return faults.release(kStart + 3600.0);
}

Eigen::Vector2d error_of(const SpoiltFix& out) { return out.fix.position - fix_at(out.source).position; }

ChanceFault by_chance(double share, double start = 0.0, double duration = 1e9) {
  ChanceFault fault;
  fault.start = start;
  fault.duration = duration;
  fault.share = share;
  return fault;
}

template <class Fault>
Fault between(double start, double duration) {
  Fault fault;
  fault.start = start;
  fault.duration = duration;
  return fault;
}

TEST(FaultInterval, HoldsFromItsStartToBeforeItsEnd) {
  const FaultInterval interval{2.0, 3.0};
  EXPECT_FALSE(interval.holds(1.99));
  EXPECT_TRUE(interval.holds(2.0));
  EXPECT_TRUE(interval.holds(4.99));
  EXPECT_FALSE(interval.holds(5.0));
}

TEST(FixFaults, WithoutFaultsNothingChanges) {
  const auto out = spoilt({}, 20);
  ASSERT_EQ(out.size(), 20U);
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(out[i].source, i);
    EXPECT_EQ(out[i].shown, i);
    EXPECT_EQ(out[i].fix.position, fix_at(i).position);
    EXPECT_EQ(out[i].arrival, fix_at(i).stamp);
  }
}

TEST(FixFaults, ABiasIsThereForItsTime) {
  FixFaultParameters parameters;
  parameters.biases.push_back(between<BiasFault>(1.0, 1.0));
  parameters.biases.back().east = 3.0;
  parameters.biases.back().north = -4.0;
  for (const SpoiltFix& out : spoilt(parameters, 20)) {
    const bool biased = out.source >= 5 && out.source < 10;
    EXPECT_NEAR(error_of(out).norm(), biased ? 5.0 : 0.0, 1e-9) << out.source;
  }
}

TEST(FixFaults, ABiasWalksInLinearly) {
  FixFaultParameters parameters;
  parameters.biases.push_back(between<BiasFault>(1.0, 100.0));
  parameters.biases.back().east = 8.0;
  parameters.biases.back().walk_in = 2.0;
  const auto out = spoilt(parameters, 30);
  EXPECT_NEAR(error_of(out[5]).x(), 0.0, 1e-6);
  EXPECT_NEAR(error_of(out[10]).x(), 4.0, 1e-6);
  EXPECT_NEAR(error_of(out[15]).x(), 8.0, 1e-6);
  EXPECT_NEAR(error_of(out[29]).x(), 8.0, 1e-6);
}

TEST(FixFaults, AZoneBiasesWhereTheFixLiesInIt) {
  FixFaultParameters parameters;
  parameters.zones.emplace_back();
  ZoneParameters& zone = parameters.zones.back();
  zone.shape = ZoneShape::kPolygon;
  zone.corners = {0.0, 4.5, 20.0, 4.5, 20.0, 9.5, 0.0, 9.5};
  zone.direction = 0.0;
  for (const SpoiltFix& out : spoilt(parameters, 20)) {
    const bool inside = out.source >= 5 && out.source < 10;
    EXPECT_EQ(error_of(out).x() > 0.4, inside) << out.source;
  }
}

TEST(FixFaults, NoiseHasItsSigmas) {
  FixFaultParameters parameters;
  parameters.noises.emplace_back();
  parameters.noises.back().white_sigma = 1.0;
  parameters.noises.back().coloured_sigma = 2.0;
  parameters.noises.back().time_constant = 2.0;
  const auto out = spoilt(parameters, 20000);
  double variance = 0.0, covariance = 0.0;
  for (std::size_t i = 0; i + 10 < out.size(); ++i) {
    variance += 0.5 * error_of(out[i]).squaredNorm() / static_cast<double>(out.size());
    covariance += 0.5 * error_of(out[i]).dot(error_of(out[i + 10])) / static_cast<double>(out.size());
  }
  EXPECT_NEAR(variance, 5.0, 0.5);                      // of some 2000 independent stretches
  EXPECT_NEAR(covariance, 4.0 * std::exp(-1.0), 0.35);  // one time constant apart
}

TEST(FixFaults, SpikesAreRareFarAndAllRound) {
  FixFaultParameters parameters;
  parameters.spikes.emplace_back();
  parameters.spikes.back().share = 0.1;
  parameters.spikes.back().length = 25.0;
  int spikes = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SpoiltFix& out : spoilt(parameters, 2000)) {
    if (error_of(out).norm() < 1.0) continue;
    EXPECT_NEAR(error_of(out).norm(), 25.0, 1e-9);
    sum += error_of(out);
    ++spikes;
  }
  EXPECT_NEAR(spikes, 200, 60);  // 4.5 sigma
  EXPECT_LT(sum.norm() / spikes, 6.0);
}

TEST(FixFaults, AnOutageIsSilent) {
  FixFaultParameters parameters;
  parameters.outages.push_back({1.0, 2.0});
  const auto out = spoilt(parameters, 20);
  EXPECT_EQ(out.size(), 10U);
  for (const SpoiltFix& fix : out) EXPECT_TRUE(fix.source < 5 || fix.source >= 15);
  FixFaults faults(parameters, 1, kStart);
  EXPECT_TRUE(faults.take(fix_at(0), kStart));
  EXPECT_FALSE(faults.take(fix_at(7), fix_at(7).stamp)) << "says that it will not come out";
}

TEST(FixFaults, AFrozenReceiverShowsTheFixBeforeToTheBitWithStampsThatGoOn) {
  FixFaultParameters parameters;
  parameters.freezes.push_back({1.0, 1.0});
  parameters.noises.emplace_back();
  const auto out = spoilt(parameters, 20);
  ASSERT_EQ(out.size(), 20U);
  for (std::size_t i = 5; i < 10; ++i) {
    EXPECT_EQ(out[i].fix.position, out[4].fix.position);
    EXPECT_EQ(out[i].shown, 4U);
    EXPECT_EQ(out[i].fix.stamp, fix_at(i).stamp);
  }
  EXPECT_EQ(out[10].shown, 10U);
  EXPECT_NE(out[10].fix.position, out[4].fix.position);
}

TEST(FixFaults, DelaysComeOnTopAndKeepTheOrder) {
  FixFaultParameters parameters;
  parameters.delays.emplace_back();
  parameters.delays.back().delay = 0.3;
  parameters.delays.back().jitter = 1.0;
  const auto out = spoilt(parameters, 200);
  ASSERT_EQ(out.size(), 200U);
  double shortest = 10.0, longest = 0.0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(out[i].source, i);
    shortest = std::min(shortest, out[i].arrival - out[i].fix.stamp);
    longest = std::max(longest, out[i].arrival - out[i].fix.stamp);
    EXPECT_TRUE(i == 0 || out[i].arrival >= out[i - 1].arrival);
  }
  EXPECT_NEAR(shortest, 0.3, 0.1);
  EXPECT_GT(longest, 1.1);
  EXPECT_LE(longest, 1.3 + 1e-6);

  FixFaults faults(parameters, 1, kStart);
  faults.take(fix_at(0), kStart);
  EXPECT_TRUE(faults.release(kStart + 0.29).empty());
  EXPECT_EQ(faults.release(kStart + 1.31).size(), 1U);
}

TEST(FixFaults, ACovarianceLiesByItsFactor) {
  FixFaultParameters parameters;
  parameters.covariances.push_back(between<CovarianceFault>(1.0, 1.0));
  parameters.covariances.back().sigma_factor = 0.1;
  const auto out = spoilt(parameters, 8);
  EXPECT_NEAR(out[4].fix.covariance(0, 0), 0.09, 1e-12);
  EXPECT_NEAR(out[5].fix.covariance(1, 1), 0.0009, 1e-12);
}

TEST(FixFaults, AStatusLiesForItsTime) {
  FixFaultParameters parameters;
  parameters.statuses.push_back(between<StatusFault>(1.0, 1.0));
  const FixFaults faults(parameters, 1, kStart);
  EXPECT_FALSE(faults.status(kStart + 0.5));
  EXPECT_EQ(faults.status(kStart + 1.5), -1);
}

TEST(FixFaults, LossesTakeTheirShare) {
  FixFaultParameters parameters;
  parameters.losses = {by_chance(0.25)};
  EXPECT_NEAR(static_cast<double>(spoilt(parameters, 2000).size()), 1500.0, 88.0);  // 4.5 sigma
}

TEST(FixFaults, DuplicatesComeTwiceInARow) {
  FixFaultParameters parameters;
  parameters.duplicates = {by_chance(1.0, 1.0, 0.5)};
  const auto out = spoilt(parameters, 10);
  ASSERT_EQ(out.size(), 13U);
  EXPECT_EQ(out[5].source, 5U);
  EXPECT_EQ(out[6].source, 5U);
  EXPECT_EQ(out[6].fix.position, out[5].fix.position);
}

TEST(FixFaults, ASwappedFixComesAfterTheNext) {
  FixFaultParameters parameters;
  parameters.swaps = {by_chance(1.0, 1.0, 0.1)};
  const auto out = spoilt(parameters, 10);
  ASSERT_EQ(out.size(), 10U);
  EXPECT_EQ(out[4].source, 4U);
  EXPECT_EQ(out[5].source, 6U);
  EXPECT_EQ(out[6].source, 5U);
  EXPECT_EQ(out[7].source, 7U);
}

TEST(FixFaults, SameSeedSameBytesAndAnotherFaultChangesNoDraw) {
  FixFaultParameters parameters;
  parameters.noises.emplace_back();
  parameters.losses = {by_chance(0.3)};
  const auto first = spoilt(parameters, 100);
  const auto again = spoilt(parameters, 100);
  parameters.duplicates = {by_chance(0.0)};
  parameters.delays.emplace_back();
  const auto more = spoilt(parameters, 100);
  ASSERT_EQ(first.size(), again.size());
  ASSERT_EQ(first.size(), more.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].fix.position, again[i].fix.position);
    EXPECT_EQ(first[i].fix.position, more[i].fix.position);
  }
  EXPECT_NE(spoilt(parameters, 100, 2).size(), 0U);
  EXPECT_NE(spoilt(parameters, 100, 2)[0].fix.position, first[0].fix.position);
}

TEST(FixFaults, SayWhatIsWrongNow) {
  FixFaultParameters parameters;
  parameters.outages.push_back({1.0, 1.0});
  parameters.biases.push_back(between<BiasFault>(1.5, 1.0));
  parameters.biases.back().north = 0.5;
  const FixFaults faults(parameters, 1, kStart);
  const GermanLocale german;
  EXPECT_TRUE(faults.active(kStart).empty());
  const std::vector<std::string> both = {"fix: bias of 5 m east, 0.5 m north", "fix: outage"};
  EXPECT_EQ(faults.active(kStart + 1.6), both);
}

}  // namespace
}  // namespace multipath_localization
