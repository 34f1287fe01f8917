#pragma once

#include <Eigen/Core>
#include <cmath>

#include "multipath_localization/core/pose.hpp"
#include "simd/block.hpp"
#include "simd/elementary.hpp"
#include "simd/instruction_set.hpp"

namespace multipath_localization {

/// Poses within `distance` [m] and `turn` [rad] of a centre.
struct PoseNeighbourhood {
  Pose2 centre;
  double distance = 0.0;
  double turn = 0.0;
};

/// 1 for a pose within the neighbourhood, else 0; without a branch, for loops that are vectorised.
inline double membership(const PoseNeighbourhood& within, double x, double y, double yaw) {
  const double dx = x - within.centre.x;
  const double dy = y - within.centre.y;
  const double turn = std::abs(elementary::wrap(yaw - within.centre.yaw));
  const double near = dx * dx + dy * dy <= within.distance * within.distance ? 1.0 : 0.0;
  return turn <= within.turn ? near : 0.0;
}

/// `member` becomes 1 for those of a block within the neighbourhood, 0 for the others.
void mark_members(InstructionSet set, const PoseBlock& poses, const PoseNeighbourhood& within, float* member);

/// Weighted sums over poses, relative to a reference; add up over blocks.
struct PoseSums {
  /// Of 1, x, y, x x, x y, y y over all particles.
  struct All {
    double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  } all;
  /// Over members, the same and with d the wrapped difference of yaw to the reference: d, cos d, sin d, x d,
  /// y d, d d.
  struct Members {
    double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    double d = 0.0, c = 0.0, s = 0.0, xd = 0.0, yd = 0.0, dd = 0.0;
  } members;

  /// Adds `scale` times the sums of another.
  void add(double scale, const PoseSums& other);
};

/// The sums of one block.
PoseSums pose_sums(InstructionSet set, const PoseBlock& poses, const double* weight, const float* member,
                   const Pose2& reference);

/// Mean and covariance (x, y, yaw) of weighted poses. The yaw is the circular mean and deviations from it are
/// wrapped, so that neither depends on where the circle is cut.
struct PoseMoments {
  Pose2 mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Eq. (35) of [NIS] over the members, and its covariance. Exact for members that lie within half a turn of
/// both the reference and the mean.
PoseMoments member_moments(const PoseSums& sums, const Pose2& reference);

/// Mean square deviation of all positions from `centre` [m^2].
Eigen::Matrix2d position_spread(const PoseSums& sums, const Pose2& reference, const Eigen::Vector2d& centre);

}  // namespace multipath_localization
