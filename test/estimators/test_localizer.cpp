#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "multipath_localization/estimators/localizer.hpp"

namespace multipath_localization {
namespace {

/// Follows the odometry exactly, accepts every fix, and remembers what it was told.
class Recorder : public Estimator {
 public:
  void start(const std::optional<PosePrior>& prior) override {
    ++starts;
    estimate_.pose = prior ? prior->pose : Pose2{};
    increments.clear();
    innovations.clear();
  }

  void predict(const OdometryIncrement& u) override {
    increments.push_back(u);
    estimate_.pose = estimate_.pose * displacement(u);
    estimate_.stamp = u.stamp;
  }

  Innovation update(const Measurement& z) override {
    Innovation innovation;
    innovation.reason = verdict;
    innovation.covariance = 2.0 * Eigen::Matrix2d::Identity();
    if (!std::holds_alternative<GnssFix>(z)) return innovation;
    const auto& fix = std::get<GnssFix>(z);
    innovation.innovation = fix.position - estimate_.pose * fix.antenna_in_base;
    innovations.push_back(innovation.innovation);
    covariances.push_back(fix.covariance);
    used_at.push_back(estimate_.stamp);
    return innovation;
  }

  [[nodiscard]] PoseEstimate estimate() const override { return estimate_; }
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override { return {}; }

  PoseEstimate estimate_;
  Reason verdict = Reason::kAccepted;
  int starts = 0;
  std::vector<OdometryIncrement> increments;
  std::vector<Eigen::Vector2d> innovations;
  std::vector<Eigen::Matrix2d> covariances;
  std::vector<double> used_at;
};

constexpr double kStep = 0.1;
const Eigen::Vector2d kAntenna(0.5, 0.2);

class LocalizerTest : public testing::Test {
 protected:
  LocalizerTest() { make(LocalizerParameters{}); }

  void make(const LocalizerParameters& parameters) {
    auto made = std::make_unique<Recorder>();
    recorder = made.get();
    localizer = std::make_unique<Localizer>(std::move(made), parameters);
    localizer->start(std::nullopt);
  }

  /// Drives for a while in steps of kStep.
  void drive(double duration, double speed = 1.0, double yaw_rate = 0.0) {
    const double end = now + duration;
    while (now < end - 1e-9) {
      const OdometryIncrement u{now + kStep, kStep, speed, yaw_rate};
      now += kStep;
      path.push_back(u);
      localizer->add(u);
    }
  }

  /// Where the base truly was, by the odometry so far.
  [[nodiscard]] Pose2 base_in_map(double stamp) const {
    Pose2 pose;
    for (OdometryIncrement u : path) {
      const double start = u.stamp - u.duration;
      if (start >= stamp) break;
      u.duration = std::min(u.duration, stamp - start);
      pose = pose * displacement(u);
    }
    return pose;
  }

  /// A faultless fix as it is measured at `stamp`.
  [[nodiscard]] GnssFix fix_at(double stamp) const {
    GnssFix fix;
    fix.stamp = stamp;
    fix.antenna_in_base = kAntenna;
    fix.position = base_in_map(stamp) * kAntenna;
    return fix;
  }

  /// The one report there is.
  Reason reason_of(double stamp) {
    localizer->take_reports();
    localizer->add(Measurement(fix_at(stamp)));
    const auto reports = localizer->take_reports();
    EXPECT_EQ(reports.size(), 1U);
    return reports.empty() ? Reason::kUnused : reports[0].innovation.reason;
  }

  Recorder* recorder = nullptr;
  std::unique_ptr<Localizer> localizer;
  std::vector<OdometryIncrement> path;
  double now = 10.0;
};

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

TEST_F(LocalizerTest, SaysThatOdometryContradictsTheFixesBeforeItAsksToDriveOn) {
  drive(0.5);
  recorder->estimate_.valid = true;
  recorder->estimate_.wheel_fault_probability = 0.4;
  EXPECT_NE(localizer->state_reason().find("drive on"), std::string::npos);
  recorder->estimate_.wheel_fault_probability = 0.6;
  EXPECT_EQ(localizer->state(), Trust::kAligning);
  EXPECT_EQ(localizer->state_reason(),
            "odometry contradicts the fixes: do the wheels slip, does an encoder fail?");
}

TEST_F(LocalizerTest, ReportsAreHandedOutOnce) {
  drive(1.0);
  localizer->add(Measurement(fix_at(now - 0.5)));
  EXPECT_EQ(localizer->take_reports().size(), 1U);
  EXPECT_TRUE(localizer->take_reports().empty());
}

TEST_F(LocalizerTest, TrustFollowsTheEstimateAndTheFixes) {
  PoseEstimate& estimate = recorder->estimate_;
  std::set<std::string> reasons;
  const auto expect = [&](Trust expected) {
    EXPECT_EQ(localizer->state(), expected) << to_string(localizer->state());
    EXPECT_TRUE(reasons.insert(localizer->state_reason()).second) << localizer->state_reason();
  };
  expect(Trust::kNotReady);
  drive(0.5);
  expect(Trust::kNotReady);  // now for the want of a fix
  estimate.valid = true;
  expect(Trust::kAligning);
  estimate.aligned = true;
  expect(Trust::kGood);
  estimate.shadow_probability = 0.9;
  expect(Trust::kMultipath);
  drive(LocalizerParameters{}.dead_reckoning_after + 1.0);
  expect(Trust::kDeadReckoning);
  estimate.position_covariance_overall *= 1e5;
  expect(Trust::kLost);
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
  adaptive.fix_covariance.source = "adaptive";
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

TEST_F(LocalizerTest, SaysHowFarToDriveUntilThePoseIsConfirmed) {
  recorder->estimate_.valid = true;
  drive(1.0);
  EXPECT_EQ(localizer->state_reason(), "heading or position not yet confirmed, drive on under open sky");
  recorder->estimate_.way_to_alignment = 6.3;
  EXPECT_EQ(localizer->state_reason(),
            "heading or position not yet confirmed, drive about 7 m more under open sky");
}

TEST_F(LocalizerTest, AReceiverIsFrozenOnceTheRobotHasDrivenOn) {
  recorder->estimate_.valid = recorder->estimate_.aligned = true;
  drive(1.0);
  GnssFix fix = fix_at(now);
  const auto repeated = [&] {
    recorder->verdict = Reason::kFrozen;
    fix.stamp = now;
    localizer->add(Measurement(fix));
    return localizer->take_reports().back().innovation.reason;
  };
  EXPECT_EQ(reason_of(now), Reason::kAccepted);
  drive(60.0, 0.0);
  EXPECT_EQ(repeated(), Reason::kRepeated) << "of a robot that stands";
  EXPECT_EQ(localizer->state(), Trust::kGood);
  EXPECT_FALSE(localizer->frozen());
  drive(1.9);
  EXPECT_EQ(repeated(), Reason::kRepeated);
  drive(4.0);
  EXPECT_EQ(repeated(), Reason::kFrozen);
  ASSERT_TRUE(localizer->frozen());
  EXPECT_NEAR(localizer->frozen()->duration, 65.9, 1e-6);
  EXPECT_NEAR(localizer->frozen()->driven, 5.9, 1e-6);
  EXPECT_EQ(localizer->state_reason(), "receiver frozen, running on odometry");
  recorder->verdict = Reason::kAccepted;
  EXPECT_EQ(reason_of(now), Reason::kAccepted);
  EXPECT_FALSE(localizer->frozen());
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

TEST_F(LocalizerTest, MirroredOdometryConfirmsNoPose) {
  recorder->estimate_.valid = recorder->estimate_.aligned = true;
  Pose2 truth;
  const auto turn = [&](double sign) {
    for (int i = 0; i < 300; ++i) {
      const OdometryIncrement u{now + kStep, kStep, 1.0, 0.2};
      now += kStep;
      truth = truth * displacement(u);
      localizer->add({u.stamp, u.duration, u.speed, sign * u.yaw_rate});
      GnssFix fix;
      fix.stamp = now;
      fix.position = truth.position();
      if (i % 5 == 0) localizer->add(Measurement(fix));
    }
  };
  turn(1.0);
  EXPECT_EQ(localizer->state(), Trust::kGood);
  localizer->start(std::nullopt);
  recorder->estimate_.aligned = true;
  turn(-1.0);
  EXPECT_EQ(localizer->state(), Trust::kAligning);
  EXPECT_NE(localizer->state_reason().find("mirrored, or NED"), std::string::npos);
  localizer->start(std::nullopt);
  EXPECT_FALSE(localizer->mirrored());
}

TEST_F(LocalizerTest, OnlyAnAcceptedFixEndsDeadReckoning) {
  recorder->estimate_.valid = recorder->estimate_.aligned = true;
  drive(LocalizerParameters{}.dead_reckoning_after + 1.0);
  ASSERT_EQ(localizer->state(), Trust::kDeadReckoning);
  recorder->verdict = Reason::kGated;
  EXPECT_EQ(reason_of(now), Reason::kGated);
  EXPECT_EQ(localizer->state(), Trust::kDeadReckoning);
  recorder->verdict = Reason::kAccepted;
  EXPECT_EQ(reason_of(now), Reason::kAccepted);
  EXPECT_EQ(localizer->state(), Trust::kGood);
  recorder->estimate_.canyon_probability = 0.9;
  EXPECT_EQ(localizer->state(), Trust::kMultipath);
}

TEST_F(LocalizerTest, TheReasonTellsWhatItRunsOnAndWhatIsMissed) {
  recorder->estimate_.valid = recorder->estimate_.aligned = true;
  drive(1.0);
  PseudorangeEpoch epoch;
  epoch.stamp = now;
  localizer->add(Measurement(epoch));
  EXPECT_EQ(localizer->state_reason(), "pseudoranges agree with odometry");
  drive(7.0);
  reason_of(now);
  EXPECT_EQ(localizer->state_reason(), "fixes agree with odometry, no pseudoranges for 7 s");
  drive(5.0);
  epoch.stamp = now;
  localizer->add(Measurement(epoch));
  EXPECT_EQ(localizer->state_reason(), "pseudoranges agree with odometry") << "fixes are not missed";
  localizer->start(std::nullopt);
  drive(1.0);
  reason_of(now);
  EXPECT_EQ(localizer->state_reason(), "fixes agree with odometry");
}

TEST_F(LocalizerTest, AnUncertaintyThatIsNoNumberIsLost) {
  recorder->estimate_.valid = recorder->estimate_.aligned = true;
  drive(0.5);
  recorder->estimate_.position_covariance_overall.fill(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(localizer->state(), Trust::kLost);
}

}  // namespace
}  // namespace multipath_localization
