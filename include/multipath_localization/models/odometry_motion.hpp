#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

/// True when the wheels stand: then nothing moves, turns or diffuses, and a gyro's bias does not turn a
/// parked robot. Turning on the spot is no standstill.
bool standing(const OdometryIncrement& u);

/// Noise of a front-wheel-steering robot's motion, Eqs. (5)-(7) of [NIS].
struct SteeringNoiseParameters {
  double wheelbase = 1.0;  ///< l [m]
  double alpha1 = 3.0;     ///< as printed in section 4.1 of [NIS], like the other five
  double alpha2 = 0.3;
  double alpha3 = 3.0;
  double alpha4 = 0.3;
  double alpha5 = 3.0;
  double alpha6 = 0.3;
  double noise_scale = 3e-3;   ///< departs: 1 as printed, which wraps the steering angle round the circle
  double noise_period = 0.01;  ///< Delta of [NIS] [s]
  double max_steering_angle = 1.2;  ///< departs: no limit as printed [rad]

  void fields(ParameterVisitor& field);
};

/// The front wheel's angle phi that gives the increment's yaw rate, by Eq. (4) of [NIS]: atan(l omega / v),
/// in
/// (-pi/2, pi/2); 0 when turning on the spot, which Eq. (4) cannot.
double steering_angle(const OdometryIncrement& u, double wheelbase);

/// Draws motions p_f, Eq. (8) of [NIS], over one increment. Arcs are in chord form (see `displacement`),
/// which has no singularity at omega = 0.
///
/// Departs: [NIS] draws once per period Delta. Here the deviations of speed and yaw rate are scaled by
/// sqrt(Delta / duration), so that a metre costs the same noise at every odometry rate; at duration = Delta
/// it is the printed law.
class SteeringMotion {
 public:
  SteeringMotion(const OdometryIncrement& u, const SteeringNoiseParameters& parameters);

  /// A pose at the end of the increment, from one at its start. Turns on the spot are free of noise, by Eqs.
  /// (5)-(7) with v = 0.
  [[nodiscard]] Pose2 sample(const Pose2& pose, RandomStream& random) const;

 private:
  OdometryIncrement u_;
  double wheelbase_;
  double max_steering_angle_;
  double steering_angle_;
  double sigma_speed_ = 0.0;     ///< root of Eq. (5)'s variance [m/s]
  double sigma_steering_ = 0.0;  ///< root of Eq. (6)'s [rad]
  double sigma_yaw_rate_ = 0.0;  ///< root of Eq. (7)'s [rad/s]
  double deviation_scale_ = 0.0;
};

/// The slowly varying errors of an odometer: true speed = measured / (1 + speed_scale), true yaw rate =
/// measured - gyro_bias.
struct OdometerErrors {
  double speed_scale = 0.0;  ///< [1]
  double gyro_bias = 0.0;    ///< [rad/s]
};

/// The increment without those errors.
OdometryIncrement without_errors(const OdometryIncrement& u, const OdometerErrors& errors);

/// Pose at the end of an increment, the odometer's errors taken out.
Pose2 moved(const Pose2& pose, const OdometryIncrement& u, const OdometerErrors& errors);

/// Derivatives of `moved`.
struct MotionJacobians {
  Eigen::Matrix3d pose;                ///< of (x, y, yaw) to (x, y, yaw)
  Eigen::Matrix<double, 3, 2> errors;  ///< of (x, y, yaw) to (speed_scale, gyro_bias)
};
MotionJacobians motion_jacobians(const Pose2& pose, const OdometryIncrement& u, const OdometerErrors& errors);

}  // namespace multipath_localization
