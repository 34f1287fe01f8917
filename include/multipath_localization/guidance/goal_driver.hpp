#pragma once

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/path_driver.hpp"
#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

namespace multipath_localization {

/// A PathDriver that comes to rest at the end of its path, and not beside it where the last leg is too short
/// for the base to come onto: it then takes another way there. A base that turns on the spot turns to the end
/// and goes straight; another goes on and turns round to it, as far as `max_deviation` allows. That is found
/// before the leg is driven, by a rehearsal, or else when the base has come by the end.
class GoalDriver {
 public:
  GoalDriver(const WaypointFollowerParameters& parameters, PathProgress progress, const PathPlan& plan);

  /// Follows a base to where it is now; whether it passes the next waypoint there.
  bool passes(const Pose2& pose);
  void pass_next() { driver_.pass_next(); }  ///< goes on to the waypoint after the next

  /// As PathDriver::command.
  PathCommand command(const Pose2& pose, double most);

  [[nodiscard]] const PathDriver& on_path() const { return driver_; }
  /// How far from the end of the path it was passed [m]; 0 before.
  [[nodiscard]] double missed_by() const { return missed_by_; }

  static constexpr double kAtGoal = 0.05;  ///< [m] the rest of a tenth is what braking and delays take

 private:
  [[nodiscard]] bool leads_beside(const Pose2& pose) const;
  /// False where there is none.
  bool take_other_way(const Pose2& pose);
  [[nodiscard]] PathDriver along(Path path) const;
  [[nodiscard]] bool strays(const Path& path) const;

  WaypointFollowerParameters parameters_;
  PathPlan plan_;  ///< of the way to the end
  PathDriver driver_;
  MotionCommand last_;  ///< wanted
  bool rehearsed_ = false;
  int ways_left_;
  double missed_by_ = 0.0;
};

}  // namespace multipath_localization
