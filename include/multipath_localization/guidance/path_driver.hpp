#pragma once

#include <vector>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/path_progress.hpp"
#include "multipath_localization/guidance/speed_profile.hpp"
#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

namespace multipath_localization {

/// How a base is to move along its path.
struct PathCommand {
  MotionCommand command;
  double spin = 0.0;  ///< of a differential base at rest, on the spot [rad/s]
};

/// How fast a differential base at rest turns on the spot that is to face `turn` [rad] further to the left
/// [rad/s].
double spin_towards(double turn, const CommandLimits& limits);

/// How a base is to drive along a path.
struct PathPlan {
  double end_speed;                   ///< that it comes to the end of the path at [m/s]
  bool reverse = false;               ///< backwards: its rear leads
  std::vector<SpeedZone> zones = {};  ///< of the path
};

/// The law `path_tracking`: a base along its path, by tracking_curvature at the speed of a SpeedProfile.
class PathDriver {
 public:
  PathDriver(const WaypointFollowerParameters& parameters, PathProgress progress, const PathPlan& plan);

  /// Follows a base to where it is now; whether it passes the next waypoint there.
  bool passes(const Pose2& pose) { return progress_.passes(leading(pose)); }
  void pass_next() { progress_.pass_next(); }  ///< goes on to the waypoint after the next

  [[nodiscard]] const PathProgress& progress() const { return progress_; }
  [[nodiscard]] const SpeedProfile& speed() const { return speed_; }
  [[nodiscard]] bool reverse() const { return reverse_; }
  /// How far along a line a base comes back onto it, for the most part, at `speed` [m/s].
  [[nodiscard]] double settling_length(double speed) const;
  /// The pose of the end that leads: the rear in reverse.
  [[nodiscard]] Pose2 leading(const Pose2& pose) const;

  /// For a base at `pose`, whose progress on the path is known, at `most` [m/s].
  PathCommand command(const Pose2& pose, double most);

  /// The poses that a base at `pose` will take over `length` [m], to the end of the path at most, kWayStep
  /// apart: as the law steers at `speed` [m/s], carried out at once.
  [[nodiscard]] std::vector<Pose2> way_ahead(const Pose2& pose, double speed, double length) const;

  static constexpr double kWayStep = 0.1;  ///< [m]

 private:
  /// The spin that faces a differential base along its path where it looks far aside; 0 where it may drive.
  double spin_to_path(const Pose2& pose);
  [[nodiscard]] double speed_at(const Pose2& pose) const;
  /// To steer by at `pose`, for which the place on the path is `station` [m].
  [[nodiscard]] double curvature(const Pose2& pose, double speed, double station) const;

  WaypointFollowerParameters parameters_;
  PathProgress progress_;
  SpeedProfile speed_;
  bool reverse_;
  bool spinning_ = false;
};

}  // namespace multipath_localization
