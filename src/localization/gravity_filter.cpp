#include "multipath_localization/localization/gravity_filter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kGravity = 9.81;       // [m/s^2]
constexpr double kGravityOff = 1.5;     // that a mean may be off, by an accelerometer that is [m/s^2]
constexpr double kTime = 2.0;           // of the mean: longer, and the gyro's bias leans it by degrees [s]
constexpr double kEnough = 1.0;         // of it, before which it does not count [s]
constexpr double kLongestStep = 0.5;    // a gap is no time of acceleration [s]
constexpr double kMostOfDriving = 3.0;  // of a ground robot; odometry in bursts says more [m/s^2]

}  // namespace

void GravityFilter::drive(const OdometryIncrement& motion) {
  const double gain = speed_ ? (motion.speed - *speed_) / motion.duration : 0.0;
  const double curve = motion.speed * motion.yaw_rate;
  motion_ = {std::clamp(gain, -kMostOfDriving, kMostOfDriving),
             std::clamp(curve, -kMostOfDriving, kMostOfDriving), 0.0};
  speed_ = motion.speed;
}

void GravityFilter::add(const InertialSample& sample) {
  const double step = stamp_ ? std::clamp(sample.stamp - *stamp_, 0.0, kLongestStep) : 0.0;
  stamp_ = sample.stamp;
  if (sample.rate) mean_ += step * mean_.cross(*sample.rate);
  if (!sample.acceleration) return;
  time_ = std::min(time_ + step, kTime);
  if (time_ > 0.0) mean_ += std::min(1.0, step / time_) * (*sample.acceleration - motion_ - mean_);
}

std::optional<Eigen::Vector3d> GravityFilter::up() const {
  if (time_ < kEnough || std::abs(mean_.norm() - kGravity) > kGravityOff) return std::nullopt;
  return mean_.normalized();
}

}  // namespace multipath_localization
