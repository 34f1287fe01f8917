#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "models/motion/wheel_odometer.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep = 0.05;
const WheelGeometry kGeometry{0.1, 0.5, 1.2, 0.0};

/// Both wheels' positions, with speeds such that the base drives 1 m/s and turns by 0.4 rad/s.
WheelReadings turning(double time) { return {{{9.0 * time}}, {{11.0 * time}}, {}}; }

/// Where a base that began at the origin is after these readings, one every kStep.
Pose2 driven(WheelOdometer& odometer, double seconds, const std::function<WheelReadings(double)>& readings) {
  Pose2 pose;
  for (int i = 0; i <= std::lround(seconds / kStep); ++i) {
    const WheelMotion told = odometer.take(1.0 + kStep * i, readings(kStep * i));
    EXPECT_EQ(told.reason, Reason::kAccepted);
    if (told.motion) pose = pose * displacement(*told.motion);
  }
  return pose;
}

void expect_near(const Pose2& pose, const Pose2& expected) {
  EXPECT_NEAR(pose.x, expected.x, 1e-6);
  EXPECT_NEAR(pose.y, expected.y, 1e-6);
  EXPECT_NEAR(wrap_angle(pose.yaw - expected.yaw), 0.0, 1e-6);
}

/// On a circle to the left of that radius.
Pose2 on_circle(double radius, double turn) {
  return {radius * std::sin(turn), radius * (1.0 - std::cos(turn)), turn};
}

TEST(WheelOdometer, OfTwoWheelsIsADifferentialDrive) {
  WheelOdometer odometer(kGeometry, {});
  expect_near(driven(odometer, 10.0, turning), on_circle(2.5, 4.0));
}

TEST(WheelOdometer, OfFourWheelsIsThatOfTheMeanOfEachSide) {
  WheelOdometer odometer(kGeometry, {});
  const auto four = [](double time) {
    return WheelReadings{{{8.0 * time}, {10.0 * time}}, {{11.5 * time}, {10.5 * time}}, {}};
  };
  expect_near(driven(odometer, 10.0, four), on_circle(2.5, 4.0));
}

TEST(WheelOdometer, OfSteeredWheelsIsABicycle) {
  WheelOdometer odometer(kGeometry, {});
  const double angle = std::atan(1.2 / 3.0);
  const auto tricycle = [angle](double time) { return WheelReadings{{{10.0 * time}}, {}, {{angle}}}; };
  expect_near(driven(odometer, 10.0, tricycle), on_circle(3.0, 10.0 / 3.0));
  WheelOdometer two_sides(kGeometry, {});
  const auto car = [angle](double time) {
    return WheelReadings{{{9.0 * time}}, {{11.0 * time}}, {{angle + 0.01}, {angle - 0.01}}};
  };
  expect_near(driven(two_sides, 10.0, car), on_circle(3.0, 10.0 / 3.0));
}

TEST(WheelOdometer, OfSpeedAndSteeringIsTheSameBicycle) {
  WheelOdometer odometer(kGeometry, {});
  Pose2 pose;
  for (int i = 0; i <= 200; ++i) {
    const WheelMotion told = odometer.take(1.0 + kStep * i, DriveReading{-1.0, std::atan(1.2 / 3.0)});
    EXPECT_EQ(told.motion.has_value(), i > 0);
    if (told.motion) pose = pose * displacement(*told.motion);
  }
  expect_near(pose, on_circle(3.0, -10.0 / 3.0));
}

TEST(WheelOdometer, OfABaseAheadOfItsAxleGoesSideways) {
  WheelGeometry geometry = kGeometry;
  geometry.axle = -0.6;
  WheelOdometer odometer(geometry, {});
  const Pose2 start{0.6, 0.0, 0.0};  // of the base, seen from the axle
  const Pose2 base = start * driven(odometer, 10.0, turning);
  expect_near(base, on_circle(2.5, 4.0) * start);
}

TEST(WheelOdometer, LosesNothingWithLostReadings) {
  WheelOdometer odometer(kGeometry, {});
  Pose2 pose;
  for (const int i : {0, 1, 2, 3, 9, 10, 30, 70, 71, 100}) {
    const WheelMotion told = odometer.take(1.0 + kStep * i, turning(kStep * i));
    if (told.motion) pose = pose * displacement(*told.motion);
  }
  expect_near(pose, on_circle(2.5, 2.0));
}

TEST(WheelOdometer, RefusesWhatIsNotToldAndBridgesIt) {
  WheelOdometer odometer(kGeometry, {});
  odometer.take(1.0, turning(0.0));
  EXPECT_EQ(odometer.take(1.05, WheelReadings{{{0.45}}, {{kNan, kNan}}, {}}).reason, Reason::kNotFinite);
  const WheelMotion told = odometer.take(1.1, turning(0.1));
  EXPECT_NEAR(told.motion->duration, 0.1, 1e-9);
  EXPECT_NEAR(told.motion->yaw_rate, 0.4, 1e-9);
  EXPECT_EQ(odometer.take(1.2, DriveReading{kNan, 0.0}).reason, Reason::kNotFinite);
  EXPECT_EQ(odometer.take(1.2, DriveReading{0.0, kNan}).reason, Reason::kNotFinite);
  EXPECT_EQ(odometer.take(1.2, WheelReadings{{{1.0}}, {}, {{kNan, 3.0}}}).reason, Reason::kNotFinite);
}

TEST(WheelOdometer, RefusesStampsThatDoNotGoOn) {
  WheelOdometer odometer(kGeometry, {});
  EXPECT_EQ(odometer.take(0.0, turning(0.0)).reason, Reason::kZeroStamp);
  odometer.take(10.0, turning(0.0));
  odometer.take(10.1, turning(0.1));
  EXPECT_EQ(odometer.take(10.1, turning(0.1)).reason, Reason::kOldStamp);
  EXPECT_EQ(odometer.take(10.05, turning(0.05)).reason, Reason::kOldStamp);
  EXPECT_NEAR(odometer.take(10.2, turning(0.2)).motion->duration, 0.1, 1e-9);
}

TEST(WheelOdometer, BeginsAfreshWhereTimeLeaps) {
  for (const double stamp : {2.0, 100.0}) {
    WheelOdometer odometer(kGeometry, {});
    odometer.take(10.0, turning(0.0));
    odometer.take(10.1, turning(0.1));
    const WheelMotion leapt = odometer.take(stamp, turning(7.0));
    EXPECT_EQ(leapt.reason, Reason::kAccepted);
    EXPECT_FALSE(leapt.motion);
    EXPECT_NEAR(odometer.take(stamp + 0.1, turning(7.1)).motion->speed, 1.0, 1e-9);
  }
}

TEST(WheelOdometer, RefusesALeapOfAnEncoderAndGoesOnFromThere) {
  WheelOdometer odometer(kGeometry, {});
  odometer.take(1.0, turning(100.0));
  EXPECT_EQ(odometer.take(1.05, WheelReadings{{{0.0}}, {{0.0}}, {}}).reason, Reason::kTooFast);
  const WheelMotion told = odometer.take(1.1, WheelReadings{{{0.45}}, {{0.55}}, {}});
  EXPECT_NEAR(told.motion->speed, 1.0, 1e-9);
}

TEST(WheelOdometer, RefusesWhatNoBaseDoes) {
  WheelOdometer odometer(kGeometry, {});
  EXPECT_EQ(odometer.take(1.0, DriveReading{99.0, 0.0}).reason, Reason::kTooFast);
  EXPECT_EQ(odometer.take(1.0, DriveReading{1.0, 20.0}).reason, Reason::kTooFast) << "degrees";
  EXPECT_EQ(odometer.take(1.0, DriveReading{9.0, 1.5}).reason, Reason::kTooFast);
  EXPECT_EQ(odometer.take(1.0, DriveReading{1.0, 0.3}).reason, Reason::kAccepted);
}

}  // namespace
}  // namespace multipath_localization
