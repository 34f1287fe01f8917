#include <gtest/gtest.h>

#include "multipath_localization/guidance/coming_way.hpp"

namespace multipath_localization {
namespace {

TEST(ComingWay, RunsAlongThePathRoundItsCorners) {
  WaypointFollowerParameters p;
  p.loop = false;
  WaypointFollower follower(p, {{10.0, 0.0}, {10.0, 10.0}});
  follower.command({}, 0.0, Trust::kGood);
  const Pose2 pose{8.0, 0.2, 0.0};
  const FollowerOutput wanted = follower.command(pose, 0.0, Trust::kGood);
  const std::vector<Pose2> way = coming_way(follower, p, pose, wanted.command, 6.0);
  EXPECT_EQ(way.front().x, 8.0);
  EXPECT_NEAR(static_cast<double>(way.size()), 61.0, 1.0);
  for (const Pose2& at : way) {
    const Path& path = follower.progress_on_path()->path();
    EXPECT_LT((path.at(path.nearest(at.position(), 0.0, 20.0)).position - at.position()).norm(), 0.25);
  }
  EXPECT_NEAR(way.back().x, 10.0, 0.1);
  EXPECT_NEAR(way.back().yaw, 0.5 * kPi, 0.1);
}

TEST(ComingWay, EndsWithThePath) {
  WaypointFollowerParameters p;
  p.loop = false;
  WaypointFollower follower(p, {{10.0, 0.0}});
  follower.command({}, 0.0, Trust::kGood);
  const Pose2 pose{8.0, 0.0, 0.0};
  const FollowerOutput wanted = follower.command(pose, 0.0, Trust::kGood);
  EXPECT_NEAR(coming_way(follower, p, pose, wanted.command, 6.0).back().x, 10.0, 0.11);
}

TEST(ComingWay, IsTheArcOfTheCommandWhereNoPathIsFollowed) {
  const WaypointFollowerParameters p;
  const WaypointFollower follower(p, {});
  const double angle = std::atan(0.5 / 2.0);  // on a circle of 2 m
  const Pose2 ahead = coming_way(follower, p, {}, {1.0, angle}, kPi).back();
  EXPECT_NEAR(ahead.x, 2.0, 0.1);
  EXPECT_NEAR(ahead.y, 2.0, 0.1);
  const Pose2 back = coming_way(follower, p, {}, {-1.0, angle}, kPi).back();
  EXPECT_NEAR(back.x, -2.0, 0.1);
  EXPECT_NEAR(back.y, 2.0, 0.1);
}

}  // namespace
}  // namespace multipath_localization
