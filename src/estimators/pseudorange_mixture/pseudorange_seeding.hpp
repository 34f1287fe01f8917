#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "estimators/pseudorange_mixture/receiver_prior.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "multipath_localization/models/pseudorange/satellite_mixture.hpp"

namespace multipath_localization {

/// Where the antenna may be, by a few satellites of one epoch.
struct PseudorangeSeed {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< antenna in map [m]
  double clock = 0.0;                                  ///< against GPS time [m]
  std::array<double, kConstellations> offset{};        ///< of the other clocks against it [m]
  double log_likelihood = 0.0;                         ///< of the whole epoch under the mixture
};

struct PseudorangeSeedingParameters {
  int subsets = 500;
  double seed_sigma = 5.0;
  double offset_sigma = 15.0;
  double log_likelihood_scale = 3.0;
};

/// What is known of the position before: of the antenna, horizontally.
struct AntennaPrior {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();        ///< in map [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< [m^2]
};

/// What is known before the epoch.
struct SeedPrior {
  std::optional<AntennaPrior> antenna;
  std::optional<ReceiverPrior> receiver;
};

/// Draws `count` positions: least squares over random subsets of the epoch, each just large enough and
/// preferring satellites likely to be in line of sight, weighed by how well all satellites fit. Empty when
/// the epoch has too few satellites for a position.
std::vector<PseudorangeSeed> pseudorange_seeds(const std::vector<SatelliteObservation>& observations,
                                               const SeedPrior& prior, std::size_t count,
                                               const SatelliteMixtureParameters& mixture,
                                               const PseudorangeSeedingParameters& parameters,
                                               RandomStream& random);

}  // namespace multipath_localization
