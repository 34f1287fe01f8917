#include "multipath_localization/models/gnss_position.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

/// log(e^a + e^b), either may be minus infinity.
double log_sum(double a, double b) {
  const double larger = std::max(a, b);
  return std::isfinite(larger) ? larger + std::log1p(std::exp(std::min(a, b) - larger)) : larger;
}

/// log of 1 / (2 pi sigma^2) exp(-d^2 / (2 sigma^2)), the kernel of Eqs. (27), (31).
double log_kernel(double squared_distance, double sigma) {
  return -0.5 * squared_distance / (sigma * sigma) - std::log(2.0 * kPi * sigma * sigma);
}

double declared_sigma(const Eigen::Matrix2d& declared) { return std::sqrt(0.5 * declared.trace()); }

}  // namespace

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

void GnssLikelihoodParameters::fields(ParameterVisitor& field) {
  field("sigma_b", sigma_b, {1e-3, 1e3}, "m", "of a fix by direct signals, Eq. (27)");
  field("sigma_s", sigma_s, {1e-3, 1e3}, "m", "of a fix in shadow about its bias, Eqs. (18), (31)");
  field("sigma_p", sigma_p, {1e-3, kPi}, "rad", "of the heading from two positions, Eqs. (27), (31)");
  field("use_declared_covariance", use_declared_covariance,
        "raise sigma_b and sigma_s to what the receiver declares; false as printed");
  field("likelihood_kernel", likelihood_kernel, {"product", "cross"},
        "position term of Eq. (27): product = exp(-dx^2 ..) exp(-dy^2 ..); cross = their sum, as printed");
}

GnssLikelihood::GnssLikelihood(const GnssLikelihoodParameters& parameters, const Eigen::Matrix2d& declared,
                               double shadow_weight, double ring_radius)
    : cross_(parameters.likelihood_kernel == "cross"),
      sigma_b_(parameters.sigma_b),
      sigma_s_(parameters.sigma_s),
      sigma_p_(parameters.sigma_p),
      ring_radius_(ring_radius),
      log_direct_weight_(std::log(1.0 - shadow_weight)),
      log_shadow_weight_(std::log(shadow_weight)) {
  if (!parameters.use_declared_covariance) return;
  sigma_b_ = std::max(sigma_b_, declared_sigma(declared));
  sigma_s_ = std::max(sigma_s_, declared_sigma(declared));
}

double GnssLikelihood::log_position_direct(const Eigen::Vector2d& error) const {
  if (!cross_) return log_kernel(error.squaredNorm(), sigma_b_);
  return log_sum(log_kernel(error.x() * error.x(), sigma_b_), log_kernel(error.y() * error.y(), sigma_b_));
}

double GnssLikelihood::log_position_shadow(const Eigen::Vector2d& error) const {
  const double from_ring = error.norm() - ring_radius_;
  return log_kernel(from_ring * from_ring, sigma_s_);
}

GnssLikelihood::Value GnssLikelihood::operator()(const Eigen::Vector2d& error,
                                                 const std::optional<double>& heading_error) const {
  double direct = log_position_direct(error);
  double shadow = log_position_shadow(error);
  if (heading_error) {
    const double heading = log_kernel(*heading_error * *heading_error, sigma_p_) - std::log(3.0);
    direct = log_sum(direct + std::log(2.0 / 3.0), heading);
    shadow = log_sum(shadow + std::log(2.0 / 3.0), heading);
  }
  direct += log_direct_weight_;
  shadow += log_shadow_weight_;
  Value value;
  value.log_likelihood = log_sum(direct, shadow);
  value.shadow_share = std::exp(shadow - value.log_likelihood);
  return value;
}

}  // namespace multipath_localization
