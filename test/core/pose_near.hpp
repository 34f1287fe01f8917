#pragma once

#include <gtest/gtest.h>

#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Succeeds when two poses agree within `tolerance`, in metres and radians, yaws compared on the circle.
inline testing::AssertionResult PoseNear(const Pose2& actual, const Pose2& expected, double tolerance) {
  const double yaw_error = std::abs(angle_difference(actual.yaw, expected.yaw));
  if ((actual.position() - expected.position()).norm() <= tolerance && yaw_error <= tolerance) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "(" << actual.x << ", " << actual.y << ", " << actual.yaw
                                     << ") is not (" << expected.x << ", " << expected.y << ", "
                                     << expected.yaw << ")";
}

}  // namespace multipath_localization
