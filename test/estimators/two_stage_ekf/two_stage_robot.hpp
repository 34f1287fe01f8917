#pragma once

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdint>

#include "estimators/two_stage_ekf/two_stage_ekf.hpp"
#include "matched_robot.hpp"

namespace multipath_localization {

inline const Eigen::Vector2d kBias(4.0, -3.0);

inline MatchedRobot robot_of(const TwoStageEkfParameters& parameters, std::uint64_t seed) {
  return {parameters.odometry, seed};
}

inline Eigen::Vector2d error(const Estimator& filter, const MatchedRobot& robot) {
  return filter.estimate().pose.position() - robot.truth.position();
}

inline double nees(const Estimator& filter, const MatchedRobot& robot) {
  const Eigen::Vector2d e = error(filter, robot);
  return e.dot(filter.estimate().position_covariance_overall.inverse() * e);
}

inline double sigma(const Estimator& filter) {
  return std::sqrt(0.5 * filter.estimate().position_covariance_overall.trace());
}

inline bool in_fault(const Estimator& filter) { return filter.estimate().shadow_probability == 1.0; }

/// Drives a filter that knows its start for a minute under open sky.
inline void settle(Estimator& filter, MatchedRobot& robot) {
  filter.start(prior_at(robot.truth));
  robot.run(filter, 60.0);
}

inline void expect_same(const PoseEstimate& a, const PoseEstimate& b, double tolerance) {
  EXPECT_EQ(a.valid, b.valid);
  EXPECT_EQ(a.aligned, b.aligned);
  EXPECT_NEAR(a.pose.x, b.pose.x, tolerance);
  EXPECT_NEAR(a.pose.y, b.pose.y, tolerance);
  EXPECT_NEAR(angle_difference(a.pose.yaw, b.pose.yaw), 0.0, tolerance);
  EXPECT_LT((a.covariance - b.covariance).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT((a.bias - b.bias).norm(), tolerance);
  EXPECT_LT((a.bias_covariance - b.bias_covariance).cwiseAbs().maxCoeff(), tolerance);
}

}  // namespace multipath_localization
