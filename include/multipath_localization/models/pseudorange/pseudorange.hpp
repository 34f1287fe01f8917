#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// No satellite is nearer to or further from the Earth's centre [m].
constexpr double kLowestOrbit = 1e7, kHighestOrbit = 1e8;
/// No range changes faster, clock drift included, and no satellite flies faster [m/s].
constexpr double kFastestRangeRate = 1e5;

/// A satellite as seen from an antenna.
struct LineOfSight {
  double range = 0.0;                                   ///< [m]
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< to the satellite, of length 1, in map
};

/// From `antenna`, in map: east, north, up [m]. Eq. (4) of [SUZ].
LineOfSight line_of_sight(const SatelliteObservation& observation, const Eigen::Vector3d& antenna);

/// Position and clocks from the pseudoranges of one epoch alone.
struct PseudorangeSolution {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();        ///< antenna in map: east, north, up [m]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< formal: as the weights have it [m^2]
  /// Receiver clock against that of each constellation [m]; NaN for one without satellites.
  std::array<double, kConstellations> clock{};
  double weighted_square_sum = 0.0;  ///< of the residuals
  int used = 0;                      ///< satellites of positive weight
  int degrees_of_freedom = 0;        ///< satellites used - unknowns
};

/// The declared standard deviation of a pseudorange as it is believed [m]: none is better than half a metre,
/// or a single one would leave the others without a say.
double believed_sigma(const SatelliteObservation& observation);

/// Weights that trust the declared standard deviations: 1 / sigma^2 of each observation [1/m^2].
std::vector<double> declared_weights(const std::vector<SatelliteObservation>& observations);

/// Single point positioning: weighted least squares by Gauss-Newton from `start` (in map, on or near the
/// Earth; 0 will do) over position and one clock for each constellation, Eq. (3) of [SUZ]. One weight >= 0
/// per observation [1/m^2]; 0 leaves it out. Nothing when there are fewer satellites than unknowns, when
/// their geometry leaves one undetermined or when it does not converge.
std::optional<PseudorangeSolution> solve_position(const std::vector<SatelliteObservation>& observations,
                                                  const std::vector<double>& weights,
                                                  const Eigen::Vector3d& start);

/// The same by declared weights where nothing is known of the antenna: `map`, in which the satellites are
/// given, may lie anywhere on the Earth.
std::optional<Geodetic> solve_geodetic(const std::vector<SatelliteObservation>& observations,
                                       const LocalFrame& map);

}  // namespace multipath_localization
