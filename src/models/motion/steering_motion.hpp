#pragma once

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "simd/block.hpp"
#include "simd/instruction_set.hpp"
#include "simd/random_block.hpp"

namespace multipath_localization {

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
/// it is the printed law. An arc of more than a full circle within one increment, which noise as printed can
/// draw, ends where the full circle does. A base that moves sideways as well has v of Eqs. (5)-(7) over
/// ground, and its lateral speed noise of its own by alpha1.
class SteeringMotion {
 public:
  SteeringMotion(const OdometryIncrement& u, const SteeringNoiseParameters& parameters);

  /// Moves poses from the start of the increment to its end, each by normals of its own. Turns on the spot
  /// are free of noise, by Eqs. (5)-(7) with v = 0.
  void move(InstructionSet set, const PoseBlock& poses, const Normals& normals) const;

  /// What one increment means to all particles.
  struct Law {
    double speed = 0.0;                ///< u [m/s]
    double lateral_speed = 0.0;        ///< of an omnidirectional base [m/s]
    double yaw_rate = 0.0;             ///< u [rad/s]
    double duration = 0.0;             ///< [s]
    double steering_angle = 0.0;       ///< [rad]
    double max_steering_angle = 0.0;   ///< [rad]
    double wheelbase = 1.0;            ///< l [m]
    double sigma_speed = 0.0;          ///< root of Eq. (5)'s variance [m/s]
    double sigma_lateral_speed = 0.0;  ///< likewise, of the lateral speed alone [m/s]
    double sigma_steering = 0.0;       ///< root of Eq. (6)'s [rad]
    double sigma_yaw_rate = 0.0;       ///< root of Eq. (7)'s [rad/s]
    double deviation_scale = 0.0;      ///< sqrt(Delta / duration)
  };

 private:
  bool standing_;
  Law law_;
};

}  // namespace multipath_localization
