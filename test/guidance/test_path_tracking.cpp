#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/guidance/path_tracking.hpp"

namespace multipath_localization {
namespace {

const PathPoint kEast{{0.0, 0.0}, 0.0, 0.0};

/// Offset after every centimetre of a way of 10 L, from an offset of `start` [m], where L is 2 m.
std::vector<double> offsets(double start) {
  Pose2 pose{0.0, start, 0.0};
  std::vector<double> all;
  for (int i = 0; i < 2000; ++i) {
    const PathPoint foot{{pose.x, 0.0}, 0.0, 0.0};
    pose = pose * displacement({0.0, 0.01, 1.0, tracking_curvature(pose, foot, 0.0, 2.0, 10.0)});
    all.push_back(pose.y);
  }
  return all;
}

TEST(PathTracking, AsksForThePathsCurvatureOnThePath) {
  EXPECT_EQ(tracking_curvature({0.0, 0.0, 0.0}, kEast, 0.3, 2.0, 1.0), 0.3);
  EXPECT_EQ(tracking_curvature({0.0, 0.0, 2.0 * kPi}, kEast, 0.3, 2.0, 1.0), 0.3);
}

TEST(PathTracking, IsCriticallyDampedInTheWay) {  // e = e0 (1 + s / L) exp(-s / L)
  const std::vector<double> e = offsets(0.01);
  for (std::size_t i = 0; i < e.size(); ++i) {
    const double s = 0.01 * static_cast<double>(i + 1);
    ASSERT_NEAR(e[i], 0.01 * (1.0 + 0.5 * s) * std::exp(-0.5 * s), 1e-4);
  }
}

TEST(PathTracking, ComesBackFromAfarWithoutOvershoot) {
  for (const double start : {-30.0, -4.0, 1.0, 10.0}) {
    for (const double e : offsets(start)) ASSERT_GT(e * start, -1e-3 * start * start);
  }
  EXPECT_LT(std::abs(offsets(10.0).back()), 0.1);
}

/// A base far outside of a bend that was its way would drive round and round, or off for ever.
TEST(PathTracking, DoesNotCountBendsFarOffThePath) {
  const Pose2 far_right{0.0, -20.0, 0.3};
  EXPECT_EQ(tracking_curvature(far_right, kEast, -3.0, 2.0, 10.0),
            tracking_curvature(far_right, kEast, 0.0, 2.0, 10.0));
}

TEST(PathTracking, TurnsRoundWhenHeadingBackAndKeepsTheTightestCurvature) {
  EXPECT_EQ(tracking_curvature({0.0, 0.0, 3.0}, kEast, 0.0, 2.0, 0.7), -0.7);
  EXPECT_EQ(tracking_curvature({0.0, 0.0, -3.0}, kEast, 0.0, 2.0, 0.7), 0.7);
  EXPECT_EQ(tracking_curvature({0.0, 0.0, 1.5}, kEast, 5.0, 2.0, 0.7), 0.7);
}

}  // namespace
}  // namespace multipath_localization
