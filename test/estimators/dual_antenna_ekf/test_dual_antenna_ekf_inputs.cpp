#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "estimators/dual_antenna_ekf/dual_antenna_ekf.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "simulated_drive.hpp"
#include "slipping_robot.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = SlippingRobot::kStep;
constexpr int kStepsPerFix = SlippingRobot::kStepsPerFix;
const double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(DualAntennaEkf, RefusesPairsThatBetrayAnAntennaThatIsOff) {
  SlippingRobot robot(7);
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 5.0);
  const std::vector<double> before = numbers_of(filter.estimate());
  robot.drive();
  DualAntennaFix reflected = robot.pair();
  reflected.left.position += rotation(robot.truth.yaw) * Eigen::Vector2d(0.0, 0.1);
  EXPECT_EQ(filter.update(reflected).reason, Reason::kWrongBaseline);
  robot.drive();
  DualAntennaFix merged = robot.pair();
  merged.right.position = merged.left.position + Eigen::Vector2d(1e-4, 0.0);
  EXPECT_EQ(filter.update(merged).reason, Reason::kWrongBaseline);
  robot.drive();
  DualAntennaFix unmounted = robot.pair();
  unmounted.left.antenna_in_base = unmounted.right.antenna_in_base;
  EXPECT_EQ(filter.update(unmounted).reason, Reason::kWrongBaseline);
  EXPECT_EQ(numbers_of(filter.estimate()), before);
}

TEST(DualAntennaEkf, RefusesAGrossOutlierAndGivesWayToOneThatLasts) {
  const DualAntennaEkfParameters parameters;
  SlippingRobot robot(8);
  DualAntennaEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 5.0);
  const Pose2 before = robot.truth;
  robot.truth = {before.x + 30.0, before.y - 40.0, before.yaw + 2.5};  // carried away
  robot.run(filter, 0.2);
  EXPECT_EQ(robot.last.reason, Reason::kGated);
  robot.run(filter, parameters.reopen_after - 0.4);
  EXPECT_EQ(robot.last.reason, Reason::kGated);
  robot.run(filter, 1.0);
  EXPECT_EQ(robot.last.reason, Reason::kAccepted);
  EXPECT_LT(distance(filter, robot.truth), 0.05);
  EXPECT_LT(std::abs(heading_error(filter, robot.truth)), 5.0 * kDegree);
}

TEST(DualAntennaEkf, SingleFixesThatAgreeKeepNoPairsOut) {
  SlippingRobot robot(9);
  robot.wheels = {};
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 5.0);
  // Turned by hand about the left antenna, whose fixes come singly as well.
  robot.truth = robot.truth * Pose2{0.0, 0.5 * kBaseline, 0.0} * Pose2{0.0, 0.0, 1.5} *
                Pose2{0.0, -0.5 * kBaseline, 0.0};
  for (int i = 0; i < 50; ++i) {
    robot.run(filter, 0.2);
    GnssFix left = robot.pair().left;
    left.position.x() += 1e-4;
    filter.update(left);
  }
  EXPECT_EQ(robot.last.reason, Reason::kAccepted);
  EXPECT_LT(std::abs(heading_error(filter, robot.truth)), 3.0 * kDegree);
}

TEST(DualAntennaEkf, HoldsThePositionOnOneAntennaAndTheHeadingByMotion) {
  SlippingRobot robot(10);
  DualAntennaEkfParameters parameters;
  DualAntennaEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 5.0);
  RootMeanSquare error;
  double worst_heading_error = 0.0;
  for (int i = 0; i < 300; ++i) {
    for (int k = 0; k < kStepsPerFix; ++k) filter.predict(robot.drive());
    ASSERT_TRUE(filter.update(robot.pair().right).accepted());
    error.add(position_error(filter.estimate(), robot.truth));
    worst_heading_error = std::max(worst_heading_error, std::abs(heading_error(filter, robot.truth)));
  }
  EXPECT_LT(error.value(), 0.01);
  EXPECT_LT(worst_heading_error, 10.0 * kDegree);
  EXPECT_TRUE(filter.estimate().aligned);
}

TEST(DualAntennaEkf, ASingleFixIsWeighedWithTheMeanErrorToo) {
  DualAntennaEkfParameters parameters;
  parameters.subtract_mean = true;
  SlippingRobot robot(11);
  robot.wheels = {};
  robot.fix_sigma = 0.0;
  robot.pose_error = PoseError(parameters.pose_error).mean;
  DualAntennaEkf filter(parameters);
  filter.start(at(robot.truth));
  filter.predict(robot.drive());
  EXPECT_LT(filter.update(robot.pair().left).innovation.norm(), 1e-9);
}

TEST(DualAntennaEkf, FollowsFixesUntilAPairTellsTheHeading) {
  SlippingRobot robot(12);
  robot.fix_sigma = 0.5;  // no RTK yet
  DualAntennaEkfParameters parameters;
  DualAntennaEkf filter(parameters);
  filter.start(std::nullopt);
  EXPECT_TRUE(filter.update(robot.pair().left).accepted());
  robot.run(filter, 5.0);
  EXPECT_TRUE(filter.estimate().valid);
  EXPECT_FALSE(filter.estimate().aligned);
  EXPECT_LT(distance(filter, robot.truth), 2.0);
  robot.fix_sigma = 0.004;
  robot.run(filter, 0.2);
  EXPECT_TRUE(filter.estimate().aligned);
  EXPECT_LT(distance(filter, robot.truth), 0.02);
}

TEST(DualAntennaEkf, ALatePairCountsAtItsOwnStamp) {
  SlippingRobot robot(13, 0.0);
  robot.wheels = {0.6, 1.0};  // 0.8 m/s, 1.14 rad/s
  Localizer localizer(std::make_unique<DualAntennaEkf>(DualAntennaEkfParameters{}), LocalizerParameters{});
  localizer.start(std::nullopt);
  std::optional<DualAntennaFix> underway;
  for (int i = 1; i <= 2000; ++i) {
    localizer.add(robot.drive());
    if (i % kStepsPerFix == 0) underway = robot.pair();
    if (i % kStepsPerFix == 15 && underway) localizer.add(Measurement(*underway));  // 0.15 s late
    if (i > 100) {
      ASSERT_LT(position_error(localizer.estimate(), robot.truth).norm(), 0.02) << i;
      ASSERT_LT(std::abs(angle_difference(localizer.estimate().pose.yaw, robot.truth.yaw)), 5.0 * kDegree);
    }
  }
}

TEST(DualAntennaEkf, RefusesBadInputByItsReasonAndKeepsItsState) {
  SlippingRobot robot(14);
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 1.0);
  filter.predict(robot.drive());
  const std::vector<double> before = numbers_of(filter.estimate());
  const auto reason_of = [&](const std::function<void(DualAntennaFix&)>& spoil) {
    robot.drive();
    DualAntennaFix fixes = robot.pair();
    spoil(fixes);
    return filter.update(fixes).reason;
  };
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.stamp = kNan; }), Reason::kNotFinite);
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.left.position.x() = kNan; }), Reason::kNotFinite);
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.right.position.y() += 1e9; }), Reason::kInvalidPosition);
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.right.covariance(0, 0) = -1.0; }),
            Reason::kInvalidCovariance);
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.left.antenna_in_base.x() = kNan; }), Reason::kNotFinite);
  GnssFix single = robot.pair().left;
  single.covariance(0, 1) = kNan;
  EXPECT_EQ(filter.update(single).reason, Reason::kNotFinite);
  EXPECT_EQ(filter.update(PseudorangeEpoch{}).reason, Reason::kUnused);
  filter.predict({robot.time, kStep, kNan, 0.0});
  filter.predict({robot.time, 0.0, 1.0, 0.0});
  EXPECT_EQ(numbers_of(filter.estimate()), before);
  EXPECT_TRUE(all_finite(filter.estimate()));
}

TEST(DualAntennaEkf, ParkedOneReceiverMayRepeatItselfButNotBoth) {
  SlippingRobot robot(15);
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 1.0);
  robot.wheels = {0.0, 0.0};
  const DualAntennaFix stuck = robot.pair();
  for (int k = 0; k < kStepsPerFix; ++k) filter.predict(robot.drive());
  DualAntennaFix half_stuck = robot.pair();
  half_stuck.right = stuck.right;
  EXPECT_EQ(filter.update(half_stuck).reason, Reason::kAccepted);
  EXPECT_EQ(filter.update(half_stuck).reason, Reason::kFrozen);
  robot.run(filter, 0.2);
  EXPECT_EQ(robot.last.reason, Reason::kAccepted);
}

TEST(DualAntennaEkf, UnusablePriorsCountForNothingAndWideOnesLeaveTheHeadingOpen) {
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(at({kNan, 0.0, 0.0}));
  EXPECT_FALSE(filter.estimate().valid);
  PosePrior wide = at({3.0, 4.0, 0.5});
  wide.covariance(2, 2) = 1.0;
  filter.start(wide);
  EXPECT_TRUE(filter.estimate().valid);
  EXPECT_FALSE(filter.estimate().aligned);
  filter.start(at({3.0, 4.0, 0.5}));
  EXPECT_TRUE(filter.estimate().aligned);
}

}  // namespace
}  // namespace multipath_localization
