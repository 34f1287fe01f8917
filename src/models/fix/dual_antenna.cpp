#include "multipath_localization/models/fix/dual_antenna.hpp"

#include <Eigen/Eigenvalues>

#include "multipath_localization/core/covariance.hpp"

namespace multipath_localization {

namespace {

constexpr double kLeastBaseline = 0.01;  ///< antennas nearer than this tell no heading [m]

Eigen::Vector2d across(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }
double direction_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

}  // namespace

std::optional<DualAntennaPose> dual_antenna_pose(const DualAntennaFix& fixes, double baseline_tolerance) {
  const Eigen::Vector2d mounted = fixes.left.antenna_in_base - fixes.right.antenna_in_base;
  const Eigen::Vector2d seen = fixes.left.position - fixes.right.position;
  const double baseline = mounted.norm();
  if (baseline < kLeastBaseline || seen.norm() == 0.0) return std::nullopt;

  DualAntennaPose result;
  result.baseline_error = seen.norm() - baseline;
  const double yaw = angle_difference(direction_of(seen), direction_of(mounted));
  const Eigen::Vector2d lever = 0.5 * (fixes.left.antenna_in_base + fixes.right.antenna_in_base);
  result.pose << 0.5 * (fixes.left.position + fixes.right.position) - rotation(yaw) * lever, yaw;

  // Derivatives to the two positions: of the pose, and of the distance between them.
  const Eigen::RowVector2d along = seen.normalized().transpose();
  const Eigen::RowVector2d turn = across(seen.normalized()).transpose() / baseline;
  Eigen::Matrix<double, 3, 4> J;
  J.bottomRows<1>() << turn, -turn;
  J.topRows<2>() = -rotation(yaw) * across(lever) * J.bottomRows<1>();
  J.topLeftCorner<2, 2>() += 0.5 * Eigen::Matrix2d::Identity();
  J.topRightCorner<2, 2>() += 0.5 * Eigen::Matrix2d::Identity();
  Eigen::RowVector4d stretch;
  stretch << along, -along;
  Eigen::Matrix4d C = Eigen::Matrix4d::Zero();
  C.topLeftCorner<2, 2>() = fixes.left.covariance;
  C.bottomRightCorner<2, 2>() = fixes.right.covariance;

  // Given that the distance is the mounted one; no change where both fixes are equally good all round.
  const double variance = stretch * C * stretch.transpose() + baseline_tolerance * baseline_tolerance;
  const Eigen::Vector3d shared = J * C * stretch.transpose();
  result.pose -= shared * (result.baseline_error / variance);
  result.pose.z() = wrap_angle(result.pose.z());
  result.covariance = J * C * J.transpose() - shared * shared.transpose() / variance;
  result.baseline_nis = result.baseline_error * result.baseline_error / variance;
  return result;
}

void PoseErrorParameters::fields(ParameterVisitor& field) {
  field("mean", mean, {-100.0, 100.0}, "m, m, rad", "east, north, heading, Eq. (11) of [KAM]");
  field("covariance", covariance, {-100.0, 100.0}, "m^2, m rad, rad^2",
        "of east, north, heading, row by row, Eq. (12) of [KAM]");
}

PoseError::PoseError(const PoseErrorParameters& parameters) {
  if (parameters.mean.size() != 3) throw ParameterError("mean of a pose error has not three entries");
  if (parameters.covariance.size() != 9) {
    throw ParameterError("covariance of a pose error has not nine entries");
  }
  mean = Eigen::Vector3d(parameters.mean.data());
  covariance = Eigen::Matrix3d(parameters.covariance.data());
  if (!positive_semi_definite(covariance)) {
    throw ParameterError("covariance of a pose error is not symmetric positive semi-definite");
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  root = axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace multipath_localization
