#include "multipath_localization/estimators/fix_check.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kLargest = 1e8;
constexpr double kRounding = 1e-6;

bool valid_covariance(const Eigen::Matrix2d& covariance) {
  const double scale = covariance.cwiseAbs().maxCoeff();
  if (scale >= kLargest) return false;
  const double slack = kRounding * scale;
  const double correlated = 0.5 * (covariance(0, 1) + covariance(1, 0));
  return covariance(0, 0) >= 0.0 && covariance(1, 1) >= 0.0 &&
         std::abs(covariance(0, 1) - covariance(1, 0)) <= slack &&
         correlated * correlated <= covariance(0, 0) * covariance(1, 1) + slack * scale;
}

}  // namespace

std::optional<Reason> defect(const GnssFix& fix) {
  if (!std::isfinite(fix.stamp) || !fix.position.allFinite() || !fix.covariance.allFinite() ||
      !fix.antenna_in_base.allFinite()) {
    return Reason::kNotFinite;
  }
  if (fix.position.cwiseAbs().maxCoeff() >= kLargest ||
      fix.antenna_in_base.cwiseAbs().maxCoeff() >= kLargest) {
    return Reason::kInvalidPosition;
  }
  if (!valid_covariance(fix.covariance)) return Reason::kInvalidCovariance;
  return std::nullopt;
}

bool usable(const PosePrior& prior) {
  return std::isfinite(prior.stamp) && prior.pose.finite() && prior.covariance.allFinite() &&
         prior.covariance.diagonal().minCoeff() > 0.0 &&
         prior.covariance.isApprox(prior.covariance.transpose(), kRounding);
}

bool usable(const OdometryIncrement& u) {
  return std::isfinite(u.stamp) && std::isfinite(u.speed) && std::isfinite(u.yaw_rate) &&
         std::isfinite(u.duration) && u.duration > 0.0;
}

std::optional<Reason> FixCheck::defect(const GnssFix& fix) {
  if (const auto found = multipath_localization::defect(fix)) return found;
  if (last_position_ == fix.position) return Reason::kFrozen;
  last_position_ = fix.position;
  return std::nullopt;
}

}  // namespace multipath_localization
