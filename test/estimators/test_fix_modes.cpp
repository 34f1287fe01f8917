#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numeric>

#include "multipath_localization/estimators/fix_modes.hpp"

namespace multipath_localization {
namespace {

Belief some_belief() {
  Belief belief;
  belief.mean << 3.0, -4.0, 0.7, 0.0, 0.0, 1.0, -2.0;
  belief.covariance.diagonal() << 0.2, 0.3, 0.01, 1e-4, 1e-6, 0.5, 0.4;
  belief.covariance(kX, kBiasX) = belief.covariance(kBiasX, kX) = -0.1;
  return belief;
}

FixInterval moving_interval() {
  FixInterval interval;
  interval.duration = 0.2;
  interval.distance = 0.4;
  interval.moving = true;
  return interval;
}

double sum_of_priors(const FixCandidates& candidates) {
  return std::accumulate(candidates.begin(), candidates.end(), 0.0,
                         [](double sum, const FixCandidate& candidate) { return sum + candidate.prior; });
}

/// But for slip and a change of mode within one interval, which has no candidate of its own.
TEST(FixModes, PriorsOfTheWaysOnSumToOne) {
  const ReceiverClasses classes;
  FixInterval restarting = moving_interval();
  restarting.position_restart_rate = restarting.heading_restart_rate = 0.05;
  restarting.aligned_heading = AlignedHeading{-2.0, 0.01};
  const FixInterval standing;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    for (int bits = 0; bits < 8; ++bits) {
      const FixMode mode{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
      for (const FixInterval& interval : {moving_interval(), restarting, standing}) {
        const double sum = sum_of_priors(FixModes(classes[k], interval).candidates(mode, some_belief()));
        EXPECT_NEAR(sum, 1.0, mode.slipping ? 0.01 : 1e-5) << k << " " << bits;
      }
    }
  }
}

TEST(FixModes, AStandingRobotNeitherSlipsNorRestarts) {
  FixInterval standing = moving_interval();
  const ReceiverClass receiver;
  standing.moving = false;
  standing.position_restart_rate = standing.heading_restart_rate = 1.0;
  standing.aligned_heading = AlignedHeading{-2.0, 0.01};
  for (const FixCandidate& candidate : FixModes(receiver, standing).candidates({}, some_belief())) {
    if (candidate.mode.slipping || candidate.restart != Restart::kNone) {
      EXPECT_EQ(candidate.prior, 0.0);
    }
  }
}

TEST(FixModes, LikelihoodIsThatOfTheFixGivenWhatApplyWouldCorrectBy) {
  const ReceiverClass receiver;
  FixInterval interval = moving_interval();
  interval.position_restart_rate = 0.05;
  const FixModes modes(receiver, interval);
  const Belief belief = some_belief();
  const Eigen::Vector2d antenna(0.8, -0.3);
  const Eigen::Vector2d fix(6.0, -5.0);
  for (const FixCandidate& candidate : modes.candidates({true, false, false}, belief)) {
    if (candidate.prior <= 0.0 || candidate.outlier) continue;
    FixCandidate uncorrected = candidate;
    uncorrected.outlier = true;  // so that apply stops before the correction
    Belief carried = belief;
    modes.apply(uncorrected, fix, antenna, OdometryNoise{}, carried);
    const FixPrediction prediction(carried, antenna);
    const Eigen::Matrix2d S = prediction.antenna_covariance + prediction.bias_covariance +
                              prediction.cross_covariance +
                              candidate.fix_variance * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d nu = fix - prediction.antenna - prediction.bias;
    const double expected =
        -0.5 * (nu.dot(S.inverse() * nu) + std::log(S.determinant())) - std::log(2.0 * kPi);
    const double actual =
        modes.log_likelihood(candidate, FixPrediction(belief, antenna), belief.mean(kYaw), fix);
    EXPECT_NEAR(actual, expected, 1e-9);
  }
}

TEST(FixModes, AnOutlierLeavesThePoseAlone) {
  const FixInterval interval = moving_interval();
  const ReceiverClass receiver;
  const FixModes modes(receiver, interval);
  for (const FixCandidate& candidate : modes.candidates({}, some_belief())) {
    if (!candidate.outlier) continue;
    Belief belief = some_belief();
    modes.apply(candidate, {100.0, 100.0}, {0.0, 0.0}, OdometryNoise{}, belief);
    EXPECT_EQ(belief.mean.head<3>(), some_belief().mean.head<3>());
  }
}

TEST(FixModes, AHeadingRestartTakesTheAlignedHeading) {
  FixInterval interval = moving_interval();
  interval.heading_restart_rate = 0.05;
  interval.aligned_heading = AlignedHeading{-2.0, 0.01};
  const ReceiverClass receiver;
  const FixModes modes(receiver, interval);
  bool found = false;
  for (const FixCandidate& candidate : modes.candidates({}, some_belief())) {
    if (candidate.restart != Restart::kHeading) continue;
    found = candidate.prior > 0.0;
    Belief belief = some_belief();
    modes.apply(candidate, belief.mean.head<2>(), {0.0, 0.0}, OdometryNoise{}, belief);
    EXPECT_NEAR(belief.mean(kYaw), -2.0, 1e-9);
  }
  EXPECT_TRUE(found);

  interval.aligned_heading = AlignedHeading{some_belief().mean(kYaw) + 0.1, 0.01};
  for (const FixCandidate& candidate : modes.candidates({}, some_belief())) {
    if (candidate.restart == Restart::kHeading) {
      EXPECT_EQ(candidate.prior, 0.0) << "agrees already";
    }
  }
}

TEST(FixModes, TheCanyonKnowsOneWayOn) {
  const ReceiverClasses classes;
  const FixInterval interval = moving_interval();
  const FixCandidates candidates = FixModes(classes.canyon, interval).candidates({true, true}, some_belief());
  EXPECT_EQ(candidates[0].prior, 1.0);
  EXPECT_TRUE(candidates[0].mode.shadow);
  EXPECT_NEAR(candidates[0].bias_factor, std::exp(-0.2 / classes.canyon.shadow_bias_time), 1e-12);
}

}  // namespace
}  // namespace multipath_localization
