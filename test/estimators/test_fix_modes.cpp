#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "multipath_localization/estimators/fix_modes.hpp"
#include "random_belief.hpp"

namespace multipath_localization {
namespace {

FixInterval driving(double duration) {
  FixInterval interval;
  interval.duration = duration;
  interval.unseen_variance = std::pow(2.0 * duration, 2);
  interval.slip_distance = 2.0 * duration;
  interval.moving = true;
  interval.position_restart_rate = 0.05;
  interval.heading_restart_rate = 0.05;
  interval.aligned_heading = AlignedHeading{3.0, 0.01};
  return interval;
}

/// A heading far from the aligned one, so that a restart from it is due.
Belief off_heading(std::uint64_t seed) {
  Belief belief = random_belief(seed);
  belief.renew(kYaw, 0.3, 0.02);
  return belief;
}

std::vector<FixMode> all_modes() {
  std::vector<FixMode> modes;
  for (const bool shadow : {false, true}) {
    for (const bool noisy : {false, true}) {
      for (const bool slipping : {false, true}) modes.push_back({shadow, noisy, slipping});
    }
  }
  return modes;
}

double sum_of_priors(const FixCandidates& candidates) {
  double sum = 0.0;
  for (const FixCandidate& candidate : candidates) {
    EXPECT_GE(candidate.prior, 0.0);
    EXPECT_LE(candidate.prior, 1.0);
    sum += candidate.prior;
  }
  return sum;
}

/// The belief carried over to the candidate, before the fix is looked at.
Belief carried_over(const FixModes& modes, FixCandidate candidate, Belief belief) {
  candidate.outlier = true;
  modes.apply(candidate, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), OdometryNoise{}, belief);
  return belief;
}

double log_density(const Eigen::Vector2d& d, const Eigen::Matrix2d& S) {
  return -0.5 * d.dot(S.inverse() * d) - 0.5 * std::log(S.determinant()) - std::log(2.0 * kPi);
}

TEST(FixModes, PriorsSumToOneFromEveryMode) {
  const ReceiverClasses classes;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    for (const double duration : {0.05, 0.2, 1.0, 5.0}) {
      for (const bool moving : {false, true}) {
        FixInterval interval = driving(duration);
        interval.moving = moving;
        const FixModes modes(classes[k], interval);
        for (const FixMode& mode : all_modes()) {
          EXPECT_NEAR(sum_of_priors(modes.candidates(mode, off_heading(1))), 1.0, 1e-12);
        }
      }
    }
  }
}

TEST(FixModes, NoPriorIsNegativeWhenRestartsAndOutliersTakeItAll) {
  ReceiverClass receiver;
  receiver.outlier_probability = 0.5;
  FixInterval interval = driving(1.0);
  interval.position_restart_rate = interval.heading_restart_rate = 10.0;
  EXPECT_GT(sum_of_priors(FixModes(receiver, interval).candidates({}, off_heading(1))), 1.0);  // the floor
}

TEST(FixModes, LikelihoodIsTheDensityOfTheFixAfterTheCandidate) {
  const ReceiverClasses classes;
  const FixInterval interval = driving(0.4);
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    ReceiverClass receiver = classes[k];
    receiver.yaw_walk = 0.0;  // of which the likelihood knows nothing
    const FixModes modes(receiver, interval);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Belief belief = off_heading(seed);
      for (const FixMode& mode : all_modes()) {
        for (const FixCandidate& candidate : modes.candidates(mode, belief)) {
          // A heading that restarts is the one case where the lever arm is seen with the heading before.
          const bool turns = candidate.restart == Restart::kHeading;
          const Eigen::Vector2d antenna = turns ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(1.0, 0.3);
          const Eigen::Vector2d fix(1.5, -2.0);
          const Belief predicted = carried_over(modes, candidate, belief);
          const auto H = numerical_fix_jacobian(predicted, antenna);
          const Eigen::Matrix2d S =
              H * predicted.covariance * H.transpose() + candidate.fix_variance * Eigen::Matrix2d::Identity();
          const Eigen::Vector2d d = fix - predicted.pose() * antenna - predicted.mean.tail<2>();
          const double actual =
              modes.log_likelihood(candidate, FixPrediction(belief, antenna), belief.mean(kYaw), fix);
          EXPECT_NEAR(actual, log_density(d, S), 1e-6);
        }
      }
    }
  }
}

TEST(FixModes, ApplyingIsCarryingOverAndCorrecting) {
  const ReceiverClass receiver;
  const FixInterval interval = driving(0.4);
  const FixModes modes(receiver, interval);
  const Belief belief = off_heading(2);
  const Eigen::Vector2d fix(1.0, 2.0);
  const Eigen::Vector2d antenna(0.5, 0.5);
  for (const FixCandidate& candidate : modes.candidates({true, false, false}, belief)) {
    Belief expected = carried_over(modes, candidate, belief);
    if (!candidate.outlier) expected.correct(fix, antenna, candidate.fix_variance);
    Belief actual = belief;
    modes.apply(candidate, fix, antenna, OdometryNoise{}, actual);
    EXPECT_EQ(actual.mean, expected.mean);
    EXPECT_EQ(actual.covariance, expected.covariance);
    EXPECT_TRUE(symmetric_positive(actual.covariance));
  }
}

TEST(FixModes, TheCanyonHasOneWayOn) {
  const ReceiverClasses classes;
  const FixInterval interval = driving(0.2);
  const FixCandidates candidates = FixModes(classes.canyon, interval).candidates({true, true, false}, {});
  EXPECT_EQ(candidates[0].prior, 1.0);
  EXPECT_TRUE(candidates[0].mode.shadow);
  EXPECT_TRUE(candidates[0].keeps_bias);
  for (std::size_t i = 1; i < kFixCandidates; ++i) EXPECT_EQ(candidates[i].prior, 0.0);
}

TEST(FixModes, BiasOfTheOpenSkyStaysTheSizeItHas) {
  const ReceiverClass receiver;
  const FixInterval interval = driving(0.7);
  const FixCandidate open = FixModes(receiver, interval).candidates({}, {})[0];
  const double variance = receiver.open_bias_sigma * receiver.open_bias_sigma;
  EXPECT_NEAR(open.bias_factor * open.bias_factor * variance + open.bias_variance, variance, 1e-12);
}

TEST(FixModes, AHeadingThatAgreesDoesNotRestart) {
  const ReceiverClass receiver;
  const FixInterval interval = driving(0.2);
  const FixModes modes(receiver, interval);
  Belief belief = off_heading(1);
  EXPECT_GT(modes.candidates({}, belief)[7].prior, 0.0);
  belief.mean(kYaw) = interval.aligned_heading->yaw + 0.1;
  EXPECT_EQ(modes.candidates({}, belief)[7].prior, 0.0);
}

TEST(FixModes, AnOutlierLeavesThePoseAloneAndAHeadingRestartTakesTheAlignedHeading) {
  const ReceiverClass receiver;
  const FixInterval interval = driving(0.2);
  const FixModes modes(receiver, interval);
  const Belief before = off_heading(1);
  const FixCandidates candidates = modes.candidates({}, before);
  Belief outlier = before;
  ASSERT_TRUE(candidates[5].outlier);
  modes.apply(candidates[5], {100.0, 100.0}, {0.0, 0.0}, OdometryNoise{}, outlier);
  EXPECT_EQ(outlier.mean.head<5>(), before.mean.head<5>());
  EXPECT_EQ((outlier.covariance.topLeftCorner<5, 5>()), (before.covariance.topLeftCorner<5, 5>()));

  Belief restarted = before;
  ASSERT_EQ(candidates[7].restart, Restart::kHeading);
  modes.apply(candidates[7], before.mean.head<2>(), {0.0, 0.0}, OdometryNoise{}, restarted);
  EXPECT_NEAR(restarted.mean(kYaw), interval.aligned_heading->yaw, 1e-9);
  EXPECT_NEAR(restarted.covariance(kYaw, kYaw), interval.aligned_heading->variance, 1e-9);
}

TEST(FixModes, AStandingRobotDoesNotRestart) {
  const ReceiverClass receiver;
  FixInterval interval = driving(0.2);
  interval.moving = false;
  const FixCandidates candidates = FixModes(receiver, interval).candidates({}, off_heading(1));
  for (const FixCandidate& candidate : candidates) {
    if (candidate.restart == Restart::kNone) continue;
    EXPECT_EQ(candidate.prior, 0.0);
  }
}

TEST(FixModes, SlipMakesThePositionUnsureAlongTheHeadingByWhatItMayHide) {
  const ReceiverClass receiver;
  FixInterval interval = driving(0.2);
  interval.moving = false;
  interval.slip_distance = 0.4;
  const Belief before = off_heading(1);
  const FixModes modes(receiver, interval);
  const FixCandidate slip = modes.candidates({}, before)[4];
  ASSERT_TRUE(slip.mode.slipping);
  EXPECT_GT(slip.prior, 0.0) << "wheels that stand may be locked";
  const Belief after = carried_over(modes, slip, before);
  const Eigen::Vector2d along(std::cos(before.mean(kYaw)), std::sin(before.mean(kYaw)));
  const Eigen::Matrix2d expected = 0.16 * along * along.transpose();
  EXPECT_LT(
      (Eigen::Matrix2d(after.covariance.topLeftCorner<2, 2>() - before.covariance.topLeftCorner<2, 2>()) -
       expected)
          .norm(),
      1e-12);
}

TEST(FixModes, WhatOdometryDoesNotKnowMakesPositionAndHeadingUnsure) {
  const ReceiverClasses classes;
  const FixInterval interval = driving(0.4);
  const Belief before = off_heading(3);
  const FixModes modes(classes[kWheelFault], interval);
  const Belief after = carried_over(modes, modes.candidates({}, before)[0], before);
  const double position = after.covariance(kX, kX) - before.covariance(kX, kX);
  EXPECT_NEAR(position, std::pow(classes.wheel_fault.unseen_motion * 2.0 * 0.4, 2), 1e-12);
  const double heading = after.covariance(kYaw, kYaw) - before.covariance(kYaw, kYaw);
  EXPECT_NEAR(heading, classes.wheel_fault.yaw_walk * classes.wheel_fault.yaw_walk * 0.4, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
