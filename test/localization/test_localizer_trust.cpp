#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "localizer_fixture.hpp"
#include "multipath_localization/localization/localizer.hpp"

namespace multipath_localization {
namespace {

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
  recorder->estimate_.shadow_probability = 0.9;
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
