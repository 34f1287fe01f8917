#include "multipath_localization/core/fix_check.hpp"

#include <cmath>

#include "multipath_localization/core/covariance.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kLargest = 1e8;

bool valid_covariance(const Eigen::Matrix2d& covariance) {
  return covariance.cwiseAbs().maxCoeff() < kLargest && positive_semi_definite(covariance);
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
  const Eigen::Vector3d pose(prior.pose.x, prior.pose.y, prior.pose.yaw);
  return std::isfinite(prior.stamp) && pose.allFinite() && pose.cwiseAbs().maxCoeff() <= kFurthestPose &&
         prior.covariance.allFinite() && prior.covariance.cwiseAbs().maxCoeff() <= square(kFurthestPose) &&
         prior.covariance.diagonal().minCoeff() > 0.0 && positive_semi_definite(prior.covariance);
}

bool usable(const OdometryIncrement& u) {
  return std::isfinite(u.stamp) && std::isfinite(u.speed) && std::isfinite(u.yaw_rate) &&
         std::isfinite(u.lateral_speed) && std::isfinite(u.duration) && u.duration > 0.0;
}

std::optional<Reason> FixCheck::defect(const GnssFix& fix) {
  if (const auto found = multipath_localization::defect(fix)) return found;
  if (last_position_ == fix.position) return Reason::kFrozen;
  last_position_ = fix.position;
  return std::nullopt;
}

}  // namespace multipath_localization
