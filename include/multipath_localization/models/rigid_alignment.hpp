#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// A heading [rad] and its variance [rad^2].
struct AlignedHeading {
  double yaw = 0.0;
  double variance = 0.0;
};

/// Heading without a compass: turns dead reckoning of the last metres rigidly on to the fixes (Procrustes in
/// the plane). Works in reverse and sideways, since dead reckoning carries the direction of the speed; says
/// nothing when the robot has not moved far or the two shapes differ.
class RigidAlignment {
 public:
  /// `length`: distance looked back [m]. `fix_sigma`: noise of a fix at least [m]. `floor`: variance that a
  /// bias changing over the window leaves at best [rad^2].
  RigidAlignment(double length, double fix_sigma, double floor)
      : length_(length), fix_sigma_(fix_sigma), floor_(floor) {}

  void clear();
  void add(const OdometryIncrement& increment);
  /// Takes a fix made where dead reckoning is now.
  void add(const Eigen::Vector2d& base_by_fix);

  /// Heading of the base in map now.
  [[nodiscard]] std::optional<AlignedHeading> heading() const;

 private:
  struct Pair {
    Eigen::Vector2d base_in_odom;
    Eigen::Vector2d base_in_map;
    double distance;
  };

  double length_;
  double fix_sigma_;
  double floor_;
  Pose2 base_in_odom_;
  double distance_ = 0.0;
  std::deque<Pair> pairs_;
};

}  // namespace multipath_localization
