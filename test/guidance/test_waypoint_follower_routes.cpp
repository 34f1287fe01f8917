// Routes that are small, doubled, dense or within the turning circle.

#include <gtest/gtest.h>

#include <cmath>

#include "driven.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {
namespace {

class OddRoute : public testing::TestWithParam<const char*> {
 protected:
  WaypointFollowerParameters parameters() const {
    WaypointFollowerParameters p;
    p.law = GetParam();
    return p;
  }
};

/// Drives from the origin, heading east, until finished; how far that is, `most` [m] where it never is.
double way_to_the_end(WaypointFollower& follower, const WaypointFollowerParameters& p, double most) {
  Pose2 pose;
  double way = 0.0;
  while (way < most) {
    const MotionCommand u = follower.command(pose, 0.0, Trust::kGood).command;
    if (follower.finished()) return way;
    pose = driven(pose, u, p.wheelbase, 0.02);
    way += u.speed * 0.02;
  }
  return most;
}

/// Routes no robot can drive round: what it comes to within a circle on the spot.
TEST_P(OddRoute, DrivesASmallRouteOnceAndSaysWhyNotAgain) {
  const std::vector<std::vector<Eigen::Vector2d>> routes = {{{10.0, 0.0}},
                                                            {{-10.0, 0.0}},
                                                            {{-0.5, 0.0}},
                                                            {{0.0, 0.0}},
                                                            {{5.0, 0.0}, {5.36, 0.0}},
                                                            {{5.0, 0.0}, {5.0, 0.0}, {5.0, 0.0}},
                                                            {{3.0, 0.0}, {6.4, 0.0}},
                                                            {{3.0, 0.0}, {4.0, 0.0}, {3.5, 0.8}}};
  for (const auto& route : routes) {
    WaypointFollower follower(parameters(), route);
    EXPECT_LT(way_to_the_end(follower, parameters(), 40.0), 25.0) << route.back().transpose();
    const FollowerOutput output = follower.command({}, 0.0, Trust::kGood);
    EXPECT_EQ(output.command.speed, 0.0);
    EXPECT_EQ(output.status, "finished: loop needs a waypoint farther than 3.5 m from the first");
    EXPECT_EQ(follower.route().rounds(), 1);
    EXPECT_FALSE(follower.can_loop());
  }
}

TEST_P(OddRoute, CountsALapOnceAndOnlyWhenItWasDriven) {
  for (const double distance : {3.6, 5.0, 20.0}) {
    WaypointFollower follower(parameters(), {{0.0, 0.0}, {distance, 0.0}});
    const double most = 200.0;
    EXPECT_EQ(way_to_the_end(follower, parameters(), most), most);
    EXPECT_GE(follower.route().rounds(), 1);
    EXPECT_LE(follower.route().rounds() * 2.0 * (distance - 2.0 * parameters().switch_radius), most);
  }
}

/// However strict the parameters: the waypoint is passed before a second circle round it.
TEST_P(OddRoute, DoesNotCircleRoundAWaypointWithinTheTurningCircle) {
  WaypointFollowerParameters p = parameters();
  p.loop = false;
  p.wheelbase = 2.7;
  p.switch_radius = 0.2;
  p.crossing_width = 0.0;
  const double circle = 2.0 * kPi * p.wheelbase / std::tan(p.max_steering_angle);
  for (double x = -4.0; x <= 8.0; x += 0.5) {
    for (double y = -8.0; y <= 8.0; y += 0.5) {
      WaypointFollower follower(p, {{x, y}});
      EXPECT_LT(way_to_the_end(follower, p, 10.0 * circle), 2.0 * circle) << x << " " << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(WaypointFollower, OddRoute, testing::Values("nishida", "path_tracking"));

/// As a planner on a grid gives it: in steps of 5 cm, to the east or to the north.
TEST(WaypointFollower, DrivesAStaircaseOfCentimetresAsTheLineItStandsFor) {
  std::vector<Eigen::Vector2d> stairs = {{0.0, 0.0}};
  while (stairs.back().x() < 20.0) {
    const bool up = stairs.size() % 2 == 0;
    stairs.push_back(stairs.back() + (up ? Eigen::Vector2d(0.0, 0.05) : Eigen::Vector2d(0.05, 0.0)));
  }
  WaypointFollowerParameters p;
  p.loop = false;
  WaypointFollower follower(p, stairs);
  Pose2 pose{0.0, 0.0, 0.25 * kPi};
  while (true) {
    const MotionCommand u = follower.command(pose, 0.0, Trust::kGood).command;
    if (follower.finished()) break;
    EXPECT_LT(std::abs(u.steering_angle), 0.05);
    pose = driven(pose, u, p.wheelbase, 0.02);
    ASSERT_LT(std::abs(pose.x - pose.y), 0.1);
  }
}

}  // namespace
}  // namespace multipath_localization
