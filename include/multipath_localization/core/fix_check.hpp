#pragma once

#include <Eigen/Core>
#include <optional>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What makes a fix unusable whatever the estimator, or nothing:
/// - kNotFinite: NaN or infinity in stamp, position, covariance or lever arm;
/// - kInvalidPosition: position or lever arm of 1e8 m or more in some coordinate;
/// - kInvalidCovariance: declared covariance that is not positive semi-definite, or 1e8 m^2 or more. All
///   zeros are valid: the receiver declares nothing.
std::optional<Reason> defect(const GnssFix& fix);

/// Whether an estimator can start from it: all is finite, the pose up to kFurthestPose (m, rad), variances
/// are above zero and up to the square of that, and the covariance is positive semi-definite.
bool usable(const PosePrior& prior);

/// False for an increment with anything not finite or a duration that is not positive.
bool usable(const OdometryIncrement& u);

/// `defect` with a memory of one fix, to tell a receiver that has frozen.
class FixCheck {
 public:
  /// The defect of this fix, kFrozen when its position is bit-identical to that of the sound fix before, or
  /// nothing.
  std::optional<Reason> defect(const GnssFix& fix);

  void forget() { last_position_.reset(); }

 private:
  std::optional<Eigen::Vector2d> last_position_;
};

}  // namespace multipath_localization
