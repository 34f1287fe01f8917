#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/localization/mirror_check.hpp"

namespace multipath_localization {
namespace {

/// Drives winding ways at 2 m/s with a fix each half second, and counts the fixes after which it is mirrored.
struct WindingDrive {
  double sign = 1.0;       ///< of the yaw rate that odometry tells
  double bend = 0.4;       ///< largest yaw rate [rad/s]
  double fix_sigma = 0.5;  ///< [m]
  double bias = 0.0;       ///< in the second half of each minute [m]
  double course = 0.0;     ///< in the base: 0 forwards, pi/2 to the left [rad]

  int mirrored(MirrorCheck& check, double duration) const {
    int times = 0;
    Pose2 truth{10.0, 20.0, 0.5};
    for (int i = 1; i <= std::lround(10.0 * duration); ++i) {
      const double time = 0.1 * i;
      OdometryIncrement u{time, 0.1, 2.0 * std::cos(course), bend * std::sin(0.2 * time),
                          2.0 * std::sin(course)};
      truth = truth * displacement(u);
      u.yaw_rate *= sign;
      check.add(u);
      if (i % 5 != 0) continue;
      RandomStream random(1, static_cast<std::uint32_t>(i), 0);
      GnssFix fix;
      fix.position = truth.position() + fix_sigma * Eigen::Vector2d(random.normal(), random.normal());
      if (std::fmod(time, 60.0) > 30.0) fix.position.x() += bias;
      check.add(fix);
      times += check.mirrored() ? 1 : 0;
    }
    return times;
  }
};

TEST(MirrorCheck, ARobotThatGoesSidewaysIsNotMirrored) {
  MirrorCheck check;
  WindingDrive drive;
  drive.course = 0.5 * kPi;
  EXPECT_EQ(drive.mirrored(check, 120.0), 0);
  drive.sign = -1.0;
  EXPECT_GT(drive.mirrored(check, 60.0), 10) << "the way counts, however the robot stands to it";
}

TEST(MirrorCheck, FindsOdometryThatTurnsTheOtherWayRound) {
  MirrorCheck check;
  WindingDrive drive;
  drive.sign = -1.0;
  EXPECT_GT(drive.mirrored(check, 40.0), 10);
  EXPECT_TRUE(check.mirrored());
  drive.sign = 1.0;
  drive.mirrored(check, 120.0);
  EXPECT_FALSE(check.mirrored()) << "there is a way back";
  drive.sign = -1.0;
  EXPECT_GT(drive.mirrored(check, 40.0), 10);
  check.clear();
  EXPECT_FALSE(check.mirrored());
}

TEST(MirrorCheck, FindsNothingWhereNothingIsWrong) {
  for (const double sigma : {0.1, 3.0, 10.0}) {
    for (const double bias : {0.0, 8.0, 30.0}) {
      MirrorCheck check;
      WindingDrive drive;
      drive.fix_sigma = sigma;
      drive.bias = bias;
      EXPECT_EQ(drive.mirrored(check, 600.0), 0) << sigma << " " << bias;
    }
  }
}

TEST(MirrorCheck, TellsNothingOfAStraightWay) {
  MirrorCheck check;
  WindingDrive drive;
  drive.sign = -1.0;
  drive.bend = 0.0;
  EXPECT_EQ(drive.mirrored(check, 120.0), 0);
}

TEST(MirrorCheck, IsNotTakenInByWheelsThatFail) {
  MirrorCheck check;
  WindingDrive drive;
  drive.sign = 0.0;
  EXPECT_EQ(drive.mirrored(check, 120.0), 0);
}

}  // namespace
}  // namespace multipath_localization
