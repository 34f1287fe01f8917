#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/trust.hpp"
#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

namespace multipath_localization {

/// A pose in map and how well it is known.
struct KnownPose {
  Pose2 pose;
  double age;  ///< since it was measured [s]
  Trust trust;
  double sigma;  ///< standard deviation of the position to a side [m]
};

/// How fast to drive, and the words for it.
struct Pace {
  double ratio;        ///< of the cruise speed; 0: stand
  std::string status;  ///< "driving", "slow: fixes are biased", "stopped: localisation lost", ...
  bool urgent;         ///< a stop, because the pose must not be driven by
};

/// How far a pose may be driven by: slower as it is less certain, and not at all where it is not known.
class Caution {
 public:
  explicit Caution(const WaypointFollowerParameters& parameters) : parameters_(parameters) {}

  /// After NOT_READY and LOST the heading has to show anew, as at the start. Whether that is so.
  bool heed(Trust state);

  [[nodiscard]] Pace pace(const KnownPose& known) const;

  /// Whether the heading of a pose that is driven by is good enough to steer by: it is confirmed, or the
  /// robot has gone `aligning_distance` straight on.
  bool heading_shown(const KnownPose& known);

  /// The distance gone straight on counts from the next pose: map has moved.
  void forget_positions() { first_position_.reset(); }

 private:
  [[nodiscard]] std::string reason_to_stop(const KnownPose& known) const;
  [[nodiscard]] double ratio_by(double sigma) const;

  WaypointFollowerParameters parameters_;
  std::optional<Eigen::Vector2d> first_position_;  ///< since the pose is known
  bool underway_ = false;                          ///< the heading has been good enough to steer by
};

}  // namespace multipath_localization
