#include "multipath_localization/core/covariance.hpp"

#include <Eigen/Eigenvalues>

namespace multipath_localization {

namespace {

constexpr double kRounding = 1e-6;

template <class Matrix>
bool is_covariance(const Matrix& P) {
  const double slack = kRounding * P.diagonal().maxCoeff();
  if (P.diagonal().minCoeff() < 0.0 || (P - P.transpose()).cwiseAbs().maxCoeff() > slack) return false;
  return Eigen::SelfAdjointEigenSolver<Matrix>(P, Eigen::EigenvaluesOnly).eigenvalues()[0] >= -slack;
}

}  // namespace

bool positive_semi_definite(const Eigen::Matrix2d& P) { return is_covariance(P); }
bool positive_semi_definite(const Eigen::Matrix3d& P) { return is_covariance(P); }

}  // namespace multipath_localization
