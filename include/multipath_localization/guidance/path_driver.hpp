#pragma once

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

/// The law `path_tracking`: a base along its path, by tracking_curvature at the speed of a SpeedProfile.
class PathDriver {
 public:
  /// A base that comes to the end of the path at `end_speed` [m/s].
  PathDriver(const WaypointFollowerParameters& parameters, PathProgress progress, double end_speed);

  [[nodiscard]] PathProgress& progress() { return progress_; }
  [[nodiscard]] const PathProgress& progress() const { return progress_; }
  [[nodiscard]] const SpeedProfile& speed() const { return speed_; }

  /// For a base at `pose`, whose progress on the path is known, at `most` [m/s].
  PathCommand command(const Pose2& pose, double most);

 private:
  /// The spin that faces a differential base along its path where it looks far aside; 0 where it may drive.
  double spin_to_path(const Pose2& pose);
  [[nodiscard]] double speed_at(const Pose2& pose) const;
  [[nodiscard]] double curvature(const Pose2& pose, double speed) const;

  WaypointFollowerParameters parameters_;
  PathProgress progress_;
  SpeedProfile speed_;
  bool spinning_ = false;
};

}  // namespace multipath_localization
