#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization::multipath {

/// Variance of noise in that which is supposed of it [1].
struct NoiseFactors {
  double way = 1.0;
  double turn = 1.0;  ///< of the wheels
  double gyro = 1.0;
};

/// A step of the odometry without its constant errors, in the base frame at the start of a sum.
struct SummedStep {
  Eigen::Vector2d way = Eigen::Vector2d::Zero();  ///< [m]
  double heading = 0.0;                           ///< halfway through it [rad]
  double turn = 0.0;                              ///< [rad]
  double moved = 0.0;                             ///< time that ends with it in which the wheels turned [s]
  double unseen_way = 0.0;                        ///< by which speed changed anywhere within it [m]
  TurnSource turn_source = TurnSource::kWheels;
  bool told_of_turns = false;  ///< the odometry has told of a turn by now
};

/// The noise of odometry that is summed up, by what it comes from: covariances of x, y, yaw [m, rad] in the
/// base frame at the start of the sum.
class SummedNoise {
 public:
  explicit SummedNoise(const OdometryNoise& noise) : supposed_(noise) {}

  /// Adds the noise of a step, behind that of the steps before, whose headings move its way.
  void add(const SummedStep& step);
  /// Adds that of a stretch in which the base may have got anywhere within a radius [m].
  void add_gap(double radius);

  /// Where the noises have that many times the variance supposed; what happened between samples comes on top.
  [[nodiscard]] Eigen::Matrix3d total(const NoiseFactors& factors) const {
    return factors.way * way_ + factors.turn * turn_ + factors.gyro * gyro_ + sampling_;
  }
  /// The same where the odometry tells of no turns at all: none besides, once it has told of one.
  [[nodiscard]] const Eigen::Matrix3d& untold_turns() const { return untold_turns_; }

 private:
  void carry(const Eigen::Vector2d& way);
  void add_way(const Eigen::Vector2d& way);
  void add_turn(const SummedStep& step);
  void add_sampling(const SummedStep& step);

  OdometryNoise supposed_;
  Eigen::Matrix3d way_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d gyro_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d sampling_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d untold_turns_ = Eigen::Matrix3d::Zero();
};

}  // namespace multipath_localization::multipath
