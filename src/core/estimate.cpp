#include "multipath_localization/core/estimate.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/core/trust.hpp"

namespace multipath_localization {

std::string_view to_string(Reason reason) {
  switch (reason) {
    case Reason::kAccepted: return "accepted";
    case Reason::kUnused: return "unused";
    case Reason::kNotNeeded: return "not needed";
    case Reason::kNotFinite: return "not finite";
    case Reason::kInvalidCovariance: return "invalid covariance";
    case Reason::kInvalidPosition: return "invalid position";
    case Reason::kInvalidOrientation: return "invalid orientation";
    case Reason::kNoFix: return "no fix";
    case Reason::kFrozen: return "frozen";
    case Reason::kRepeated: return "repeated";
    case Reason::kGated: return "gated";
    case Reason::kZeroStamp: return "zero stamp";
    case Reason::kFutureStamp: return "future stamp";
    case Reason::kOldStamp: return "old stamp";
    case Reason::kNotStarted: return "not started";
    case Reason::kInvalidFrame: return "invalid frame";
    case Reason::kTooFast: return "too fast";
    case Reason::kTooFewSatellites: return "too few satellites";
    case Reason::kWrongBaseline: return "wrong baseline";
    case Reason::kTooManySatellites: return "too many satellites";
    case Reason::kUnpaired: return "unpaired";
    case Reason::kOverload: return "overload";
  }
  return "unknown";
}

Eigen::Vector2d PoseEstimate::bias_of(std::size_t receiver) const {
  for (const ReceiverEstimate& known : receivers) {
    if (known.receiver == receiver) return known.bias;
  }
  return bias;
}

Eigen::Matrix3d covariance_overall(const PoseEstimate& estimate) {
  Eigen::Matrix3d covariance = symmetric<3>(estimate.covariance);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> wider;
  wider.computeDirect(estimate.position_covariance_overall - covariance.topLeftCorner<2, 2>());
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d axis =
        std::sqrt(std::max(0.0, wider.eigenvalues()(i))) * wider.eigenvectors().col(i);
    covariance.topLeftCorner<2, 2>() += axis * axis.transpose();
  }
  return covariance;
}

std::string_view to_string(Trust state) {
  switch (state) {
    case Trust::kNotReady: return "NOT_READY";
    case Trust::kAligning: return "ALIGNING";
    case Trust::kGood: return "GOOD";
    case Trust::kMultipath: return "MULTIPATH";
    case Trust::kDeadReckoning: return "DEAD_RECKONING";
    case Trust::kLost: return "LOST";
  }
  return "unknown";
}

}  // namespace multipath_localization
