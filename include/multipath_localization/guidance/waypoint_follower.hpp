#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/trust.hpp"
#include "multipath_localization/guidance/caution.hpp"
#include "multipath_localization/guidance/goal_driver.hpp"
#include "multipath_localization/guidance/route.hpp"
#include "multipath_localization/guidance/stopover.hpp"
#include "multipath_localization/guidance/trail.hpp"
#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

namespace multipath_localization {

/// A command to be brought about within a base's limits, see CommandLimiter, and, in words, what it is for:
/// "driving", "slow: fixes are biased", "stopped: localisation lost", "finished", ...
struct FollowerOutput {
  MotionCommand command;
  std::string status;
  bool urgent = false;  ///< a stop, because the pose must not be driven by
  double spin = 0.0;    ///< of a differential base at rest, on the spot [rad/s]
};

/// Steers a robot along waypoints in map, and stops where the pose cannot be driven by.
///
/// The law `path_tracking` follows the Path through them, from where the robot is when it sets out, and comes
/// to rest at the last one: GoalDriver. `nishida` steers straight for each, at one
/// speed, as [NIS] does, which circles round a target once missed. When a waypoint is passed: PathProgress.
///
/// With `loop`, a route is driven round where one of its waypoints is farther from the first than what a
/// robot passes that circles on the spot, 2 (turning radius + `switch_radius`). A smaller one is driven once.
class WaypointFollower {
 public:
  /// Waypoints in map [m]. Throws std::invalid_argument as Route does.
  WaypointFollower(const WaypointFollowerParameters& parameters, std::vector<Eigen::Vector2d> waypoints,
                   RouteTasks tasks = {});

  /// The command for a base in map at `pose`, by now, of a standard deviation of `sigma` to a side [m], as it
  /// was known `pose_age` seconds ago; `now` [s] counts what it waits at waypoints.
  FollowerOutput command(const Pose2& pose, double pose_age, Trust state, double sigma = 0.0,
                         double now = 0.0);

  /// As command does by itself: after NOT_READY and LOST the heading has to show anew, as at the start.
  void heed(Trust state);

  /// Gives the waypoint steered for up, as if it were passed; the next is gone to straight from where the
  /// robot is. Nothing where there is none.
  void skip();

  /// Ends a wait at a waypoint. False where it does not wait.
  bool go_on();

  /// Takes other coordinates [m] for the same waypoints, map having moved. Throws std::invalid_argument when
  /// they are not as many or one is not finite.
  void move_waypoints(std::vector<Eigen::Vector2d> waypoints);

  /// Takes waypoints in map [m] that continue the present ones, see target_in_continuation, and goes on to
  /// the waypoint steered for; laps are counted anew, unless it is the same route. False, and nothing is
  /// changed, where they are another. Throws std::invalid_argument as Route does.
  bool continue_along(const std::vector<Eigen::Vector2d>& waypoints, const RouteTasks& tasks = {});

  /// Takes waypoints in map [m] for another route. One that begins where the robot has just been, within a
  /// few seconds' way, is joined where the robot is on it: planners plan from a pose of a moment ago. Any
  /// other is driven from its first waypoint on. Throws std::invalid_argument as Route does.
  void take_route(const std::vector<Eigen::Vector2d>& waypoints, const RouteTasks& tasks = {});

  /// Whether to go on to the first waypoint after the last. Taken away, the round under way is the last.
  void set_loop(bool loop);

  [[nodiscard]] const Route& route() const { return route_; }
  [[nodiscard]] std::size_t target() const { return route_.target(); }  ///< index of the waypoint steered for
  [[nodiscard]] double progress() const { return route_.progress(); }   ///< those skipped count as passed
  [[nodiscard]] bool finished() const;                                  ///< never, when driving round
  [[nodiscard]] bool can_loop() const;  ///< whether the route is wide enough to be driven round
  [[nodiscard]] const std::vector<Eigen::Vector2d>& waypoints() const { return route_.waypoints(); }
  /// Where the robot is on its path. Null before it steers, and after a skip until it does.
  [[nodiscard]] const PathProgress* progress_on_path() const {
    return driver_ ? &driver()->progress() : nullptr;
  }
  /// What drives along that path. Null likewise.
  [[nodiscard]] const PathDriver* driver() const { return driver_ ? &driver_->on_path() : nullptr; }

 private:
  [[nodiscard]] bool loops() const { return parameters_.loop && !route_.tasks().once && can_loop(); }
  /// Lays the path by places behind the robot through the waypoints to come, to the next one to stop at.
  void lay_path(std::vector<Eigen::Vector2d> behind, const Eigen::Vector2d& position);
  void lay_path_anew();  ///< through other waypoints to come, if there is one
  void pass_waypoints(const Pose2& pose);
  [[nodiscard]] FollowerOutput turn(const Pose2& pose);  ///< at the last waypoint, to its heading
  [[nodiscard]] FollowerOutput steer(const Pose2& pose, const Pace& pace);

  WaypointFollowerParameters parameters_;
  Route route_;
  Caution caution_;
  std::optional<GoalDriver> driver_;  ///< none: from where the robot is next
  Trail trail_;
  Stopover stopover_;
  bool turning_ = false;  ///< at the last waypoint, to the final heading
};

}  // namespace multipath_localization
