#include "multipath_localization/guidance/waypoint_follower.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "guidance/route_continuation.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kJustNow = 3.0;    // a planner takes no longer for a route [s]
constexpr double kTrailStep = 0.1;  // [m]
constexpr double kJustThere = 0.3;  // of a place where the robot has just been [m]

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

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

std::string old_pose(double age) {
  if (!std::isfinite(age)) return "no pose yet";
  return "pose is " + fixed_text(std::abs(age), 1) + (age > 0.0 ? " s old" : " s ahead");
}

double extent_of(const std::vector<Eigen::Vector2d>& waypoints) {
  double extent = 0.0;
  for (const Eigen::Vector2d& waypoint : waypoints) {
    extent = std::max(extent, (waypoint - waypoints.front()).norm());
  }
  return extent;
}

}  // namespace

void WaypointFollowerParameters::fields(ParameterVisitor& field) {
  field("law", law, {"path_tracking", "nishida"},
        "path_tracking: pure pursuit of the line between waypoints; nishida: Eqs. (36)-(38) of [NIS]");
  field("cruise_speed", cruise_speed, {0.0, 100.0}, "m/s", "where the localisation is good");
  field("wheelbase", wheelbase, {0.01, 100.0}, "m", "front to rear axle");
  field("max_steering_angle", max_steering_angle, {0.0, 1.5}, "rad", "to either side");
  field("k_phi", k_phi, {0.0, 100.0}, "1", "nishida: gain from heading error to steering angle");
  field("lookahead", lookahead, {0.01, 1e3}, "m", "path_tracking: aims this far ahead on the line");
  field("switch_radius", switch_radius, {0.01, 1e3}, "m", "a waypoint this near is passed");
  field("crossing_width", crossing_width, {0.0, 1e3}, "m",
        "so is one whose line, perpendicular to the way there, is crossed this far aside at most, or within "
        "switch_radius");
  field(
      "loop", loop,
      "after the last waypoint go on to the first, else stop; stop too where none is farther from the first "
      "than 2 (turning radius + switch_radius)");
  field("max_pose_age", max_pose_age, {0.0, 60.0}, "s",
        "a pose older, or as far ahead of now, stops the robot");
  field("aligning_distance", aligning_distance, {0.0, 1e3}, "m",
        "in ALIGNING at the start, and after NOT_READY or LOST, go straight this far, for the heading to "
        "show, unless it is confirmed before");
  field("aligning_speed_ratio", aligning_speed_ratio, {0.0, 1.0}, "1", "of the cruise speed in ALIGNING");
  field("multipath_speed_ratio", multipath_speed_ratio, {0.0, 1.0}, "1", "of the cruise speed in MULTIPATH");
  field("dead_reckoning_speed_ratio", dead_reckoning_speed_ratio, {0.0, 1.0}, "1",
        "of the cruise speed in DEAD_RECKONING; 0 holds there as in NOT_READY and LOST");
}

WaypointFollower::WaypointFollower(const WaypointFollowerParameters& parameters,
                                   std::vector<Eigen::Vector2d> waypoints)
    : parameters_(parameters), waypoints_(std::move(waypoints)), extent_(extent_of(waypoints_)) {
  require_finite(waypoints_);
}

void WaypointFollower::move_waypoints(std::vector<Eigen::Vector2d> waypoints) {
  require_finite(waypoints);
  if (waypoints.size() != waypoints_.size()) throw std::invalid_argument("not as many waypoints as before");
  waypoints_ = std::move(waypoints);
  extent_ = extent_of(waypoints_);
  segment_start_.reset();
  first_position_.reset();
  trail_.clear();
}

bool WaypointFollower::continue_along(const std::vector<Eigen::Vector2d>& waypoints) {
  require_finite(waypoints);
  const bool at_end = finished();
  const auto target =
      target_in_continuation(waypoints_, at_end ? waypoints_.size() : this->target(), waypoints);
  if (!target) return false;
  if (!same_route(waypoints_, waypoints)) passed_ = *target;
  waypoints_ = waypoints;
  extent_ = extent_of(waypoints_);
  if (at_end) begin_segment();
  return true;
}

void WaypointFollower::take_route(const std::vector<Eigen::Vector2d>& waypoints) {
  require_finite(waypoints);
  waypoints_ = waypoints;
  extent_ = extent_of(waypoints_);
  passed_ = 0;
  segment_start_.reset();
  if (waypoints_.empty() || trail_.empty() || !has_just_been_at(waypoints_.front())) return;
  passed_ = joined_at(waypoints_, trail_.back(), kJustNow * parameters_.cruise_speed);
  begin_segment();
}

bool WaypointFollower::has_just_been_at(const Eigen::Vector2d& place) const {
  return std::any_of(trail_.begin(), trail_.end(),
                     [&](const Eigen::Vector2d& at) { return (at - place).norm() <= kJustThere; });
}

void WaypointFollower::remember(const Eigen::Vector2d& position) {
  if (!trail_.empty() && (position - trail_.back()).norm() < kTrailStep) return;
  trail_.push_back(position);
  while (static_cast<double>(trail_.size()) * kTrailStep > kJustNow * parameters_.cruise_speed)
    trail_.pop_front();
}

std::size_t WaypointFollower::target() const { return waypoints_.empty() ? 0 : passed_ % waypoints_.size(); }

int WaypointFollower::laps() const {
  return waypoints_.empty() ? 0 : static_cast<int>(passed_ / waypoints_.size());
}

double WaypointFollower::progress() const {
  return waypoints_.empty() ? 0.0 : static_cast<double>(passed_) / static_cast<double>(waypoints_.size());
}

bool WaypointFollower::finished() const {
  return passed_ > 0 && target() == 0 && !(parameters_.loop && can_loop());
}

bool WaypointFollower::can_loop() const { return extent_ > loop_extent(); }

double WaypointFollower::loop_extent() const {
  const double turning_radius = parameters_.wheelbase / std::tan(parameters_.max_steering_angle);
  return 2.0 * (turning_radius + parameters_.switch_radius);
}

void WaypointFollower::skip() {
  if (waypoints_.empty() || finished()) return;
  ++passed_;
  segment_start_.reset();
}

void WaypointFollower::heed(Trust state) {
  if (state != Trust::kNotReady && state != Trust::kLost) return;
  underway_ = false;
  first_position_.reset();
  segment_start_.reset();
  trail_.clear();
}

FollowerOutput WaypointFollower::command(const Pose2& pose, double pose_age, Trust state) {
  heed(state);
  if (finished()) return end();
  const std::string reason = reason_to_stop(pose, pose_age, state);
  if (!reason.empty()) return {{}, "stopped: " + reason};

  const Pace pace = pace_in(state);
  const double speed = pace.ratio * parameters_.cruise_speed;
  underway_ = underway_ || heading_shown(pose.position(), state);
  if (!underway_) return {{speed, 0.0}, pace.status};
  remember(pose.position());
  pass_waypoints(pose.position());
  if (finished()) return end();
  const double angle = parameters_.law == "nishida" ? steer_to_target(pose) : steer_along_path(pose);
  return {{speed, std::clamp(angle, -parameters_.max_steering_angle, parameters_.max_steering_angle)},
          pace.status};
}

FollowerOutput WaypointFollower::end() const {
  if (!parameters_.loop) return {{}, "finished"};
  return {
      {},
      "finished: loop needs a waypoint farther than " + fixed_text(loop_extent(), 1) + " m from the first"};
}

std::string WaypointFollower::reason_to_stop(const Pose2& pose, double pose_age, Trust state) const {
  if (waypoints_.empty()) return "no waypoints";
  if (!(std::abs(pose_age) <= parameters_.max_pose_age)) return old_pose(pose_age);
  if (!pose.finite()) return "pose not finite";
  if (state == Trust::kNotReady) return "localisation not ready";
  if (state == Trust::kLost) return "localisation lost";
  if (pace_in(state).ratio == 0.0) return pace_in(state).reason;
  return "";
}

WaypointFollower::Pace WaypointFollower::pace_in(Trust state) const {
  const auto slow = [](double ratio, const std::string& reason) {
    return Pace{ratio, reason, ratio < 1.0 ? "slow: " + reason : "driving"};
  };
  switch (state) {
    case Trust::kAligning: return slow(parameters_.aligning_speed_ratio, "heading not yet confirmed");
    case Trust::kMultipath: return slow(parameters_.multipath_speed_ratio, "fixes are biased");
    case Trust::kDeadReckoning: return slow(parameters_.dead_reckoning_speed_ratio, "no usable fix");
    default: return {1.0, "", "driving"};
  }
}

bool WaypointFollower::heading_shown(const Eigen::Vector2d& position, Trust state) {
  if (!first_position_) first_position_ = position;
  const bool far_enough = (position - *first_position_).norm() >= parameters_.aligning_distance;
  return state != Trust::kAligning || far_enough;
}

void WaypointFollower::pass_waypoints(const Eigen::Vector2d& position) {
  if (!segment_start_) segment_start_ = position;
  for (std::size_t i = 0; i < waypoints_.size() && !finished() && passed_target(position); ++i) {
    ++passed_;
    begin_segment();
  }
}

void WaypointFollower::begin_segment() {
  const std::size_t count = waypoints_.size();
  for (std::size_t back = 1; back < count && back <= passed_; ++back) {
    const Eigen::Vector2d& start = waypoints_[(passed_ - back) % count];
    if ((start - waypoints_[target()]).norm() < parameters_.switch_radius) continue;
    segment_start_ = start;
    return;
  }
}

bool WaypointFollower::passed_target(const Eigen::Vector2d& position) const {
  const Eigen::Vector2d beyond = position - waypoints_[target()];
  if (beyond.norm() <= parameters_.switch_radius) return true;
  const Eigen::Vector2d way = waypoints_[target()] - *segment_start_;
  if (way.isZero()) return false;
  const double width = std::max(parameters_.crossing_width, parameters_.switch_radius);
  return beyond.dot(way) >= 0.0 && std::abs(cross(way.normalized(), beyond)) <= width;
}

double WaypointFollower::steer_to_target(const Pose2& pose) const {
  const double bearing = direction_of(waypoints_[target()] - pose.position());  // Eq. (38) of [NIS]
  return parameters_.k_phi * angle_difference(bearing, pose.yaw);               // Eq. (36) of [NIS]
}

double WaypointFollower::steer_along_path(const Pose2& pose) const {
  const Eigen::Vector2d start = *segment_start_;
  const Eigen::Vector2d way = waypoints_[target()] - start;
  Eigen::Vector2d aim = waypoints_[target()];
  if (!way.isZero()) {
    const Eigen::Vector2d along = way.normalized();
    aim = start + ((pose.position() - start).dot(along) + parameters_.lookahead) * along;
  }
  const Eigen::Vector2d ahead = aim - pose.position();
  const double bearing = angle_difference(direction_of(ahead), pose.yaw);
  if (std::abs(bearing) > 0.5 * kPi) return std::copysign(parameters_.max_steering_angle, bearing);
  return std::atan2(2.0 * parameters_.wheelbase * std::sin(bearing), ahead.norm());
}

}  // namespace multipath_localization
