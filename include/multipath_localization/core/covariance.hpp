#pragma once

#include <Eigen/Core>

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

}  // namespace multipath_localization
