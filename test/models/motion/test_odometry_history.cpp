#include <gtest/gtest.h>

#include <limits>

#include "../core/pose_near.hpp"
#include "multipath_localization/models/motion/odometry_history.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.1;

/// A winding drive; the true pose at any time comes from composing its arcs from the start.
struct Drive {
  static OdometryIncrement increment(int i) {
    return {kStep * (i + 1), kStep, 2.0 - 0.05 * i, 0.8 * std::sin(0.3 * i)};
  }
  static Pose2 base_in_odom(double stamp) {
    Pose2 pose;
    for (int i = 0; i * kStep < stamp; ++i) {
      OdometryIncrement u = increment(i);
      u.duration = std::min(kStep, stamp - i * kStep);
      pose = pose * displacement(u);
    }
    return pose;
  }
};

OdometryHistory driven(double length, int increments) {
  OdometryHistory history(length);
  for (int i = 0; i < increments; ++i) history.add(Drive::increment(i));
  return history;
}

TEST(OdometryHistory, RecoversThePoseAtALateStampExactlyAlongArcs) {
  const OdometryHistory history = driven(10.0, 60);
  const Pose2 now_in_odom = Drive::base_in_odom(6.0);
  for (double stamp = 0.013; stamp < 6.0; stamp += 0.037) {
    const auto then_in_now = history.base_then_in_base_now(stamp);
    ASSERT_TRUE(then_in_now.has_value()) << stamp;
    EXPECT_TRUE(PoseNear(now_in_odom * *then_in_now, Drive::base_in_odom(stamp), 1e-9)) << stamp;
  }
}

TEST(OdometryHistory, NowIsTheIdentity) {
  const OdometryHistory history = driven(10.0, 3);
  const auto now = history.base_then_in_base_now(Drive::increment(2).stamp);
  ASSERT_TRUE(now.has_value());
  EXPECT_TRUE(PoseNear(*now, Pose2{}, 1e-12));
}

TEST(OdometryHistory, KnowsNothingOutsideItsWindow) {
  const OdometryHistory history = driven(2.0, 60);
  EXPECT_FALSE(history.base_then_in_base_now(6.0 + 1e-6).has_value());
  EXPECT_TRUE(history.base_then_in_base_now(4.0 + 1e-6).has_value());
  EXPECT_FALSE(history.base_then_in_base_now(4.0 - kStep - 1e-6).has_value());
  EXPECT_FALSE(history.base_then_in_base_now(-1.0).has_value());
  EXPECT_FALSE(history.base_then_in_base_now(std::numeric_limits<double>::quiet_NaN()).has_value());
}

TEST(OdometryHistory, KnowsNothingWithinAGapOfTheOdometry) {
  OdometryHistory history(10.0);
  history.add({1.0, 0.1, 1.0, 0.0});
  history.add({2.0, 0.1, 1.0, 0.0});
  EXPECT_FALSE(history.base_then_in_base_now(1.5).has_value());
  EXPECT_TRUE(history.base_then_in_base_now(1.95).has_value());
  EXPECT_TRUE(history.base_then_in_base_now(0.95).has_value());
}

TEST(OdometryHistory, IsEmptyAfterClear) {
  OdometryHistory history = driven(10.0, 5);
  EXPECT_FALSE(history.empty());
  history.clear();
  EXPECT_TRUE(history.empty());
  EXPECT_FALSE(history.base_then_in_base_now(0.3).has_value());
}

}  // namespace
}  // namespace multipath_localization
