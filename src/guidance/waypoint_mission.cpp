#include "multipath_localization/guidance/waypoint_mission.hpp"

#include "guidance/route_continuation.hpp"

namespace multipath_localization {

WaypointMission::WaypointMission(const WaypointFollowerParameters& parameters,
                                 const std::vector<Eigen::Vector2d>& waypoints, bool autostart)
    : parameters_(parameters),
      follower_(parameters, waypoints),
      order_(autostart ? Order::kDrive : Order::kAwaited) {}

Answer WaypointMission::start() {
  if (follower_.waypoints().empty()) return no_waypoints();
  if (order_ == Order::kPause) return {false, "paused: resume goes on, stop gives up"};
  if (order_ == Order::kDrive && !follower_.finished()) return {false, "driving already"};
  set_waypoints(follower_.waypoints(), follower_.route().tasks());
  order_ = Order::kDrive;
  return {true, "driving from waypoint 1 of " + std::to_string(follower_.waypoints().size())};
}

Answer WaypointMission::pause() {
  if (order_ != Order::kDrive) return {false, "not driving: " + reason_to_stand()};
  if (follower_.finished()) return {false, "not driving: finished"};
  order_ = Order::kPause;
  held_for_.clear();
  return {true, "paused"};
}

void WaypointMission::hold(const std::string& reason) {
  if (order_ != Order::kDrive) return;
  order_ = Order::kPause;
  held_for_ = reason;
}

Answer WaypointMission::resume() {
  if (order_ == Order::kDrive && follower_.go_on()) return {true, "driving on"};
  if (order_ == Order::kDrive) return {false, "not paused"};
  if (order_ != Order::kPause) return {false, "not paused but " + reason_to_stand()};
  order_ = Order::kDrive;
  return {true, "driving on"};
}

Answer WaypointMission::skip() {
  if (follower_.waypoints().empty()) return no_waypoints();
  if (follower_.finished()) return {false, "finished: no waypoint is left"};
  if (order_ != Order::kDrive && order_ != Order::kPause) return {false, reason_to_stand()};
  follower_.skip();
  if (follower_.finished()) return {true, "the last waypoint is skipped: finished"};
  return {true, "next is waypoint " + std::to_string(follower_.target() + 1) + " of " +
                    std::to_string(follower_.waypoints().size())};
}

Answer WaypointMission::stop() {
  order_ = Order::kStop;
  return {true, "stopped; start begins at the first waypoint"};
}

Answer WaypointMission::set_loop(bool repeat) {
  if (finished()) order_ = Order::kDone;
  parameters_.loop = repeat;
  follower_.set_loop(repeat);
  if (!repeat) return {true, "stops at the last waypoint"};
  if (follower_.waypoints().empty() || follower_.can_loop()) {
    return {true, "goes on to the first waypoint after the last"};
  }
  return {true, "goes on to the first waypoint after the last, but not on this route, which is too small"};
}

void WaypointMission::set_waypoints(const std::vector<Eigen::Vector2d>& waypoints, const RouteTasks& tasks) {
  follower_ = WaypointFollower(parameters_, waypoints, tasks);
  without_waypoints_.clear();
  if (order_ == Order::kDone) order_ = Order::kDrive;
}

Delivery WaypointMission::offer_waypoints(const std::vector<Eigen::Vector2d>& waypoints, std::uint64_t stamp,
                                          const RouteTasks& tasks) {
  const bool again = last_delivery_ && same_route(last_delivery_->waypoints, waypoints);
  if (again && stamp <= last_delivery_->stamp) return Delivery::kKnown;
  const bool continued = order_ != Order::kDone && follower_.continue_along(waypoints, tasks);
  if (!continued && order_ == Order::kDrive && !follower_.finished()) {
    follower_.take_route(waypoints, tasks);
    without_waypoints_.clear();
  } else if (!continued) {
    set_waypoints(waypoints, tasks);
  }
  last_delivery_ = {waypoints, stamp};
  return continued ? Delivery::kContinued : Delivery::kNew;
}

void WaypointMission::stand_without_waypoints(const std::string& reason) {
  if (finished()) order_ = Order::kAwaited;
  follower_ = WaypointFollower(parameters_, {});
  without_waypoints_ = reason;
}

FollowerOutput WaypointMission::command(const Pose2& pose, double pose_age, Trust state, double sigma,
                                        double now) {
  follower_.heed(state);
  if (order_ != Order::kDrive) return {{}, reason_to_stand(), order_ == Order::kPause && !held_for_.empty()};
  if (!without_waypoints_.empty()) return {{}, "stopped: " + without_waypoints_};
  return follower_.command(pose, pose_age, state, sigma, now);
}

bool WaypointMission::finished() const {
  return order_ == Order::kDone || (order_ == Order::kDrive && follower_.finished());
}

Answer WaypointMission::no_waypoints() const {
  return {false, without_waypoints_.empty() ? "no waypoints" : without_waypoints_};
}

std::string WaypointMission::reason_to_stand() const {
  switch (order_) {
    case Order::kAwaited: return "stopped: waiting for start";
    case Order::kPause:
      return "paused: " + (held_for_.empty() ? "" : held_for_ + ", ") + "waiting for resume";
    case Order::kStop: return "stopped: by order, waiting for start";
    case Order::kDone: return "finished";
    default: return "";
  }
}

}  // namespace multipath_localization
