#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/filters/kalman.hpp"

namespace multipath_localization {

/// What a bag is asked for. Of a fix, each component.
struct SensorNoise {
  double distance = 0.006;    ///< of odometry, while moving [m/sqrt(m)]
  double yaw = 0.003;         ///< of odometry, while moving [rad/sqrt(s)]
  double white = 0.3;         ///< of a fix, new with each [m]
  double wander = 0.3;        ///< of the fixes' slow error, first-order Gauss-Markov [m]
  double wander_time = 20.0;  ///< its correlation time [s]
};

/// A constant of the odometry as the whole drive has it, with its standard deviation.
struct FittedConstant {
  double value = 0.0;
  double sigma = 0.0;
};

/// How well a noise explains a drive.
struct Explanation {
  double log_likelihood = 0.0;  ///< of all fixes, each given those before it
  FittedConstant scale;         ///< measured speed over true speed, less 1
  FittedConstant gyro_bias;     ///< [rad/s]
};

/// Fixes of a drive with the odometry between them, summed up once for all noises that are tried.
///
/// A Kalman filter over x, y, yaw, speed scale, gyro bias and the fixes' slow error gives the likelihood of
/// the fixes: noise of the odometry makes errors that grow with the way, a slow error of the fixes ones that
/// stay bounded, a white one does not last. That tells them apart, and in places without fixes odometry is
/// asked how far it got.
class FixSequence {
 public:
  /// `delay`: a fix is of where the robot was that much before its stamp [s]. Fixes outside of the odometry,
  /// which is to be settled, are left out.
  FixSequence(const std::vector<OdometryIncrement>& odometry, const std::vector<GnssFix>& fixes,
              double delay);

  [[nodiscard]] Explanation explain(const SensorNoise& noise) const {
    return explain(noise, start_yaw_, legs_.size());
  }
  [[nodiscard]] std::size_t size() const { return legs_.size(); }    ///< fixes
  [[nodiscard]] double way() const { return way_; }                  ///< driven, forwards or in reverse [m]
  [[nodiscard]] double moving_time() const { return moving_time_; }  ///< [s]

 private:
  enum Index : int { kX, kY, kYaw, kScale, kGyroBias, kEast, kNorth, kSize };
  using Belief = Gaussian<kSize>;

  /// Odometry since the fix before, in the base frame at that fix, and the fix at its end.
  struct Leg {
    double duration = 0.0;
    double moving_time = 0.0;
    double turn = 0.0;
    Eigen::Vector2d displacement = Eigen::Vector2d::Zero();
    Eigen::Vector2d by_scale = Eigen::Vector2d::Zero();
    Eigen::Vector2d by_gyro_bias = Eigen::Vector2d::Zero();
    Eigen::Matrix3d by_distance_noise = Eigen::Matrix3d::Zero();  ///< covariance for a noise of 1
    Eigen::Matrix3d by_yaw_noise = Eigen::Matrix3d::Zero();       ///< likewise
    GnssFix fix;
  };

  [[nodiscard]] Explanation explain(const SensorNoise& noise, double start_yaw, std::size_t legs) const;
  [[nodiscard]] Belief start(const SensorNoise& noise, double yaw) const;
  static void predict(Belief& belief, const Leg& leg, const SensorNoise& noise);
  /// Log likelihood of the fix; an outlier changes no belief.
  static double correct(Belief& belief, const Leg& leg, const SensorNoise& noise);
  [[nodiscard]] double likeliest_start_yaw() const;

  std::vector<Leg> legs_;
  double start_yaw_ = 0.0;
  double way_ = 0.0;
  double moving_time_ = 0.0;
};

}  // namespace multipath_localization
