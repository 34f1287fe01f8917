#pragma once

#include <Eigen/Core>
#include <cmath>

namespace multipath_localization {

/// (P + P') / 2, for a covariance of N x N that is symmetric but for rounding.
template <int N>
Eigen::Matrix<double, N, N> symmetric(const Eigen::Matrix<double, N, N>& P) {
  return 0.5 * (P + P.transpose());
}

/// Whether a finite matrix is a covariance: symmetric and no eigenvalue below zero, each but for rounding,
/// 1e-6 of the largest variance, and no variance below zero.
bool positive_semi_definite(const Eigen::Matrix2d& P);
bool positive_semi_definite(const Eigen::Matrix3d& P);

/// Root of the mean variance of the two axes, in the unit of one.
inline double mean_sigma(const Eigen::Matrix2d& P) { return std::sqrt(0.5 * P.trace()); }

}  // namespace multipath_localization
