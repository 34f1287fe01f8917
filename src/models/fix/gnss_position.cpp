#include "multipath_localization/models/fix/gnss_position.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace multipath_localization {

Eigen::Matrix<double, 2, 3> antenna_jacobian(const Pose2& pose, const Eigen::Vector2d& antenna_in_base) {
  Eigen::Matrix<double, 2, 3> H;
  H.leftCols<2>().setIdentity();
  H.col(2) = rotation(pose.yaw) * Eigen::Vector2d(-antenna_in_base.y(), antenna_in_base.x());
  return H;
}

void DeclaredCovarianceParameters::fields(ParameterVisitor& field) {
  field("fix_sigma_floor", fix_sigma_floor, {1e-3, 1e3}, "m", "no fix is believed to be better than this");
  field("fix_sigma_cap", fix_sigma_cap, {1e-3, 1e4}, "m", "nor to be worse than this");
  field("fix_sigma_unknown", fix_sigma_unknown, {1e-3, 1e3}, "m",
        "for receivers that declare a covariance of 0");
}

Eigen::Matrix2d believed_covariance(const Eigen::Matrix2d& declared,
                                    const DeclaredCovarianceParameters& parameters) {
  const double unknown = parameters.fix_sigma_unknown;
  const Eigen::Matrix2d stated =
      declared.isZero(0.0) ? unknown * unknown * Eigen::Matrix2d::Identity() : declared;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(stated);
  const double floor = std::pow(parameters.fix_sigma_floor, 2);
  const double cap = std::max(floor, std::pow(parameters.fix_sigma_cap, 2));
  const Eigen::Vector2d variances = axes.eigenvalues().cwiseMax(floor).cwiseMin(cap);
  return axes.eigenvectors() * variances.asDiagonal() * axes.eigenvectors().transpose();
}

}  // namespace multipath_localization
