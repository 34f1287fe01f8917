#pragma once

#include <Eigen/Core>
#include <optional>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What makes a fix unusable whatever the estimator, or nothing:
/// - kNotFinite: NaN or infinity in stamp, position, covariance or lever arm;
/// - kInvalidPosition: position or lever arm of 1e8 m or more in some coordinate;
/// - kInvalidCovariance: declared covariance with a negative variance, asymmetric, indefinite (each beyond
/// rounding)
///   or 1e8 m^2 or more. All zeros are valid: the receiver declares nothing.
std::optional<Reason> defect(const GnssFix& fix);

/// False for a prior with anything not finite, a variance that is not positive or a covariance that is not
/// symmetric.
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
