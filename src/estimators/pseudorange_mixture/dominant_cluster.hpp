#pragma once

#include <vector>

#include "estimators/pseudorange_mixture/belief.hpp"

namespace multipath_localization {

/// One weighted hypothesis of the pose.
struct WeightedBelief {
  Belief belief;
  double weight = 1.0;     ///< all sum to 1
  bool in_shadow = false;  ///< holds the measurements to be reflected
};

/// The heaviest group of hypotheses that agree on the pose, as one Gaussian.
struct DominantCluster {
  Belief belief;        ///< mean and covariance within the cluster
  double mass = 0.0;    ///< sum of its weights
  double shadow = 0.0;  ///< share of it in the mode "shadow"
  Eigen::Matrix2d overall_position_covariance =
      Eigen::Matrix2d::Zero();  ///< all hypotheses about the mean [m^2]
};

inline constexpr double kHeadingReach = 0.6;  ///< [rad]

/// Finds it: of the heaviest hypotheses, the one with the most weight within its reach; where that is not
/// half of all, others are tried as well, spread evenly over the weight. With a `heading_reach` of pi those
/// agree that share the place.
DominantCluster dominant_cluster(const std::vector<WeightedBelief>& particles,
                                 double heading_reach = kHeadingReach);

}  // namespace multipath_localization
