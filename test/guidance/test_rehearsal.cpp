#include <gtest/gtest.h>

#include <utility>

#include "guidance/rehearsal.hpp"

namespace multipath_localization {
namespace {

double miss(const std::vector<Eigen::Vector2d>& route, const Pose2& pose, const MotionCommand& last = {}) {
  const WaypointFollowerParameters p;
  const PassingRule rule{p.switch_radius, p.crossing_width, true, p.tightest_curvature(), false};
  PathProgress progress(route, 1, rule, pose.position());
  return rehearsed_miss(PathDriver(p, std::move(progress), PathPlan{0.0}), pose, last, p);
}

TEST(Rehearsal, ComesToAGoalAhead) {
  EXPECT_LT(miss({{0.0, 0.0}, {8.0, 0.0}}, {}), 0.05);
  EXPECT_LT(miss({{0.0, 0.0}, {8.0, 0.0}}, {0.0, 0.3, 0.2}, {1.5, -0.3}), 0.05);
}

TEST(Rehearsal, TellsHowFarAGoalWithinTheTurningCircleIsMissed) {
  const double beside = miss({{0.0, 0.0}, {0.0, 0.5}}, {});
  EXPECT_GT(beside, 0.3);
  EXPECT_LT(beside, 1.0);
}

}  // namespace
}  // namespace multipath_localization
