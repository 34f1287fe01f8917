#pragma once

#include <Eigen/Core>

#include "estimators/multipath/moving_time.hpp"
#include "estimators/multipath/summed_noise.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization::multipath {

/// What wheel odometry gets wrong for minutes on end, equation (2): with v and w as measured, the robot
/// drives (1 - scale) v and turns by w - gyro_bias - turn_scale w - curvature v, without turn_scale where w
/// is no more than noise by its mean, or, where a gyro beside it has told the turn, by w - imu_bias.
struct OdometryErrors {
  double scale = 0.0;       ///< of speed [1]
  double gyro_bias = 0.0;   ///< of the yaw rate of odometry, which may be a gyro's of its own [rad/s]
  double turn_scale = 0.0;  ///< of turns, as of wheels that skid or a track width that is wrong [1]
  double curvature = 0.0;   ///< of a path that odometry calls straight, as of a steering offset [rad/m]
  double imu_bias = 0.0;    ///< of the gyro beside the odometry [rad/s]
};

/// What a gyro said while the base stood.
struct GyroAtRest {
  double time = 0.0;  ///< [s]
  double turn = 0.0;  ///< that it has seen in it [rad]

  [[nodiscard]] double rate() const { return time > 0.0 ? turn / time : 0.0; }  ///< mean [rad/s]
};

/// Odometry summed up since the hypotheses were last moved, once for all of them, equation (3).
///
/// Everything is in the base frame at the start of the sum and linearised at the errors given to `restart`.
/// While the wheels stand nothing but time passes. Odometry that has never told of a turn may be one that
/// tells of none: a gyro that is not there, a driver that leaves the yaw rate at zero.
class OdometrySum {
 public:
  explicit OdometrySum(const OdometryNoise& noise) : supposed_(noise), noise_(noise) {}

  /// Of the increments from the next restart on.
  void set_noise(const OdometryNoise& noise) { supposed_ = noise; }
  void restart(const OdometryErrors& errors);
  void add(const OdometryIncrement& u);
  /// An increment that turns as the robot does by the errors of `restart`, at the speed of its wheels.
  [[nodiscard]] OdometryIncrement without_turn_errors(OdometryIncrement u) const;

  /// Displacement [m] and turn [rad] with the errors of `restart`.
  [[nodiscard]] const Eigen::Vector2d& displacement() const { return displacement_; }
  [[nodiscard]] double turn() const { return turn_; }

  [[nodiscard]] const OdometryErrors& errors() const { return errors_; }
  /// Derivatives of displacement (rows 0, 1) and turn (row 2) to scale, gyro bias, turn scale, curvature, IMU
  /// bias.
  [[nodiscard]] const Eigen::Matrix<double, 3, 5>& by_errors() const { return by_errors_; }

  [[nodiscard]] const SummedNoise& noise() const { return noise_; }

  [[nodiscard]] const GyroAtRest& gyro_at_rest() const { return gyro_at_rest_; }
  /// Whether a gyro has told every turn since the restart, so that no fault of the wheels can feign one.
  [[nodiscard]] bool turns_by_gyro() const { return moving_time_ > 0.0 && gyro_time_ >= moving_time_; }

  [[nodiscard]] double duration() const { return duration_; }          ///< [s]
  [[nodiscard]] double moving_time() const { return moving_time_; }    ///< [s]
  [[nodiscard]] double missing_time() const { return missing_time_; }  ///< without odometry [s]
  [[nodiscard]] double length() const { return length_; }              ///< of the way [m]

 private:
  /// What is known of the increments before, which no restart forgets.
  struct Before {
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< in the base, of the last one [m/s]
    bool turned = false;                                 ///< one has told of a turn
    double mean_yaw_rate = 0.0;                          ///< of the last moments [rad/s]
    MovingTime moving;

    /// The part of the yaw rate that the scale of turns counts for [rad/s].
    [[nodiscard]] double rate_of_turn(const OdometryIncrement& u) const;
  };

  void rest(const OdometryIncrement& u);
  OdometryNoise supposed_;
  OdometryErrors errors_;
  Eigen::Vector2d displacement_ = Eigen::Vector2d::Zero();
  double turn_ = 0.0;
  Eigen::Matrix<double, 3, 5> by_errors_ = Eigen::Matrix<double, 3, 5>::Zero();
  SummedNoise noise_;
  double duration_ = 0.0;
  double moving_time_ = 0.0;
  double missing_time_ = 0.0;
  double gyro_time_ = 0.0;  ///< of the moving time, with turns by the gyro [s]
  GyroAtRest gyro_at_rest_;
  double length_ = 0.0;
  Before before_;
};

}  // namespace multipath_localization::multipath
