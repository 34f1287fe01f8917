#pragma once

#include <Eigen/Core>
#include <optional>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What an inertial sensor measured at one instant, in the axes of the base.
struct InertialSample {
  double stamp = 0.0;                           ///< [s]
  std::optional<Eigen::Vector3d> up;            ///< upwards by its orientation, of length one
  std::optional<Eigen::Vector3d> acceleration;  ///< with gravity: upwards at rest [m/s^2]
  std::optional<Eigen::Vector3d> rate;          ///< of the turn [rad/s]
};

/// Which way is up by accelerations: their mean over seconds, which turns with the gyro meanwhile, less what
/// the odometry says of pulling away, braking and curves.
class GravityFilter {
 public:
  /// Takes what the base does; increments in order.
  void drive(const OdometryIncrement& motion);

  /// Takes a sample; later than the one before, finite.
  void add(const InertialSample& sample);

  /// Upwards in the base, of length one; nothing before a second of accelerations, or while their mean is not
  /// as large as gravity is on Earth.
  [[nodiscard]] std::optional<Eigen::Vector3d> up() const;

 private:
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();    ///< [m/s^2]
  Eigen::Vector3d motion_ = Eigen::Vector3d::Zero();  ///< acceleration of the base over ground [m/s^2]
  double time_ = 0.0;                                 ///< that is in the mean [s]
  std::optional<double> stamp_;                       ///< of the last sample [s]
  std::optional<double> speed_;                       ///< of the base [m/s]
};

}  // namespace multipath_localization
