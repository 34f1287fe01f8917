#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "estimators/multipath/velocity_law.hpp"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/models/motion/odometry_history.hpp"

namespace multipath_localization::multipath {

/// Velocities of about a second as one, and what odometry says of the same times.
struct VelocitySighting {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< mean, of the antenna in map [m/s]
  /// The same by odometry without its scale, in the base of now, were the velocities late by so many steps
  /// [m/s].
  std::array<Eigen::Vector2d, kDelays> driven;
  double variance = 0.0;     ///< declared of one, a component [m^2/s^2]
  double count = 1.0;        ///< of velocities
  double duration = 0.0;     ///< since the last sighting [s]
  double usual_speed = 0.0;  ///< of the robot [m/s]
  /// From where the antenna was at the start to the base of now, in the base of now; zero once that is far
  /// [m].
  Eigen::Vector2d from_start = Eigen::Vector2d::Zero();
  bool near_start = false;
};

/// Collects velocities until they are weighed, beside the odometry of the last seconds. That is kept from the
/// first velocity on, which tells nothing but that others come.
class VelocityBlock {
 public:
  /// The robot moves on by that; turns without the errors that are known, speeds with them.
  void move(const OdometryIncrement& u);
  /// The hypotheses start here with the antenna there in the base.
  void start(const Eigen::Vector2d& antenna_in_base);

  /// From where the antenna was at the start to the base of now, in the base of now [m]; nothing once that is
  /// too far to turn a heading that was any about it.
  [[nodiscard]] std::optional<Eigen::Vector2d> from_start() const;

  /// Takes a velocity: how unusable it is, or nothing.
  std::optional<Reason> add(const GnssVelocity& velocity);

  [[nodiscard]] bool empty() const { return velocities_.empty(); }
  /// Since the last `take` [s].
  [[nodiscard]] double age() const { return now_ - taken_; }

  /// The velocities as one, forgotten then; nothing where the wheels stand or odometry does not reach.
  std::optional<VelocitySighting> take();

 private:
  [[nodiscard]] std::optional<Eigen::Vector2d> driven(const GnssVelocity& velocity, double delay) const;

  OdometryHistory history_{4.0};
  std::vector<GnssVelocity> velocities_;
  std::optional<Eigen::Vector2d> last_;  ///< that was told [m/s]
  double now_ = 0.0;
  double taken_ = 0.0;
  Pose2 antenna_at_start_;  ///< in the base of now
  double way_ = 0.0;        ///< since the start [m]
};

}  // namespace multipath_localization::multipath
