#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/pose.hpp"

namespace multipath_localization::multipath {

/// The state of a hypothesis, equation (1): pose, errors of the odometry, slow error and shadow bias of the
/// fixes of the receiver that is attended to.
enum StateIndex {
  kX,
  kY,
  kYaw,
  kScale,
  kGyroBias,
  kTurnScale,
  kCurvature,
  kImuBias,
  kSlowX,
  kSlowY,
  kShadowX,
  kShadowY,
  kStateSize
};
/// Those of a receiver are the last ones.
constexpr int kReceiverStates = kStateSize - kSlowX;
using State = Eigen::Matrix<double, kStateSize, 1>;
using StateCovariance = Eigen::Matrix<double, kStateSize, kStateSize>;

/// Of two components from `one` on plus two from `other` on.
template <class Covariance>
Eigen::Matrix2d covariance_of_sum(const Covariance& P, Eigen::Index one, Eigen::Index other) {
  const Eigen::Matrix2d across = P.template block<2, 2>(one, other);
  return P.template block<2, 2>(one, one) + P.template block<2, 2>(other, other) + across +
         across.transpose();
}

/// Of the base in map.
inline Pose2 pose_of(const State& state) { return {state(kX), state(kY), state(kYaw)}; }

}  // namespace multipath_localization::multipath
