#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "multipath_localization/guidance/waypoint_mission.hpp"

namespace multipath_localization {

/// Waypoints of these tests, on the x axis [m].
inline const std::vector<Eigen::Vector2d> kLine = {{10.0, 0.0}, {20.0, 0.0}, {30.0, 0.0}};

inline WaypointMission mission(bool loop = true, bool autostart = true) {
  WaypointFollowerParameters parameters;
  parameters.loop = loop;
  return {parameters, kLine, autostart};
}

/// What is commanded at x = `x` on the way along the line.
inline FollowerOutput at(WaypointMission& mission, double x) {
  return mission.command({x, 0.0, 0.0}, 0.0, Trust::kGood);
}

inline void expect_standing(WaypointMission& mission, const std::string& status) {
  const FollowerOutput output = at(mission, 0.0);
  EXPECT_EQ(output.command.speed, 0.0);
  EXPECT_EQ(output.command.steering_angle, 0.0);
  EXPECT_EQ(output.status, status);
}

inline void drive_to_the_end(WaypointMission& mission) {
  for (const double x : {0.0, 10.0, 20.0, 30.0}) at(mission, x);
}

}  // namespace multipath_localization
