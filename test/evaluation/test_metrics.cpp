#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/metrics.hpp"

namespace multipath_localization {
namespace {

Epoch epoch(double stamp, double error_east, double error_north, std::optional<bool> shadow = std::nullopt) {
  Epoch epoch;
  epoch.truth.stamp = stamp;
  epoch.truth.base_in_map = {10.0, 20.0, 0.0};
  epoch.truth.shadow = shadow;
  epoch.valid = true;
  epoch.estimate = {10.0 + error_east, 20.0 + error_north, 0.0};
  return epoch;
}

TEST(Score, OfThreeErrorsByHand) {
  const Score s = score({epoch(0, 3, 4), epoch(1, 0, 1), epoch(2, -2, 0)}, 0.0);
  EXPECT_EQ(s.epochs, 3u);
  EXPECT_DOUBLE_EQ(*s.mean, 8.0 / 3.0);
  EXPECT_DOUBLE_EQ(*s.rmse, std::sqrt(30.0 / 3.0));
  EXPECT_DOUBLE_EQ(*s.median, 2.0);
  EXPECT_DOUBLE_EQ(*s.p95, 2.0 + 0.9 * 3.0);
  EXPECT_DOUBLE_EQ(*s.max, 5.0);
}

TEST(Score, NothingAppliesToNoEpoch) {
  const Score s = score({}, 0.0);
  EXPECT_EQ(s.epochs, 0u);
  EXPECT_FALSE(s.mean || s.rmse || s.median || s.p95 || s.max || s.heading_rmse || s.nees_mean ||
               s.in_ellipse);
}

TEST(Score, StartsAtTheStampAskedFor) {
  const Score s = score({epoch(29.9, 100, 0), epoch(30.0, 1, 0), epoch(31.0, 1, 0)}, 30.0);
  EXPECT_EQ(s.epochs, 2u);
  EXPECT_DOUBLE_EQ(*s.max, 1.0);
}

TEST(Score, CountsEpochsWithoutEstimateApart) {
  Epoch nothing = epoch(1, 1e6, 0);
  nothing.valid = false;
  const Score s = score({epoch(0, 1, 0), nothing, nothing}, 0.0);
  EXPECT_EQ(s.epochs, 1u);
  EXPECT_EQ(s.unscored, 2u);
  EXPECT_DOUBLE_EQ(*s.rmse, 1.0);
}

TEST(Score, SplitsByShadowWhereTruthTells) {
  const Score s = score({epoch(0, 3, 0, true), epoch(1, 1, 0, false), epoch(2, 50, 0)}, 0.0);
  EXPECT_DOUBLE_EQ(*s.rmse_shadow, 3.0);
  EXPECT_DOUBLE_EQ(*s.rmse_open, 1.0);
  EXPECT_FALSE(score({epoch(0, 1, 0)}, 0.0).rmse_shadow);
}

TEST(Score, HeadingErrorIsTheSmallestTurn) {
  Epoch turned = epoch(0, 0, 0);
  turned.truth.has_yaw = true;
  turned.truth.base_in_map.yaw = 3.1;
  turned.estimate.yaw = -3.1;
  EXPECT_NEAR(*score({turned}, 0.0).heading_rmse, 2.0 * (kPi - 3.1), 1e-12);
  EXPECT_FALSE(score({epoch(0, 1, 0)}, 0.0).heading_rmse);
}

TEST(Score, NeesWeighsTheErrorByTheDeclaredCovariance) {
  Epoch e = epoch(0, 2, 3);
  e.position_covariance << 4.0, 0.0, 0.0, 9.0;
  Epoch far = epoch(1, 6, 0);
  far.position_covariance << 4.0, 0.0, 0.0, 9.0;
  const Score s = score({e, far}, 0.0);
  EXPECT_NEAR(*s.nees_mean, 0.5 * (2.0 + 9.0), 1e-5);
  EXPECT_DOUBLE_EQ(*s.in_ellipse, 0.5);
}

TEST(Score, NeesOfACollapsedCovarianceIsLargeButFinite) {
  Epoch e = epoch(0, 1, 0);
  e.position_covariance.setZero();
  EXPECT_NEAR(*score({e}, 0.0).nees_mean, 1e6, 1.0);
  EXPECT_DOUBLE_EQ(*score({e}, 0.0).in_ellipse, 0.0);
}

TEST(LongestOff, RunsFromTheFirstEpochThatIsOffToTheFirstThatIsNot) {
  std::vector<Epoch> epochs;
  for (const double error : {0.0, 3.0, 0.0, 3.0, 2.0, 3.0, 0.0, 3.0}) {
    epochs.push_back(epoch(static_cast<double>(epochs.size()), error, 0.0));
  }
  EXPECT_DOUBLE_EQ(*longest_off(epochs, 0.0, 2.0), 3.0);
  EXPECT_DOUBLE_EQ(*longest_off(epochs, 5.0, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(*longest_off(epochs, 0.0, 4.0), 0.0);
}

TEST(LongestBeyond3Sigma, GoesByTheCovarianceAndOnlyWhereThereIsAnEstimate) {
  std::vector<Epoch> epochs;
  for (const double error : {0.0, 3.5, 3.5, 3.5, 2.9, 3.5}) {
    epochs.push_back(epoch(static_cast<double>(epochs.size()), error, 0.0));
    epochs.back().position_covariance = Eigen::Matrix2d::Identity();
  }
  EXPECT_DOUBLE_EQ(*longest_beyond_3_sigma(epochs, 0.0), 3.0);
  EXPECT_DOUBLE_EQ(*longest_beyond_3_sigma(epochs, 4.0), 0.0);
  epochs[2].valid = false;
  EXPECT_DOUBLE_EQ(*longest_beyond_3_sigma(epochs, 0.0), 1.0);
  for (Epoch& e : epochs) e.position_covariance *= 2.0;
  EXPECT_DOUBLE_EQ(*longest_beyond_3_sigma(epochs, 0.0), 0.0);
  for (Epoch& e : epochs) e.valid = false;
  EXPECT_FALSE(longest_beyond_3_sigma(epochs, 0.0));
}
TEST(LongestOff, WithoutEstimateCountsAsOffOnceThereWasOne) {
  Epoch without = epoch(1.0, 0.0, 0.0);
  without.valid = false;
  EXPECT_FALSE(longest_off({without}, 0.0, 2.0));
  EXPECT_DOUBLE_EQ(*longest_off({without, epoch(2.0, 0, 0)}, 0.0, 2.0), 0.0);
  without.truth.stamp = 3.0;
  EXPECT_DOUBLE_EQ(*longest_off({epoch(2.0, 0, 0), without, epoch(7.0, 0, 0)}, 0.0, 2.0), 4.0);
}

TEST(ScoreFixes, AreComparedWithTruthAtTheirOwnStamp) {
  Drive drive;
  drive.truth = {{0.0, {0.0, 0.0, 0.0}, true, false}, {1.0, {10.0, 0.0, 0.0}, true, true}};
  GnssFix fix;
  fix.stamp = 0.5;
  fix.position = {5.0, 2.0};
  GnssFix before = fix;
  before.stamp = -1.0;
  drive.measurements = {{before, 0.9}, {fix, 0.9}};
  const Score s = score_fixes(drive, -10.0);
  EXPECT_EQ(s.epochs, 1u);
  EXPECT_DOUBLE_EQ(*s.rmse_open, 2.0);
}

TEST(ScoreFixes, CarryTheLeverArm) {
  Drive drive;
  drive.truth = {{0.0, {1.0, 1.0, 0.5 * kPi}, true, std::nullopt}};
  GnssFix fix;
  fix.antenna_in_base = {2.0, 0.0};
  fix.position = {1.0, 3.0};
  DualAntennaFix two;
  two.left = two.right = fix;
  drive.measurements = {{fix, 0.0}, {two, 0.0}};
  EXPECT_EQ(score_fixes(drive, 0.0).epochs, 3u);
  EXPECT_NEAR(*score_fixes(drive, 0.0).max, 0.0, 1e-12);
}

TEST(Quantile, IsLinearBetweenOrderStatistics) {
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(quantile({7.0}, 0.95), 7.0);
}

TEST(WayToAlignment, IsTheWayDrivenUntilAnEstimateIsAligned) {
  std::vector<Epoch> epochs(5);
  for (std::size_t i = 0; i < epochs.size(); ++i)
    epochs[i].truth.base_in_map = {2.0 * static_cast<double>(i), 0.0, 0.0};
  EXPECT_FALSE(way_to_alignment(epochs));
  epochs[3].aligned = true;
  EXPECT_FALSE(way_to_alignment(epochs)) << "an estimate that is none";
  epochs[3].valid = true;
  EXPECT_EQ(way_to_alignment(epochs), 6.0);
}

}  // namespace
}  // namespace multipath_localization
