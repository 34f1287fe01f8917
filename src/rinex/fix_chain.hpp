#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace multipath_localization {

/// A position of one epoch and what is known to check it by.
struct ChainLink {
  double stamp = 0.0;                                       ///< [s]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();       ///< in any Cartesian frame [m]
  double speed = std::numeric_limits<double>::quiet_NaN();  ///< by Doppler [m/s]; NaN: not known
  int redundancy = 0;                                       ///< degrees of freedom of its solution
};

/// Tells which of an antenna's positions (stamps increasing) lie on its way: on the chain that has most of
/// them, well checked ones before others, and in which each can be reached from the one before. Within `t`
/// seconds that is 100 m, for what reflections do, and t times 10 m/s over the speed, or 50 m/s where that is
/// not known; after a minute it is anywhere. A few satellites without redundancy put a fix kilometres off
/// which its own covariance does not tell.
std::vector<bool> on_its_way(const std::vector<ChainLink>& links);

}  // namespace multipath_localization
