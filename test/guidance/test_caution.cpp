#include <gtest/gtest.h>

#include <limits>

#include "multipath_localization/guidance/caution.hpp"

namespace multipath_localization {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Caution caution() {
  WaypointFollowerParameters p;
  p.slow_sigma = 1.0;
  p.stop_sigma = 3.0;
  p.aligning_distance = 5.0;
  p.aligning_speed_ratio = 0.5;
  return Caution(p);
}

void expect(const KnownPose& known, double ratio, const std::string& status, bool urgent) {
  const Pace pace = caution().pace(known);
  EXPECT_EQ(pace.ratio, ratio);
  EXPECT_EQ(pace.status, status);
  EXPECT_EQ(pace.urgent, urgent);
}

TEST(Caution, DrivesTheSlowerTheLessIsKnown) {
  expect({{}, 0.0, Trust::kGood, 1.0}, 1.0, "driving", false);
  expect({{}, 0.0, Trust::kGood, 2.0}, 0.5, "slow: position uncertain", false);
  expect({{}, 0.0, Trust::kMultipath, 2.5}, 0.25, "slow: fixes are biased", false);
  expect({{}, 0.0, Trust::kDeadReckoning, 3.0}, 0.0, "stopped: no usable fix", false);
  expect({{}, 0.0, Trust::kAligning, 9.0}, 0.5, "slow: heading not yet confirmed", false);
}

TEST(Caution, StopsUrgentlyByWhatIsNoPose) {
  expect({{}, 0.8, Trust::kGood, 0.0}, 0.0, "stopped: pose is 0.8 s old", true);
  expect({{}, kNaN, Trust::kGood, 0.0}, 0.0, "stopped: no pose yet", true);
  expect({{0.0, kNaN, 0.0}, 0.0, Trust::kGood, 0.0}, 0.0, "stopped: pose not finite", true);
  expect({{}, 0.0, Trust::kLost, 0.0}, 0.0, "stopped: localisation lost", true);
}

TEST(Caution, AHeadingShowsByDrivingAndHasToAnewWhenThePoseWasLost) {
  Caution robot = caution();
  const auto at = [](double x) { return KnownPose{{x, 0.0, 0.0}, 0.0, Trust::kAligning, 0.0}; };
  EXPECT_FALSE(robot.heading_shown(at(0.0)));
  EXPECT_FALSE(robot.heading_shown(at(4.9)));
  EXPECT_TRUE(robot.heading_shown(at(5.0)));
  EXPECT_FALSE(robot.heed(Trust::kGood));
  EXPECT_TRUE(robot.heading_shown(at(5.0)));
  EXPECT_TRUE(robot.heed(Trust::kLost));
  EXPECT_FALSE(robot.heading_shown(at(5.0)));
  EXPECT_TRUE(robot.heading_shown({{5.0, 0.0, 0.0}, 0.0, Trust::kGood, 0.0}));
}

}  // namespace
}  // namespace multipath_localization
