#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/trust.hpp"

namespace multipath_localization {

struct WaypointFollowerParameters {
  std::string law = "path_tracking";
  double cruise_speed = 1.5;
  double wheelbase = 0.5;
  double max_steering_angle = 0.6;
  double k_phi = 0.8;
  double lookahead = 2.0;
  double switch_radius = 1.0;
  double crossing_width = 5.0;
  bool loop = true;
  double max_pose_age = 0.5;
  double aligning_distance = 5.0;
  double aligning_speed_ratio = 0.5;
  double multipath_speed_ratio = 0.7;
  double dead_reckoning_speed_ratio = 0.5;

  void fields(ParameterVisitor& field);
};

/// A command and, in words, what it is for: "driving", "slow: fixes are biased", "stopped: localisation
/// lost", "finished", ...
struct FollowerOutput {
  MotionCommand command;
  std::string status;
};

/// Steers a front-wheel-steering robot along waypoints in map, and stops where the pose cannot be driven by.
///
/// A waypoint is passed within `switch_radius` of it, or by crossing the line through it that is
/// perpendicular to the way there, at most `crossing_width` or `switch_radius` aside, or by being so near to
/// what prolongs that way beyond it. A circle round a waypoint that lies within the turning circle crosses
/// that, so that there is no second one. Departs from [NIS], which knows the radius only and circles round a
/// target once missed.
///
/// The way to a waypoint is the line from the last one passed that is at least `switch_radius` away from it:
/// the direction between nearer ones is that of their errors.
///
/// With `loop`, a route is driven round where one of its waypoints is farther from the first than what a
/// robot passes that circles on the spot, 2 (turning radius + `switch_radius`). A smaller one is driven once.
class WaypointFollower {
 public:
  /// Waypoints in map [m]. Throws std::invalid_argument when one is not finite.
  WaypointFollower(const WaypointFollowerParameters& parameters, std::vector<Eigen::Vector2d> waypoints);

  /// The command for a base in map at `pose`, `pose_age` seconds old.
  FollowerOutput command(const Pose2& pose, double pose_age, Trust state);

  /// As command does by itself: after NOT_READY and LOST the heading has to show anew, as at the start.
  void heed(Trust state);

  /// Gives the waypoint steered for up, as if it were passed; the next is gone to straight from where the
  /// robot is. Nothing where there is none.
  void skip();

  /// Takes other coordinates [m] for the same waypoints, map having moved. Throws std::invalid_argument when
  /// they are not as many or one is not finite.
  void move_waypoints(std::vector<Eigen::Vector2d> waypoints);

  /// Takes waypoints in map [m] that continue the present ones, see target_in_continuation, and goes on to
  /// the waypoint steered for; laps are counted anew, unless it is the same route. False, and nothing is
  /// changed, where they are another. Throws std::invalid_argument when one is not finite.
  bool continue_along(const std::vector<Eigen::Vector2d>& waypoints);

  /// Takes waypoints in map [m] for another route. One that begins where the robot has just been, within a
  /// few seconds' way, is joined where the robot is on it: planners plan from a pose of a moment ago. Any
  /// other is driven from its first waypoint on. Throws std::invalid_argument when one is not finite.
  void take_route(const std::vector<Eigen::Vector2d>& waypoints);

  /// Whether to go on to the first waypoint after the last. Taken away, the round under way is the last.
  void set_loop(bool loop) { parameters_.loop = loop; }

  [[nodiscard]] std::size_t target() const;  ///< index of the waypoint steered for
  [[nodiscard]] int laps() const;            ///< rounds completed
  [[nodiscard]] double progress() const;     ///< waypoints passed or skipped, over those of a round
  [[nodiscard]] bool finished() const;       ///< never, when driving round
  [[nodiscard]] bool can_loop() const;       ///< whether the route is wide enough to be driven round
  [[nodiscard]] const std::vector<Eigen::Vector2d>& waypoints() const { return waypoints_; }

 private:
  /// How fast to drive in a state, and the words for it.
  struct Pace {
    double ratio;  ///< of the cruise speed
    std::string reason;
    std::string status;
  };

  [[nodiscard]] Pace pace_in(Trust state) const;
  [[nodiscard]] std::string reason_to_stop(const Pose2& pose, double pose_age, Trust state) const;
  void remember(const Eigen::Vector2d& position);
  [[nodiscard]] bool has_just_been_at(const Eigen::Vector2d& place) const;
  [[nodiscard]] bool heading_shown(const Eigen::Vector2d& position, Trust state);
  void pass_waypoints(const Eigen::Vector2d& position);
  void begin_segment();
  [[nodiscard]] bool passed_target(const Eigen::Vector2d& position) const;
  [[nodiscard]] double loop_extent() const;  ///< of a route driven round, at least [m]
  [[nodiscard]] FollowerOutput end() const;
  /// Eqs. (36) and (38) of [NIS]. Departs: the error is of the heading, where Eq. (36) prints the steering
  /// angle.
  [[nodiscard]] double steer_to_target(const Pose2& pose) const;
  /// Pure pursuit (Coulter 1992): the arc to a point `lookahead` beyond the foot of the pose on the line.
  [[nodiscard]] double steer_along_path(const Pose2& pose) const;

  WaypointFollowerParameters parameters_;
  std::vector<Eigen::Vector2d> waypoints_;
  double extent_;  ///< greatest distance of a waypoint from the first [m]
  std::size_t passed_ = 0;
  std::optional<Eigen::Vector2d> segment_start_;   ///< none: where the robot is next
  std::optional<Eigen::Vector2d> first_position_;  ///< since the pose is known
  std::deque<Eigen::Vector2d> trail_;              ///< where the robot has just been, the latest last
  bool underway_ = false;                          ///< the heading has been good enough to steer by
};

}  // namespace multipath_localization
