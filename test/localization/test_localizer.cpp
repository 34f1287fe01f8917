#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "localizer_fixture.hpp"
#include "multipath_localization/localization/localizer.hpp"

namespace multipath_localization {
namespace {

TEST_F(LocalizerTest, AFixAheadOfTheOdometryWaitsAndSplitsTheIncrementAtItsStamp) {
  drive(1.0, 1.0, 0.5);
  path.push_back({now + kStep, kStep, 2.0, -0.8});
  localizer->add(Measurement(fix_at(now + 0.03)));
  EXPECT_TRUE(localizer->take_reports().empty());
  EXPECT_TRUE(recorder->innovations.empty());

  localizer->add(path.back());
  ASSERT_EQ(recorder->innovations.size(), 1U);
  EXPECT_LT(recorder->innovations[0].norm(), 1e-9);
  EXPECT_NEAR(recorder->used_at[0], now + 0.03, 1e-9);
  ASSERT_EQ(recorder->increments.size(), 12U);
  EXPECT_NEAR(recorder->increments[10].duration, 0.03, 1e-9);
  EXPECT_NEAR(recorder->increments[11].duration, 0.07, 1e-9);
  EXPECT_NEAR(recorder->increments[11].stamp, now + kStep, 1e-9);
  ASSERT_EQ(localizer->take_reports().size(), 1U);
}

TEST_F(LocalizerTest, AFixAtTheOdometrysOwnStampIsUsedAsItIs) {
  drive(1.0, 1.0, 0.5);
  EXPECT_EQ(reason_of(path.back().stamp), Reason::kAccepted);
  EXPECT_LT(recorder->innovations.back().norm(), 1e-9);
}

TEST_F(LocalizerTest, ALateFixIsWeighedAgainstWhereTheAntennaWasThen) {
  for (const double yaw_rate : {0.0, 0.7, -1.5}) {
    drive(2.0, 1.5, yaw_rate);
    for (const double age : {0.04, 0.31, 1.2, 1.97}) {
      EXPECT_EQ(reason_of(now - age), Reason::kAccepted);
      EXPECT_LT(recorder->innovations.back().norm(), 1e-9) << yaw_rate << " " << age;
      EXPECT_NEAR(recorder->used_at.back(), now, 1e-9);
    }
  }
}

TEST_F(LocalizerTest, ALateFixMovesNothingBack) {
  drive(2.0, 1.5, 0.7);
  const Pose2 before = localizer->estimate().pose;
  const std::size_t increments = recorder->increments.size();
  reason_of(now - 1.0);
  EXPECT_EQ(recorder->increments.size(), increments);
  EXPECT_EQ(localizer->estimate().pose.x, before.x);
}

TEST_F(LocalizerTest, FixesOutOfOrderAreUsedInTheOrderOfTheirStamps) {
  drive(1.0);
  for (const double ahead : {0.25, 0.05, 0.15}) {
    localizer->add(Measurement(fix_at(now + ahead)));
  }
  drive(0.5);
  const auto reports = localizer->take_reports();
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_LT(reports[0].stamp, reports[1].stamp);
  EXPECT_LT(reports[1].stamp, reports[2].stamp);
  EXPECT_NEAR(recorder->used_at[0], 11.05, 1e-9);
  EXPECT_NEAR(recorder->used_at[2], 11.25, 1e-9);
}

TEST_F(LocalizerTest, BeforeAnyOdometryNothingIsUsed) {
  EXPECT_EQ(reason_of(now), Reason::kNotStarted);
  drive(0.2);
  EXPECT_EQ(reason_of(now), Reason::kAccepted);
  localizer->start(std::nullopt);
  EXPECT_EQ(reason_of(now), Reason::kNotStarted);
  EXPECT_EQ(recorder->starts, 2);
}

TEST_F(LocalizerTest, StampsOutsideTheWindowAreRefused) {
  const LocalizerParameters parameters;
  drive(parameters.history_length + 1.0);
  EXPECT_EQ(reason_of(now + parameters.future_tolerance + 0.01), Reason::kFutureStamp);
  EXPECT_EQ(reason_of(now - parameters.history_length - kStep - 0.01), Reason::kOldStamp);
  EXPECT_EQ(reason_of(now - parameters.history_length + 0.01), Reason::kAccepted);
  EXPECT_EQ(reason_of(0.0), Reason::kOldStamp);
  EXPECT_EQ(recorder->innovations.size(), 1U);
}

TEST_F(LocalizerTest, AStampThatIsNoNumberIsRefused) {
  drive(1.0);
  GnssFix fix = fix_at(now);
  fix.stamp = std::numeric_limits<double>::quiet_NaN();
  localizer->add(Measurement(fix));
  const auto reports = localizer->take_reports();
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_FALSE(reports[0].innovation.accepted());
  EXPECT_TRUE(recorder->innovations.empty());
}

TEST_F(LocalizerTest, AGyroTurnsNoParkedRobotButASlowTurnOnTheSpotDoes) {
  drive(60.0, 0.0, 0.01);
  EXPECT_EQ(recorder->estimate_.pose.yaw, 0.0);
  drive(20.0, 0.0, 0.03);
  EXPECT_NEAR(recorder->estimate_.pose.yaw, 0.6, 0.05);
  localizer->start(std::nullopt);
  drive(kStep, 0.0, 0.01);
  EXPECT_EQ(recorder->increments.back().yaw_rate, 0.0) << "nothing is left of the turn";
}

TEST_F(LocalizerTest, StartForgetsFixesThatWaited) {
  drive(1.0);
  localizer->add(Measurement(fix_at(now + 0.05)));
  localizer->start(std::nullopt);
  drive(0.5);
  EXPECT_TRUE(recorder->innovations.empty());
}

TEST_F(LocalizerTest, ReportsAreHandedOutOnce) {
  drive(1.0);
  localizer->add(Measurement(fix_at(now - 0.5)));
  EXPECT_EQ(localizer->take_reports().size(), 1U);
  EXPECT_TRUE(localizer->take_reports().empty());
}

TEST_F(LocalizerTest, SaysHowFarFixesLieFromThePoseAndHowFarTheEstimatorReckonedWith) {
  recorder->estimate_.bias = {1.0, 1.0};
  drive(1.0);
  const auto report = [&] {
    drive(0.5);
    GnssFix biased = fix_at(now - 0.2);
    biased.position.y() += 4.0;
    localizer->add(Measurement(biased));
    return localizer->take_reports().back();
  };
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(report().observed_sigma) << "of a pose that is not settled";
  recorder->estimate_.aligned = true;
  MeasurementReport last;
  for (int i = 0; i < 10; ++i) last = report();
  ASSERT_TRUE(last.observed_sigma && last.used_sigma);
  EXPECT_NEAR(*last.observed_sigma, 4.0 / std::sqrt(2.0 * std::log(2.0)), 1e-9);
  EXPECT_NEAR(*last.used_sigma, std::sqrt(2.0 + 1.0), 1e-9);
  EXPECT_TRUE(recorder->covariances.back().isIdentity()) << "the message's counts by default";
}

TEST_F(LocalizerTest, AdaptsTheCovarianceOfFixesWhereAskedTo) {
  LocalizerParameters adaptive;
  adaptive.fix_covariance.source = CovarianceSource::kAdaptive;
  make(adaptive);
  recorder->estimate_.aligned = true;
  drive(1.0);
  for (int i = 0; i < 10; ++i) {
    drive(0.5);
    GnssFix biased = fix_at(now);
    biased.position.y() += 4.0;
    localizer->add(Measurement(biased));
  }
  EXPECT_NEAR(recorder->covariances.back()(0, 0), 16.0 / (2.0 * std::log(2.0)), 1e-9);
  localizer->start(std::nullopt);
  drive(0.5);
  localizer->add(Measurement(fix_at(now)));
  EXPECT_TRUE(recorder->covariances.back().isIdentity()) << "a start forgets";
}

TEST_F(LocalizerTest, APositionThatWasNeverKnownIsNotLostButLookedFor) {
  recorder->estimate_.valid = recorder->estimate_.aligned = true;
  recorder->estimate_.position_covariance_overall = 1e4 * Eigen::Matrix2d::Identity();
  drive(1.0);
  EXPECT_EQ(localizer->state(), Trust::kAligning) << "a robot that stands would never find it";
  recorder->estimate_.position_covariance_overall = Eigen::Matrix2d::Identity();
  drive(1.0);
  recorder->estimate_.position_covariance_overall = 1e4 * Eigen::Matrix2d::Identity();
  drive(1.0);
  EXPECT_EQ(localizer->state(), Trust::kLost);
  localizer->start(std::nullopt);
  drive(1.0);
  EXPECT_EQ(localizer->state(), Trust::kAligning) << "a start forgets";
}

TEST_F(LocalizerTest, IsTunedWhileItRuns) {
  recorder->estimate_.valid = recorder->estimate_.aligned = true;
  drive(1.0);
  EXPECT_EQ(localizer->state(), Trust::kGood);
  load_fields(
      YAML::Load("{lost_sigma: 0.5, fix_covariance: {source: fixed, fixed_sigma: 7}}"),
      [&](ParameterVisitor& field) { localizer->tune(field); }, "");
  EXPECT_EQ(localizer->state(), Trust::kLost);
  localizer->add(Measurement(fix_at(now)));
  EXPECT_EQ(recorder->covariances.back()(0, 0), 49.0);
  EXPECT_EQ(recorder->starts, 1);
}

}  // namespace
}  // namespace multipath_localization
