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

double direction_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

void require_finite(const std::vector<Eigen::Vector2d>& waypoints) {
  for (const Eigen::Vector2d& waypoint : waypoints) {
    if (!waypoint.allFinite()) throw std::invalid_argument("a waypoint is not finite");
  }
}

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

double extent_of(const std::vector<Eigen::Vector2d>& waypoints) {
  double extent = 0.0;
  for (const Eigen::Vector2d& waypoint : waypoints) {
    extent = std::max(extent, (waypoint - waypoints.front()).norm());
  }
  return extent;
}

/// Of a route driven round, at least [m].
double loop_extent(const WaypointFollowerParameters& p) {
  return 2.0 * (1.0 / p.tightest_curvature() + p.switch_radius);
}

}  // namespace

WaypointFollower::WaypointFollower(const WaypointFollowerParameters& parameters,
                                   std::vector<Eigen::Vector2d> waypoints)
    : parameters_(parameters),
      waypoints_(std::move(waypoints)),
      extent_(extent_of(waypoints_)),
      caution_(parameters),
      trail_(kJustNow * parameters.cruise_speed) {
  require_finite(waypoints_);
}

void WaypointFollower::move_waypoints(std::vector<Eigen::Vector2d> waypoints) {
  require_finite(waypoints);
  if (waypoints.size() != waypoints_.size()) throw std::invalid_argument("not as many waypoints as before");
  waypoints_ = std::move(waypoints);
  extent_ = extent_of(waypoints_);
  driver_.reset();
  caution_.forget_positions();
  trail_.clear();
}

bool WaypointFollower::continue_along(const std::vector<Eigen::Vector2d>& waypoints) {
  require_finite(waypoints);
  const auto target =
      target_in_continuation(waypoints_, finished() ? waypoints_.size() : this->target(), waypoints);
  if (!target) return false;
  if (!same_route(waypoints_, waypoints)) passed_ = *target;
  waypoints_ = waypoints;
  extent_ = extent_of(waypoints_);
  lay_path_anew();
  return true;
}

void WaypointFollower::take_route(const std::vector<Eigen::Vector2d>& waypoints) {
  require_finite(waypoints);
  waypoints_ = waypoints;
  extent_ = extent_of(waypoints_);
  passed_ = 0;
  driver_.reset();
  if (waypoints_.empty() || trail_.empty() || !trail_.comes_by(waypoints_.front())) return;
  passed_ = joined_at(waypoints_, trail_.latest(), kJustNow * parameters_.cruise_speed);
  const auto target = waypoints_.begin() + static_cast<std::ptrdiff_t>(passed_);
  if (passed_ > 0) lay_path({waypoints_.begin(), target}, trail_.latest());
}

void WaypointFollower::set_loop(bool loop) {
  if (loop == parameters_.loop) return;
  parameters_.loop = loop;
  lay_path_anew();
}

std::size_t WaypointFollower::target() const { return waypoints_.empty() ? 0 : passed_ % waypoints_.size(); }

int WaypointFollower::laps() const {
  return waypoints_.empty() ? 0 : static_cast<int>(passed_ / waypoints_.size());
}

double WaypointFollower::progress() const {
  return waypoints_.empty() ? 0.0 : static_cast<double>(passed_) / static_cast<double>(waypoints_.size());
}

bool WaypointFollower::finished() const { return passed_ > 0 && target() == 0 && !loops(); }

bool WaypointFollower::can_loop() const { return extent_ > loop_extent(parameters_); }

void WaypointFollower::skip() {
  if (waypoints_.empty() || finished()) return;
  ++passed_;
  driver_.reset();
}

void WaypointFollower::heed(Trust state) {
  if (!caution_.heed(state)) return;
  driver_.reset();
  trail_.clear();
}

FollowerOutput WaypointFollower::command(const Pose2& pose, double pose_age, Trust state, double sigma) {
  heed(state);
  if (finished()) return end();
  if (waypoints_.empty()) return {{}, "stopped: no waypoints"};
  const KnownPose known{pose, pose_age, state, sigma};
  const Pace pace = caution_.pace(known);
  if (pace.ratio == 0.0) return {{}, pace.status, pace.urgent};
  if (!caution_.heading_shown(known)) return {{pace.ratio * parameters_.cruise_speed, 0.0}, pace.status};
  trail_.add(pose.position());
  if (!driver_) lay_path({pose.position()}, pose.position());
  pass_waypoints(pose);
  return finished() ? end() : steer(pose, pace);
}

FollowerOutput WaypointFollower::end() const {
  if (!parameters_.loop) return {{}, "finished"};
  return {{},
          "finished: loop needs a waypoint farther than " + fixed_text(loop_extent(parameters_), 1) +
              " m from the first"};
}

void WaypointFollower::lay_path(std::vector<Eigen::Vector2d> behind, const Eigen::Vector2d& position) {
  const std::size_t first = behind.size();
  // Two rounds: one to drive, after which the path is laid anew, and one to look ahead along.
  const std::size_t ahead = loops() ? 2 * waypoints_.size() : waypoints_.size() - target();
  for (std::size_t i = 0; i < ahead; ++i) {
    behind.push_back(waypoints_[(passed_ + i) % waypoints_.size()]);
  }
  const bool stop_at_end = !loops() && parameters_.law != "nishida";
  const PassingRule rule{parameters_.switch_radius, parameters_.crossing_width, stop_at_end,
                         parameters_.tightest_curvature(), parameters_.limits.differential()};
  driver_.emplace(parameters_, PathProgress(std::move(behind), first, rule, position),
                  stop_at_end ? 0.0 : parameters_.cruise_speed);
}

void WaypointFollower::lay_path_anew() {
  if (!driver_) return;
  if (finished() || waypoints_.empty()) {
    driver_.reset();
  } else {
    lay_path(driver_->progress().behind(), driver_->progress().position());
  }
}

void WaypointFollower::pass_waypoints(const Pose2& pose) {
  for (std::size_t i = 0; i < waypoints_.size() && !finished() && driver_->progress().passes(pose); ++i) {
    ++passed_;
    driver_->progress().pass_next();
    if (loops() && driver_->progress().left() <= waypoints_.size()) lay_path_anew();
  }
}

FollowerOutput WaypointFollower::steer(const Pose2& pose, const Pace& pace) {
  const double speed = pace.ratio * parameters_.cruise_speed;
  if (parameters_.law == "nishida") {  // at one speed: Eq. (37) of [NIS]
    const double most = parameters_.largest_steering_angle();
    return {{speed, std::clamp(steer_to_target(pose), -most, most)}, pace.status};
  }
  const double deviation = driver_->progress().deviation(pose.position());
  if (parameters_.max_deviation > 0.0 && deviation > parameters_.max_deviation) {
    return {{}, "stopped: " + fixed_text(deviation, 1) + " m off the path", true};
  }
  const PathCommand along = driver_->command(pose, speed);
  return {along.command, pace.status, false, along.spin};
}

double WaypointFollower::steer_to_target(const Pose2& pose) const {
  const double bearing = direction_of(waypoints_[target()] - pose.position());  // Eq. (38) of [NIS]
  return parameters_.k_phi * angle_difference(bearing, pose.yaw);               // Eq. (36) of [NIS]
}

}  // namespace multipath_localization
