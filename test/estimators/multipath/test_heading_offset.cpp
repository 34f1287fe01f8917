#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "estimators/multipath/heading_offset.hpp"
#include "multipath_localization/core/angle.hpp"

namespace multipath_localization::multipath {
namespace {

/// What is found of headings that are `told` of the yaw while the robot turns at `yaw_rate` [rad/s] for a
/// minute.
std::optional<double> found(double yaw_rate, const std::function<double(double yaw)>& told,
                            double believed = 0.0, double yaw_variance = 1e-4) {
  HeadingOffset offset;
  Mixture mixture;
  mixture.heading = believed;
  mixture.covariance(2, 2) = yaw_variance;
  for (int i = 0; i < 60; ++i) {
    mixture.mean(kYaw) = wrap_angle(yaw_rate * i);
    HeadingSighting sighting;
    sighting.yaw = wrap_angle(told(mixture.mean(kYaw)));
    if (const auto answer = offset.judge(sighting, mixture)) return answer;
  }
  return std::nullopt;
}

double turned_about(double yaw) { return yaw + kPi; }

TEST(HeadingOffset, FindsWhatIsTheSameWhicheverWayTheRobotPoints) {
  const std::optional<double> answer = found(0.1, turned_about);
  ASSERT_TRUE(answer);
  EXPECT_NEAR(std::abs(*answer), kPi, 1e-9);
  EXPECT_NEAR(found(-0.1, [](double yaw) { return yaw - 1.5; }).value_or(0.0), -1.5, 1e-9);
}

TEST(HeadingOffset, FindsNoneInAnotherSignOrAFrozenHeading) {
  EXPECT_FALSE(found(0.1, [](double yaw) { return -yaw; }));
  EXPECT_FALSE(found(0.1, [](double) { return 1.0; }));
}

TEST(HeadingOffset, OverlooksOutliers) {
  int told = 0;
  const auto with_outliers = [&](double yaw) { return ++told % 7 == 0 ? 0.9 * told : turned_about(yaw); };
  EXPECT_NEAR(std::abs(found(0.1, with_outliers).value_or(0.0)), kPi, 1e-9);
}

TEST(HeadingOffset, WantsTurns) { EXPECT_FALSE(found(0.0, turned_about)); }

TEST(HeadingOffset, LooksForNoneWhereHeadingsAreBelievedOrTheYawIsNotKnown) {
  EXPECT_FALSE(found(0.1, turned_about, 0.5));
  EXPECT_FALSE(found(0.1, turned_about, 0.0, 0.1));
}

}  // namespace
}  // namespace multipath_localization::multipath
