#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include "estimators/pseudorange_mixture/pseudorange_mixture_filter.hpp"
#include "satellite_drive.hpp"
#include "simulated_drive.hpp"
#include "started_mixture_filter.hpp"

namespace multipath_localization {
namespace {

TEST(PseudorangeMixtureFilter, StartsAtThePrior) {
  Started run(28);
  PosePrior prior{0.0, run.drive.truth, Eigen::Vector3d(0.04, 0.04, 4e-4).asDiagonal()};
  run.filter.start(prior);
  EXPECT_TRUE(run.filter.estimate().valid);
  EXPECT_TRUE(run.filter.estimate().aligned);
  run.drive.delayed = {0, 1, 2, 8, 9};
  double most = 0.0;
  run.drive.run(run.filter, 20.0, [&] { most = std::max(most, run.drive.error(run.filter)); });
  EXPECT_LT(most, 2.0);
  EXPECT_TRUE(run.filter.estimate().aligned);
}

TEST(PseudorangeMixtureFilter, SaysNothingBeforeAnEpochThatAllowsAPosition) {
  Started run(29);
  EXPECT_FALSE(run.filter.estimate().valid);
  EXPECT_TRUE(run.filter.hypotheses().empty());
  run.filter.predict(run.drive.drive());
  PseudorangeEpoch few = run.drive.epoch();
  few.observations.resize(3);
  EXPECT_EQ(run.filter.update(few).reason, Reason::kTooFewSatellites);
  EXPECT_FALSE(run.filter.estimate().valid);
  EXPECT_TRUE(run.filter.update(run.drive.epoch()).accepted());
  EXPECT_TRUE(run.filter.estimate().valid);
  EXPECT_FALSE(run.filter.estimate().aligned);
}

TEST(PseudorangeMixtureFilter, SameSeedSameBytesAlsoAfterARestart) {
  std::vector<std::vector<double>> ends;
  Started again(30);
  for (int i = 0; i < 2; ++i) {
    Started fresh(30);
    fresh.drive.run(fresh.filter, 10.0);
    ends.push_back(numbers_of(fresh.filter.estimate()));
    again.filter.start(std::nullopt);
    again.drive = SatelliteDrive(30);
    again.drive.run(again.filter, 10.0);
    ends.push_back(numbers_of(again.filter.estimate()));
  }
  for (const auto& end : ends) EXPECT_EQ(end, ends[0]);
}

TEST(PseudorangeMixtureFilter, DefectiveEpochsAreRefusedAndChangeNothing) {
  Started run(31);
  run.drive.run(run.filter, 10.0);
  const std::vector<double> before = numbers_of(run.filter.estimate());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_refused = [&](Reason reason, const std::function<void(PseudorangeEpoch&)>& spoil) {
    PseudorangeEpoch epoch = run.drive.epoch();
    spoil(epoch);
    EXPECT_EQ(run.filter.update(epoch).reason, reason);
    EXPECT_EQ(numbers_of(run.filter.estimate()), before);
  };
  expect_refused(Reason::kNotFinite, [&](auto& epoch) { epoch.stamp = nan; });
  expect_refused(Reason::kNotFinite, [&](auto& epoch) { epoch.antenna_in_base.x() = nan; });
  expect_refused(Reason::kTooFewSatellites, [](auto& epoch) { epoch.observations.clear(); });
  expect_refused(Reason::kTooFewSatellites, [&](auto& epoch) {
    for (auto& observation : epoch.observations) observation.pseudorange = nan;
  });
  EXPECT_EQ(run.filter.update(GnssFix()).reason, Reason::kUnused);
  EXPECT_EQ(numbers_of(run.filter.estimate()), before);
}

TEST(PseudorangeMixtureFilter, AbsurdRangesLeaveTheEstimateSound) {
  Started run(32);
  run.drive.run(run.filter, 30.0);
  PseudorangeEpoch epoch = run.drive.epoch();
  epoch.observations[0].pseudorange = 1e300;
  epoch.observations[1].pseudorange = -1e12;
  epoch.observations[2].cn0 = 1e9;
  run.filter.update(epoch);
  EXPECT_TRUE(all_finite(run.filter.estimate()));
  EXPECT_LT(run.drive.error(run.filter), 4.0);
}

}  // namespace
}  // namespace multipath_localization
