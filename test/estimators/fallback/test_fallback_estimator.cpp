#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "estimators/fallback/fallback_estimator.hpp"

namespace multipath_localization {
namespace {

/// Starts where it is told, follows the odometry, and says of measurements what it is told.
class Scripted : public Estimator {
 public:
  void start(const std::optional<PosePrior>& from) override {
    ++starts;
    prior = from;
    if (!from) return;
    state.valid = state.aligned = true;
    state.pose = from->pose;
    state.covariance = from->covariance;
    state.position_covariance_overall = from->covariance.topLeftCorner<2, 2>();
  }

  void predict(const OdometryIncrement& u) override {
    state.pose = state.pose * displacement(u);
    state.stamp = u.stamp;
  }

  Innovation update(const Measurement& /*z*/) override {
    ++updates;
    return refused(verdict);
  }

  [[nodiscard]] PoseEstimate estimate() const override { return state; }
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override { return {{state.pose, 1.0, mode}}; }

  void know(double variance) {
    state.valid = state.aligned = true;
    state.covariance = Eigen::Vector3d(variance, variance, 0.01).asDiagonal();
    state.position_covariance_overall = variance * Eigen::Matrix2d::Identity();
  }

  PoseEstimate state;
  Mode mode = Mode::kOpen;
  Reason verdict = Reason::kAccepted;
  std::optional<PosePrior> prior;
  int starts = 0;
  int updates = 0;
};

PseudorangeEpoch sound_epoch() {
  SatelliteObservation observation;
  observation.position = {0.0, 0.0, 2e7};
  observation.pseudorange = 2e7;
  PseudorangeEpoch epoch;
  epoch.observations = {observation};
  return epoch;
}

class FallbackEstimatorTest : public ::testing::Test {
 protected:
  FallbackEstimatorTest() {
    auto one = std::make_unique<Scripted>();
    auto other = std::make_unique<Scripted>();
    epochs = one.get();
    fixes = other.get();
    fixes->mode = Mode::kShadow;
    parameters.after = 2.0;
    parameters.handover_sigma = 0.5;
    filter = std::make_unique<FallbackEstimator>(std::move(one), std::move(other), parameters);
    filter->start(std::nullopt);
  }

  /// Drives and after each step hands over what is asked for; the last answer to a fix.
  Reason drive(double duration, bool with_epochs, bool with_fixes) {
    Reason last = Reason::kUnused;
    for (long i = 0; i < std::lround(duration / kStep); ++i) {
      filter->predict({now += kStep, kStep, 2.0, 0.3});
      if (with_epochs) filter->update(sound_epoch());
      if (with_fixes) last = filter->update(GnssFix{}).reason;
    }
    return last;
  }

  [[nodiscard]] bool speaks_of_fixes() const { return filter->hypotheses().front().mode == Mode::kShadow; }

  static constexpr double kStep = 0.1;
  double now = 50.0;
  FallbackParameters parameters;
  std::unique_ptr<FallbackEstimator> filter;
  Scripted* epochs = nullptr;
  Scripted* fixes = nullptr;
};

TEST_F(FallbackEstimatorTest, NeedsNoFixesWhileEpochsCome) {
  EXPECT_EQ(filter->update(GnssFix{}).reason, Reason::kNotNeeded);
  EXPECT_EQ(drive(10.0, true, true), Reason::kNotNeeded);
  EXPECT_EQ(fixes->updates, 0);
  EXPECT_FALSE(speaks_of_fixes());
  EXPECT_EQ(filter->update(DualAntennaFix{}).reason, Reason::kUnused);
}

TEST_F(FallbackEstimatorTest, EpochsThatAreRefusedCountAsNone) {
  drive(1.0, true, true);
  epochs->verdict = Reason::kTooFewSatellites;
  EXPECT_EQ(drive(1.9, true, true), Reason::kNotNeeded);
  EXPECT_EQ(drive(0.3, true, true), Reason::kAccepted);
  EXPECT_TRUE(speaks_of_fixes());
}

TEST_F(FallbackEstimatorTest, FixesStartWhereTheEpochsWereAndNoSurerThanThat) {
  epochs->know(4.0);
  drive(1.0, true, true);
  const Pose2 before = epochs->estimate().pose;
  epochs->state.position_covariance_overall *= 3.0;  // other hypotheses, elsewhere
  drive(parameters.after + 0.15, false, false);
  filter->update(GnssFix{});
  const PoseEstimate after = fixes->estimate();
  EXPECT_TRUE(after.aligned);
  EXPECT_LT((after.pose.position() - epochs->estimate().pose.position()).norm(), 1e-9);
  EXPECT_NEAR(after.pose.yaw, epochs->estimate().pose.yaw, 1e-9);
  EXPECT_GT((after.pose.position() - before.position()).norm(), 3.0) << "odometry went on meanwhile";
  EXPECT_NEAR(after.position_covariance_overall.trace(), 3.0 * 8.0 + 2.0 * 0.25, 0.01);
  EXPECT_NEAR(fixes->prior->stamp, now - kStep, 1e-9);
}

TEST_F(FallbackEstimatorTest, FixesStartFromNothingWhereTheEpochsHaveNoHeading) {
  epochs->know(4.0);
  epochs->state.aligned = false;
  drive(1.0, true, true);
  drive(3.0, false, true);
  EXPECT_FALSE(fixes->prior.has_value());
  EXPECT_TRUE(speaks_of_fixes());
  EXPECT_FALSE(filter->estimate().aligned);
}

TEST_F(FallbackEstimatorTest, WithFixesAloneThereIsAPose) {
  EXPECT_EQ(drive(1.9, false, true), Reason::kNotNeeded) << "epochs may be under way";
  EXPECT_EQ(drive(1.0, false, true), Reason::kAccepted);
  EXPECT_FALSE(fixes->prior.has_value());
}

TEST_F(FallbackEstimatorTest, AFixThatIsRefusedTakesNothingOver) {
  epochs->know(4.0);
  drive(1.0, true, true);
  fixes->verdict = Reason::kGated;
  EXPECT_EQ(drive(5.0, false, true), Reason::kGated);
  EXPECT_FALSE(speaks_of_fixes());
}

TEST_F(FallbackEstimatorTest, TheOneThatKnowsThePositionBetterSpeaks) {
  epochs->know(1.0);
  drive(1.0, true, true);
  drive(3.0, false, true);
  EXPECT_FALSE(speaks_of_fixes()) << "what was handed over is less sure than what was kept";
  fixes->know(0.5);
  drive(0.1, false, true);
  EXPECT_TRUE(speaks_of_fixes());
  fixes->know(2.0);
  drive(0.1, false, true);
  EXPECT_FALSE(speaks_of_fixes());
  fixes->know(0.5);
  fixes->state.aligned = false;
  drive(0.1, false, true);
  EXPECT_FALSE(speaks_of_fixes());
}

TEST_F(FallbackEstimatorTest, EpochsThatReturnGoOnFromTheFixesWhereThoseKnowMore) {
  epochs->know(1.0);
  drive(1.0, true, true);
  drive(20.0, false, true);
  epochs->know(25.0);
  fixes->know(2.0);
  fixes->state.pose = {7.0, 8.0, 1.0};
  drive(0.1, false, true);
  drive(0.1, true, true);
  EXPECT_FALSE(speaks_of_fixes());
  EXPECT_NEAR(filter->estimate().position_covariance_overall.trace(), 2.0 * (2.0 + 0.25), 0.01);
  EXPECT_LT((filter->estimate().pose.position() - Eigen::Vector2d(7.0, 8.0)).norm(), 0.5);
  EXPECT_EQ(drive(1.0, true, true), Reason::kNotNeeded);
}

TEST_F(FallbackEstimatorTest, EpochsThatReturnKeepTheirOwnWhereTheyKnowMore) {
  epochs->know(1.0);
  drive(1.0, true, true);
  drive(20.0, false, true);
  fixes->know(25.0);
  drive(0.1, true, true);
  EXPECT_FALSE(speaks_of_fixes());
  EXPECT_EQ(epochs->starts, 1);
}

TEST_F(FallbackEstimatorTest, EpochsThatAreNotAlignedGoOnFromFixesThatAre) {
  drive(1.0, true, true);
  drive(5.0, false, true);
  fixes->know(100.0);
  drive(0.1, false, true);
  drive(0.1, true, true);
  EXPECT_TRUE(epochs->prior.has_value());
  EXPECT_TRUE(filter->estimate().aligned);
}

TEST_F(FallbackEstimatorTest, OddOdometryAndOddMeasurementsChangeNothing) {
  filter->predict({std::nan(""), kStep, 1.0, 0.0});
  EXPECT_EQ(filter->update(GnssFix{}).reason, Reason::kNotNeeded) << "no odometry yet";
  drive(1.0, true, true);
  drive(3.0, false, true);
  epochs->verdict = Reason::kNotFinite;
  filter->update(sound_epoch());
  EXPECT_TRUE(speaks_of_fixes());
  EXPECT_EQ(filter->estimate().stamp, now);
}

TEST_F(FallbackEstimatorTest, EpochsThatNobodyCanUseLeaveTheirEstimatorAsItIs) {
  epochs->know(25.0);
  drive(1.0, true, true);
  drive(5.0, false, true);
  fixes->know(2.0);
  drive(0.1, false, true);
  ASSERT_TRUE(speaks_of_fixes());
  const int starts = epochs->starts;
  PseudorangeEpoch timeless = sound_epoch();
  timeless.stamp = std::nan("");
  EXPECT_EQ(filter->update(PseudorangeEpoch{}).reason, Reason::kTooFewSatellites);
  EXPECT_EQ(filter->update(timeless).reason, Reason::kNotFinite);
  EXPECT_EQ(epochs->starts, starts);
}

}  // namespace
}  // namespace multipath_localization
