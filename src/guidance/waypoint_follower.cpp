#include "multipath_localization/guidance/waypoint_follower.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "guidance/route_continuation.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kJustNow = 3.0;  // a planner takes no longer for a route [s]
constexpr double kBeside = 0.1;   // of the last waypoint: worth a word [m]
constexpr double kFacing = 0.05;  // the final heading: the rest is braked away [rad]

double direction_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

/// The index of the waypoint that the part of the route leads to, within `reach` along it from its beginning
/// [m], that is nearest to the place.
std::size_t joined_at(const std::vector<Eigen::Vector2d>& route, const Eigen::Vector2d& place, double reach) {
  std::size_t joined = 0;
  double nearest = (place - route.front()).norm();
  double driven = 0.0;
  for (std::size_t i = 1; i < route.size() && driven <= reach; ++i) {
    const Eigen::Vector2d way = route[i] - route[i - 1];
    if (way.isZero()) continue;
    const double share = std::clamp((place - route[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double away = (place - route[i - 1] - share * way).norm();
    if (away <= nearest) {
      nearest = away;
      joined = i;
    }
    driven += way.norm();
  }
  return joined;
}

/// Of a route driven round, at least [m].
double loop_extent(const WaypointFollowerParameters& p) {
  return 2.0 * (1.0 / p.tightest_curvature() + p.switch_radius);
}

/// `missed_by`: how far from the last waypoint [m].
FollowerOutput finished_by(const WaypointFollowerParameters& p, const Route& route, double missed_by) {
  if (missed_by > kBeside && !p.as_nishida()) {
    return {{}, "finished " + fixed_text(missed_by, 1) + " m from the last waypoint: too near to turn to"};
  }
  if (!p.loop || route.tasks().once) return {{}, "finished"};
  return {
      {},
      "finished: loop needs a waypoint farther than " + fixed_text(loop_extent(p), 1) + " m from the first"};
}

/// Eqs. (36) and (38) of [NIS]. Departs: the error is of the heading, where Eq. (36) prints the steering
/// angle.
double steer_to(const Eigen::Vector2d& target, const Pose2& pose, double k_phi) {
  const double bearing = direction_of(target - pose.position());  // Eq. (38) of [NIS]
  return k_phi * angle_difference(bearing, pose.yaw);             // Eq. (36) of [NIS]
}

bool turns_to_final_heading(const Route& route, const WaypointFollowerParameters& p) {
  return route.tasks().final_heading && p.limits.differential();
}

/// The speeds told for the ways to the waypoints of a path, of which the next of the route is the `first`.
std::vector<SpeedZone> zones_of(const Route& route, const Path& path, std::size_t first, std::size_t ahead) {
  std::vector<SpeedZone> zones;
  if (route.tasks().at.empty()) return zones;
  for (std::size_t i = 0; i < ahead; ++i) zones.push_back({path.station(first + i), route.task(i).speed});
  return zones;
}

/// Of the ways to the waypoints of a path, likewise; none where the route tells none.
std::vector<double> curvatures_of(const Route& route, std::size_t first, std::size_t ahead) {
  std::vector<double> curvatures;
  if (!route.has_arcs()) return curvatures;
  curvatures.assign(first, 0.0);
  for (std::size_t i = 0; i < ahead; ++i) curvatures.push_back(route.task(i).curvature.value_or(0.0));
  return curvatures;
}

}  // namespace

WaypointFollower::WaypointFollower(const WaypointFollowerParameters& parameters,
                                   std::vector<Eigen::Vector2d> waypoints, RouteTasks tasks)
    : parameters_(parameters),
      route_(std::move(waypoints), std::move(tasks)),
      caution_(parameters),
      trail_(kJustNow * parameters.cruise_speed) {}

void WaypointFollower::move_waypoints(std::vector<Eigen::Vector2d> waypoints) {
  route_.move(std::move(waypoints));
  driver_.reset();
  caution_.forget_positions();
  trail_.clear();
}

bool WaypointFollower::continue_along(const std::vector<Eigen::Vector2d>& waypoints,
                                      const RouteTasks& tasks) {
  Route next(waypoints, tasks);
  const std::size_t passed = finished() ? route_.waypoints().size() : target();
  const auto target = target_in_continuation(route_.waypoints(), passed, waypoints);
  if (!target) return false;
  next.set_passed(same_route(route_.waypoints(), waypoints) ? route_.passed() : *target);
  route_ = std::move(next);
  lay_path_anew();
  return true;
}

void WaypointFollower::take_route(const std::vector<Eigen::Vector2d>& waypoints, const RouteTasks& tasks) {
  route_ = Route(waypoints, tasks);
  driver_.reset();
  stopover_.end();
  turning_ = false;
  if (waypoints.empty() || trail_.empty() || !trail_.comes_by(waypoints.front())) return;
  const std::size_t joined = joined_at(waypoints, trail_.latest(), kJustNow * parameters_.cruise_speed);
  route_.set_passed(joined);
  if (joined > 0) lay_path({waypoints.front(), waypoints[joined]}, trail_.latest());
}

void WaypointFollower::set_loop(bool loop) {
  if (loop == parameters_.loop) return;
  parameters_.loop = loop;
  lay_path_anew();
}

bool WaypointFollower::finished() const { return route_.passed_all() && !loops(); }

bool WaypointFollower::can_loop() const { return route_.extent() > loop_extent(parameters_); }

void WaypointFollower::skip() {
  if (route_.empty() || finished() || go_on()) return;
  turning_ = false;
  route_.pass();
  driver_.reset();
}

bool WaypointFollower::go_on() { return stopover_.end(); }

void WaypointFollower::heed(Trust state) {
  if (!caution_.heed(state)) return;
  driver_.reset();
  trail_.clear();
}

FollowerOutput WaypointFollower::command(const Pose2& pose, double pose_age, Trust state, double sigma,
                                         double now) {
  heed(state);
  const auto end = [&] { return finished_by(parameters_, route_, driver_ ? driver_->missed_by() : 0.0); };
  if (finished()) return end();
  if (route_.empty()) return {{}, "stopped: no waypoints"};
  const KnownPose known{pose, pose_age, state, sigma};
  const Pace pace = caution_.pace(known);
  if (pace.ratio == 0.0) return {{}, pace.status, pace.urgent};
  if (stopover_.lasts(now)) return {{}, stopover_.status()};
  if (!caution_.heading_shown(known)) return {{pace.ratio * parameters_.cruise_speed, 0.0}, pace.status};
  trail_.add(pose.position());
  if (!driver_) lay_path({pose.position()}, pose.position());
  if (!turning_) pass_waypoints(pose);
  if (turning_) return turn(pose);
  if (stopover_.lasts(now)) return {{}, stopover_.status()};
  return finished() ? end() : steer(pose, pace);
}

void WaypointFollower::lay_path(std::vector<Eigen::Vector2d> behind, const Eigen::Vector2d& position) {
  const std::size_t first = behind.size();
  const std::size_t count = route_.waypoints().size();
  // Two rounds: one to drive, after which the path is laid anew, and one to look ahead along.
  const std::size_t most = loops() ? 2 * count : count - target();
  bool stops = false;
  std::size_t ahead = 0;
  while (ahead < most && !stops) {
    behind.push_back(route_.waypoint(ahead));
    stops = route_.stops(ahead++) || (!loops() && ahead == most);
  }
  const bool stop_at_end = stops && !parameters_.as_nishida();
  const PassingRule rule{parameters_.switch_radius, parameters_.crossing_width, stop_at_end,
                         parameters_.tightest_curvature(), parameters_.limits.differential()};
  PathProgress progress(std::move(behind), first, rule, position, curvatures_of(route_, first, ahead));
  const PathPlan plan{stop_at_end ? 0.0 : parameters_.cruise_speed, route_.task().reverse,
                      zones_of(route_, progress.path(), first, ahead)};
  driver_.emplace(parameters_, std::move(progress), plan);
}

void WaypointFollower::lay_path_anew() {
  if (!driver_) return;
  if (finished() || route_.empty()) {
    driver_.reset();
  } else {
    lay_path(driver()->progress().behind(), driver()->progress().position());
  }
}

void WaypointFollower::pass_waypoints(const Pose2& pose) {
  const std::size_t count = route_.waypoints().size();
  for (std::size_t i = 0; i < count && !finished() && driver_->passes(pose); ++i) {
    const bool last = !loops() && target() + 1 == count;
    turning_ = last && turns_to_final_heading(route_, parameters_);
    if (turning_) return;
    const bool stops = route_.stops(0) && !last;
    stopover_.begin(route_.task().wait);
    route_.pass();
    driver_->pass_next();
    if (stops) return lay_path({pose.position()}, pose.position());
    if (loops() && driver()->progress().left() <= count) lay_path_anew();
  }
}

FollowerOutput WaypointFollower::turn(const Pose2& pose) {
  const double left = angle_difference(*route_.tasks().final_heading, pose.yaw);
  if (std::abs(left) > kFacing) {
    return {{}, "turning to the heading at the goal", false, spin_towards(left, parameters_.limits)};
  }
  skip();
  return finished_by(parameters_, route_, 0.0);
}

FollowerOutput WaypointFollower::steer(const Pose2& pose, const Pace& pace) {
  const double speed = pace.ratio * parameters_.cruise_speed;
  if (parameters_.as_nishida()) {  // at one speed: Eq. (37) of [NIS]
    const double most = parameters_.largest_steering_angle();
    const double angle = steer_to(route_.waypoint(0), pose, parameters_.k_phi);
    return {{speed, std::clamp(angle, -most, most)}, pace.status};
  }
  const double deviation = driver()->progress().deviation(pose.position());
  if (parameters_.max_deviation > 0.0 && deviation > parameters_.max_deviation) {
    return {{}, "stopped: " + fixed_text(deviation, 1) + " m off the path", true};
  }
  const PathCommand along = driver_->command(pose, speed);
  return {along.command, pace.status, false, along.spin};
}

}  // namespace multipath_localization
