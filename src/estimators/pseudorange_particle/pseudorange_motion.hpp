#pragma once

#include <Eigen/Core>
#include <optional>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization {

/// What moves the particles, as `motion` says.
enum class MotionSource { kAuto, kDoppler, kOdometry };

/// Decisions about Eqs. (8), (9) of [SUZ]: what moves the particles and how far it can be trusted.
struct PseudorangeMotionParameters {
  MotionSource motion = MotionSource::kAuto;
  double doppler_tolerance = 0.5;
  double doppler_walk = 0.1;
  bool velocity_follows_odometry = true;
  double odometry_walk = 0.3;
  double height_walk = 0.1;
  double yaw_walk = 0.02;
  double speed_scale_sigma = 0.01;
  double gyro_bias_sigma = 0.002;
  double gyro_bias_walk = 1e-4;

  void fields(ParameterVisitor& field);
};

/// What a particle of the pseudorange particle filter is besides a pose.
struct PseudorangeParticle {
  double height = 0.0;                      ///< of the antenna in map [m]
  std::optional<Eigen::Vector3d> velocity;  ///< of the base in map by Doppler; nothing: moved by odometry
  double course_variance = 0.0;             ///< of the yaw as the courses have it [rad^2]
  OdometerErrors errors;
};

/// Moves one particle over `u`, Eq. (8) of [SUZ], from the increment `before` it. Departs: Eq. (9) prints the
/// normal density without squares; the noise is a random walk, as much at every rate; without Doppler the
/// odometry moves the particle; and between epochs the Doppler velocity may turn and change as that does.
void move(Pose2& pose, PseudorangeParticle& particle, const OdometryIncrement& u,
          const OdometryIncrement& before, const PseudorangeMotionParameters& parameters,
          RandomStream& random);

/// Sets the particle's velocity by that of the antenna, and corrects the yaw by its direction. The lever arm
/// [m] may have been carried back from `u`: then the antenna's velocity of a moment ago becomes the base's of
/// now.
void adopt_velocity(Pose2& pose, PseudorangeParticle& particle, const Eigen::Vector3d& of_antenna,
                    const Eigen::Vector2d& antenna_in_base, const OdometryIncrement& u);

}  // namespace multipath_localization
