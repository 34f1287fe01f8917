#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// Velocity of an antenna from the range rates of one epoch.
struct DopplerVelocity {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();        ///< in map: east, north, up [m/s]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< as the residuals have it [m^2/s^2]
};

/// By least squares of rate = (satellite's - antenna's velocity) along the line of sight + drift, with
/// Cauchy's weights against outliers. All satellites share one drift. A range rate's standard deviation goes
/// with that of the pseudorange; the residuals tell its size, together with four at 0.1 m/s that stand for
/// what is known before. `antenna`, in map [m]: a hundred metres off turn the velocity by 2 cm/s. Nothing
/// with fewer than five satellites or where their geometry leaves a direction open.
std::optional<DopplerVelocity> doppler_velocity(const std::vector<SatelliteObservation>& observations,
                                                const Eigen::Vector3d& antenna);

}  // namespace multipath_localization
