#pragma once

#include <optional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Dead reckoning: where increments of odometry lead.
class OdometryTrack {
 public:
  /// `increments` by stamp. Starts at the origin with the first one.
  explicit OdometryTrack(const std::vector<OdometryIncrement>& increments);

  /// Base in odom at `stamp`; nothing outside of the increments.
  [[nodiscard]] std::optional<Pose2> pose(double stamp) const;

  /// Way driven by `stamp`, forwards or in reverse [m]; nothing outside of the increments.
  [[nodiscard]] std::optional<double> distance(double stamp) const;

 private:
  struct Node {
    OdometryIncrement increment;
    Pose2 start;            ///< of the increment, in odom
    double distance = 0.0;  ///< driven before it [m]
  };
  [[nodiscard]] const Node* at(double stamp) const;

  std::vector<Node> nodes_;
};

/// One and the same piece of way, as the fixes have it and as odometry has it.
struct Chord {
  double start = 0.0;                                  ///< stamp of its first fix [s]
  double end = 0.0;                                    ///< stamp of its last fix [s]
  Eigen::Vector2d by_fixes = Eigen::Vector2d::Zero();  ///< last fix less first [m]
  Eigen::Vector2d by_odometry =
      Eigen::Vector2d::Zero();  ///< the same in odom, which is turned against map [m]
};

/// Successive pieces of way of at least `length` [m] as the crow flies, each from fix to fix; the lever arm
/// is carried by the heading of odometry.
std::vector<Chord> chords(const std::vector<GnssFix>& fixes, const OdometryTrack& track, double length);

}  // namespace multipath_localization
