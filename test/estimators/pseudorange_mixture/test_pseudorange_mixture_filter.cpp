#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "../../models/sky.hpp"
#include "estimators/pseudorange_mixture/pseudorange_mixture_filter.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulated_drive.hpp"
#include "started_mixture_filter.hpp"

namespace multipath_localization {
namespace {

TEST(PseudorangeMixtureFilter, FindsPlaceAndHeadingUnderAnOpenSky) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    Started run(seed);
    run.drive.run(run.filter, 60.0);
    RootMeanSquare error;
    run.drive.run(run.filter, 30.0,
                  [&] { error.add(position_error(run.filter.estimate(), run.drive.truth)); });
    EXPECT_LT(error.value(), 1.5);
    EXPECT_LT(run.drive.heading_error(run.filter), 0.05);
    EXPECT_TRUE(run.filter.estimate().aligned);
    EXPECT_LT(run.filter.estimate().shadow_probability, 0.5);
  }
}

TEST(PseudorangeMixtureFilter, FindsItsHeadingInReverse) {
  Started run(5);
  run.drive.speed = -4.0;
  run.drive.run(run.filter, 60.0);
  EXPECT_LT(run.drive.heading_error(run.filter), 0.1);
  EXPECT_LT(run.drive.error(run.filter), 3.0);
}

TEST(PseudorangeMixtureFilter, RejectsAMinorityOfLateSignalsFromTheStart) {
  for (const std::uint64_t seed : {6U, 7U}) {
    Started run(seed, PseudorangeMixtureFilterParameters());
    run.drive.delayed = {0, 1, 2, 8, 9};
    run.drive.run(run.filter, 60.0);
    EXPECT_LT(run.drive.error(run.filter), 4.0);
    EXPECT_LT(run.drive.heading_error(run.filter), 0.1);
  }
}

TEST(PseudorangeMixtureFilter, NeesIsWhatItShouldBe) {
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 10; seed < 16; ++seed) {
    Started run(seed);
    RandomStream random(seed, 0, 5);
    run.drive.errors = {0.02 * random.normal(), 0.002 * random.normal()};
    run.drive.delayed = {seed % 13};
    run.drive.run(run.filter, 60.0, [&] {
      sum += nees(run.filter.estimate(), run.drive.truth);
      ++count;
    });
  }
  EXPECT_LT(sum / count, 4.0);
}

TEST(PseudorangeMixtureFilter, IsNotAlignedAtRest) {
  Started run(20);
  run.drive.speed = 0.0;
  run.drive.run(run.filter, 30.0);
  EXPECT_TRUE(run.filter.estimate().valid);
  EXPECT_FALSE(run.filter.estimate().aligned);
  EXPECT_LT(run.filter.estimate().dominance, 0.8);
  EXPECT_LT(run.drive.error(run.filter), 5.0);
}

TEST(PseudorangeMixtureFilter, SurvivesAJumpOfTheClock) {
  Started run(21);
  run.drive.run(run.filter, 40.0);
  for (const double jump : {299792.458, -299792.458}) {
    run.drive.clock += jump;
    double most = 0.0;
    run.drive.run(run.filter, 10.0, [&] { most = std::max(most, run.drive.error(run.filter)); });
    EXPECT_LT(most, 4.0);
  }
}

TEST(PseudorangeMixtureFilter, DeadReckonsThroughAnOutageAndKnowsThatItDoes) {
  Started run(22);
  run.drive.run(run.filter, 60.0);
  const double before = run.filter.estimate().covariance(0, 0);
  run.drive.steps_per_epoch = 0;
  run.drive.run(run.filter, 60.0);
  const PoseEstimate outage = run.filter.estimate();
  EXPECT_GT(outage.covariance(0, 0), before + 0.5);
  EXPECT_LT(run.drive.error(run.filter), 15.0);
  EXPECT_LT(nees(outage, run.drive.truth), 10.0);
  run.drive.steps_per_epoch = 2;
  run.drive.run(run.filter, 20.0);
  EXPECT_LT(run.drive.error(run.filter), 2.5);
  EXPECT_LT(run.filter.estimate().covariance(0, 0), outage.covariance(0, 0));
}

TEST(PseudorangeMixtureFilter, FollowsTheSkyAsItChanges) {
  Started run(23, quick());
  run.drive.run(run.filter, 30.0);
  // Every quarter of a minute all satellites but three have set, and others have risen.
  for (int change = 1; change <= 6; ++change) {
    run.drive.sky = open_sky();
    for (std::size_t i = 3; i < run.drive.sky.size(); ++i) run.drive.sky[i].satellite += 20 * change;
    run.drive.run(run.filter, 15.0);
    EXPECT_TRUE(run.drive.last.accepted());
    EXPECT_LT(run.drive.error(run.filter), 5.0);
  }
}

TEST(PseudorangeMixtureFilter, TakesNoMoreSatellitesThanItHasRoomFor) {
  Started run(24);
  std::vector<SatelliteObservation> crowd;
  for (int i = 0; i < SatelliteSlots::kCapacity + 16; ++i) {
    crowd.push_back(satellite(Constellation::kGps, i + 1, 6.0 * i, 15.0 + 10.0 * (i % 7)));
  }
  run.drive.sky = crowd;
  run.drive.run(run.filter, 2.0);
  EXPECT_TRUE(run.drive.last.accepted());
  EXPECT_LT(run.drive.error(run.filter), 5.0);
}

TEST(PseudorangeMixtureFilter, PublishesNoLessThanWhatAllPseudorangesMayShare) {
  PseudorangeMixtureFilterParameters bare = quick();
  bare.sigma_factor = 1.0;
  bare.uncorrected_sigma = 0.0;
  Started plain(28, bare);
  Started usual(28);
  plain.drive.run(plain.filter, 20.0);
  usual.drive.run(usual.filter, 20.0);
  const PoseEstimate inner = plain.filter.estimate();
  const PoseEstimate published = usual.filter.estimate();
  const double floor = bare.position_sigma_floor * bare.position_sigma_floor;
  EXPECT_NEAR(published.covariance(0, 0), 2.25 * (inner.covariance(0, 0) - floor) + floor + 2.25, 1e-9);
  EXPECT_NEAR(published.covariance(2, 2), 2.25 * inner.covariance(2, 2), 1e-12);
  EXPECT_NEAR(published.position_covariance_overall(1, 1),
              2.25 * (inner.position_covariance_overall(1, 1) - floor) + floor + 2.25, 1e-9);
}

TEST(PseudorangeMixtureFilter, ComesToTheSameAtAnyRate) {
  std::vector<double> sigmas;
  for (const int steps : {1, 2, 10}) {
    Started run(25);
    run.drive.steps_per_epoch = steps;
    run.drive.run(run.filter, 80.0);
    EXPECT_LT(run.drive.error(run.filter), 2.0);
    sigmas.push_back(std::sqrt(run.filter.estimate().covariance(0, 0)));
  }
  EXPECT_NEAR(sigmas[0] / sigmas[1], 1.0, 0.1);
  EXPECT_NEAR(sigmas[2] / sigmas[1], 1.0, 0.2);
}

TEST(PseudorangeMixtureFilter, StaysSoundForHours) {
  Started run(26);
  run.drive.steps_per_epoch = 50;
  for (int part = 0; part < 72; ++part) {
    run.drive.delayed = {static_cast<std::size_t>(part % 13)};
    run.drive.run(run.filter, 300.0);
    const PoseEstimate estimate = run.filter.estimate();
    ASSERT_TRUE(all_finite(estimate));
    ASSERT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(estimate.covariance).eigenvalues().minCoeff(),
              0.0);
    ASSERT_LT(run.drive.error(run.filter), 8.0);
    ASSERT_TRUE(estimate.aligned);
  }
}

TEST(PseudorangeMixtureFilter, RangeRatesSettleTheHeadingSooner) {
  std::vector<double> variances;
  for (const bool doppler : {false, true}) {
    Started run(27);
    run.drive.doppler = doppler;
    run.drive.run(run.filter, 6.0);
    variances.push_back(run.filter.estimate().covariance(2, 2));
  }
  EXPECT_LT(variances[1], 0.5 * variances[0]);
  EXPECT_LT(variances[1], 0.18 * 0.18);
}

TEST(PseudorangeMixtureFilter, CloudHasTheMomentsOfTheEstimate) {
  Started run(33);
  run.drive.run(run.filter, 60.0);
  const auto cloud = run.filter.hypotheses();
  double weight = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Hypothesis& one : cloud) {
    weight += one.weight;
    mean += one.weight * one.pose.position();
  }
  const PoseEstimate estimate = run.filter.estimate();
  EXPECT_NEAR(weight, 1.0, 1e-9);
  EXPECT_LT((mean - estimate.pose.position()).norm(), 0.3 * std::sqrt(estimate.covariance(0, 0)) + 0.3);
}

}  // namespace
}  // namespace multipath_localization
