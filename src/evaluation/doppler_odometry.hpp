#pragma once

#include <cstddef>
#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// Horizontal velocity at one instant.
struct VelocitySample {
  double stamp = 0.0;                                        ///< [s]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();        ///< in map: east, north [m/s]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< [m^2/s^2]
};

/// What the Doppler shifts of a drive say of its motion.
struct DopplerTrack {
  std::vector<VelocitySample> samples;  ///< one for each epoch from the first that has a velocity on
  std::size_t held = 0;                 ///< samples without velocity of their own: the last one goes on
  double longest_hold = 0.0;            ///< that such samples follow each other for [s]
};

/// Of epochs by stamp with satellites in map. Directions are those from where the pseudoranges put the
/// antenna, and put it last where they do not.
DopplerTrack doppler_track(const std::vector<PseudorangeEpoch>& epochs);

/// The odometry that velocities amount to: speed is that along the track, yaw rate the change of the course,
/// one increment between consecutive samples and a millisecond for the first. It is that of the antenna, not
/// of the base, and a robot that turns on the spot or slides does not show.
///
/// Standing is told from moving: a speed below 0.1 m/s or below five standard deviations is zero and turns
/// nothing, and the course stays what it was, so that the noise of a parked receiver is no motion. Velocity
/// has no front: the course is taken to have turned by less than a right angle since the last motion, else
/// the robot drives in reverse.
std::vector<OdometryIncrement> odometry_of(const std::vector<VelocitySample>& samples);

}  // namespace multipath_localization
