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

/// Of the base in map.
inline Pose2 pose_of(const State& state) { return {state(kX), state(kY), state(kYaw)}; }

}  // namespace multipath_localization::multipath
