#pragma once

#include <Eigen/Core>
#include <limits>
#include <string_view>
#include <vector>

#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// How one pose is made of weighted particles, as a parameter `point_estimate` says.
enum class PointEstimate { kCluster, kMean };

/// Why a measurement was used or not. Published as is in FixReport.
enum class Reason {
  kAccepted,
  kUnused,             ///< a kind of measurement this estimator has no model for
  kNotNeeded,          ///< a kind that stands by for a better one, which is there
  kNotFinite,          ///< NaN or infinity in a field that counts
  kInvalidCovariance,  ///< declared covariance negative or not symmetric positive semi-definite
  kInvalidPosition,    ///< latitude or longitude out of range, or further from the datum than the map reaches
  kInvalidOrientation,  ///< quaternion not of length 1, or none where a heading is needed
  kNoFix,               ///< receiver status below the one asked for
  kFrozen,              ///< bit-identical to the fix before, though the robot has driven on
  kRepeated,            ///< bit-identical to the fix before, of a robot that stands or hardly moves
  kGated,               ///< innovation beyond the gate
  kZeroStamp,           ///< stamp of zero
  kFutureStamp,         ///< stamp ahead of the odometry by more than the tolerance
  kOldStamp,            ///< stamp older than the odometry history reaches
  kNotStarted,          ///< no odometry yet
  kInvalidFrame,        ///< frame unknown to tf, or not one this input may have
  kTooFast,             ///< speed or yaw rate no robot of this kind reaches
  kTooFewSatellites,    ///< no usable observation, or too few for what the estimator needs
  kWrongBaseline,       ///< two antennas seen at another distance than they are mounted at
  kTooManySatellites,   ///< more than any receiver tracks
  kUnpaired,            ///< a fix of one of two antennas without one of the other at its time
  kOverload,            ///< not weighed, because the computer does not keep up
};

/// "accepted", "not finite", ...: one stable text per reason.
std::string_view to_string(Reason reason);

/// Outcome of one update.
struct Innovation {
  Reason reason = Reason::kUnused;
  Eigen::Vector2d innovation = Eigen::Vector2d::Zero();  ///< measured - predicted antenna, map frame [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< predicted covariance S of it [m^2]
  double nis = 0.0;  ///< normalised innovation squared; dof: 2 of a fix, 3 of a pair

  [[nodiscard]] bool accepted() const { return reason == Reason::kAccepted; }
};

/// Whether it is the measurement's own fault that it was not used.
inline bool is_fault(Reason reason) {
  return reason != Reason::kAccepted && reason != Reason::kUnused && reason != Reason::kNotNeeded &&
         reason != Reason::kRepeated && reason != Reason::kOverload;
}

inline Innovation refused(Reason reason) {
  Innovation innovation;
  innovation.reason = reason;
  return innovation;
}

/// What an estimator knows of the fixes of one receiver.
struct ReceiverEstimate {
  std::size_t receiver = 0;                        ///< as GnssFix has it
  double shadow_probability = 0.0;                 ///< of its fixes being biased
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();  ///< of a fix [m]
};

/// What an estimator knows. Everything in the map frame.
struct PoseEstimate {
  bool valid = false;    ///< false until something was measured; nothing below counts then
  bool aligned = false;  ///< heading and position are settled on one hypothesis and confirmed
  /// Driving under open sky that is still wanted for that, at least [m]; NaN: not told.
  double way_to_alignment = std::numeric_limits<double>::quiet_NaN();
  double stamp = 0.0;  ///< [s]
  Pose2 pose;          ///< base in map: mean of the dominant cluster, never a mean between clusters
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of x, y, yaw within the cluster [m, rad]
  double dominance = 1.0;                                    ///< probability mass of the dominant cluster
  Eigen::Matrix2d position_covariance_overall =
      Eigen::Matrix2d::Identity();  ///< all clusters, about `pose` [m^2]
  double shadow_probability = 0.0;  ///< of the mode "fixes are biased", of several receivers those of all
  double wheel_fault_probability = 0.0;            ///< of odometry that says nothing
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();  ///< of the fix, of several receivers of the first one [m]
  Eigen::Matrix2d bias_covariance = Eigen::Matrix2d::Zero();  ///< [m^2]
  std::vector<ReceiverEstimate> receivers;                    ///< by number; empty where there is but one
  double effective_sample_size = 1.0;

  /// Of a fix of that receiver [m].
  [[nodiscard]] Eigen::Vector2d bias_of(std::size_t receiver) const;
};

/// Covariance of x, y, yaw [m, rad] that goes with `pose` where clusters are not told apart: in position as
/// wide as all clusters in every direction, in heading and its correlations that of the dominant one.
/// Positive semidefinite as `covariance` is, which the two put together would not always be.
Eigen::Matrix3d covariance_overall(const PoseEstimate& estimate);

/// Which kind of hypothesis a particle is, for colouring.
enum class Mode { kOpen, kShadow };

/// One weighted hypothesis of the base's pose in map.
struct Hypothesis {
  Pose2 pose;
  double weight = 1.0;  ///< all weights of a cloud sum to 1
  Mode mode = Mode::kOpen;
};

/// Where to start from: a pose and its covariance of x, y, yaw [m, rad].
struct PosePrior {
  double stamp = 0.0;
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  bool confirmed = false;  ///< by an estimator that went before: it need not be doubted
};

}  // namespace multipath_localization
