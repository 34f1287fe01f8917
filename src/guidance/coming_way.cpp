#include "multipath_localization/guidance/coming_way.hpp"

#include <cmath>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

std::vector<Pose2> coming_way(const WaypointFollower& follower, const WaypointFollowerParameters& p,
                              const Pose2& pose, const MotionCommand& wanted, double length) {
  if (follower.driver() != nullptr && p.law == "path_tracking") {
    return follower.driver()->way_ahead(pose, std::abs(wanted.speed), length);
  }
  const double curvature = std::tan(wanted.steering_angle) / p.wheelbase;
  const double forward = wanted.speed < 0.0 ? -1.0 : 1.0;
  std::vector<Pose2> way = {pose};
  for (double gone = 0.0; gone < length; gone += PathDriver::kWayStep) {
    way.push_back(way.back() * displacement({0.0, PathDriver::kWayStep, forward, forward * curvature}));
  }
  return way;
}

}  // namespace multipath_localization
