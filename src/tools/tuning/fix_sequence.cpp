#include "tools/tuning/fix_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {

namespace {

constexpr double kScaleSigma = 0.1;      // of an odometer nobody has calibrated [1]
constexpr double kGyroBiasSigma = 0.05;  // likewise [rad/s]
constexpr int kStartYaws = 64;           // tried round the circle
constexpr double kStartYawSigma = 0.06;  // of the one nearest [rad]
constexpr double kStartWay = 30.0;       // over which the start's heading is told [m]
constexpr double kOutlierShare = 0.01;   // of the fixes
constexpr double kOutlierSigma = 15.0;   // [m]

OdometryNoise only(double distance, double yaw) {
  OdometryNoise noise;
  noise.distance = distance;
  noise.yaw = yaw;
  return noise;
}

/// Odometry summed up between two times, for a noise of 1 of either kind.
struct Sum {
  PreintegratedOdometry distance{only(1.0, 0.0)};
  PreintegratedOdometry yaw{only(0.0, 1.0)};

  void add(OdometryIncrement increment, double duration) {
    if (duration <= 0.0) return;
    increment.duration = duration;
    distance.add(increment);
    yaw.add(increment);
  }
};

Eigen::Vector2d turned_left(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

FixSequence::FixSequence(const std::vector<OdometryIncrement>& odometry, const std::vector<GnssFix>& fixes,
                         double delay) {
  if (odometry.empty()) return;
  std::size_t next = 0;
  double now = odometry.front().stamp - odometry.front().duration;
  Sum sum;
  for (const GnssFix& fix : fixes) {
    const double then = fix.stamp - delay;
    if (then < now || then > odometry.back().stamp) continue;
    for (; next < odometry.size() && now < then; next += odometry[next].stamp <= then ? 1 : 0) {
      const double end = std::min(odometry[next].stamp, then);
      const double duration = std::min(end - now, odometry[next].duration);
      sum.add(odometry[next], duration);
      if (!standing(odometry[next])) {
        way_ += ground_speed(odometry[next]) * duration;
        moving_time_ += duration;
      }
      now = end;
    }
    legs_.push_back({sum.yaw.duration(), sum.yaw.moving_time(), sum.yaw.turn(0.0),
                     sum.yaw.displacement(0.0, 0.0), sum.yaw.by_scale(), sum.yaw.by_gyro_bias(),
                     sum.distance.covariance(), sum.yaw.covariance(), fix});
    sum = Sum();
  }
  start_yaw_ = likeliest_start_yaw();
}

double FixSequence::likeliest_start_yaw() const {
  std::size_t few = 0;
  for (double way = 0.0; few < legs_.size() && way < kStartWay; ++few) way += legs_[few].displacement.norm();
  double best = -std::numeric_limits<double>::infinity(), yaw = 0.0;
  for (int i = 0; i < kStartYaws; ++i) {
    const double tried = 2.0 * kPi * i / kStartYaws;
    const double likelihood = explain({}, tried, few).log_likelihood;
    if (likelihood > best) best = likelihood, yaw = tried;
  }
  return yaw;
}

FixSequence::Belief FixSequence::start(const SensorNoise& noise, double yaw) const {
  const GnssFix& fix = legs_.front().fix;
  Belief belief;
  belief.mean.head<2>() = fix.position - rotation(yaw) * fix.antenna_in_base;
  belief.mean[kYaw] = yaw;
  belief.covariance.setZero();
  const double bias = noise.wander * noise.wander;
  const double position = bias + noise.white * noise.white;
  belief.covariance.diagonal() << position, position, kStartYawSigma * kStartYawSigma,
      kScaleSigma * kScaleSigma, kGyroBiasSigma * kGyroBiasSigma, bias, bias;
  belief.covariance.block<2, 2>(kX, kEast) = -bias * Eigen::Matrix2d::Identity();
  belief.covariance.block<2, 2>(kEast, kX) = -bias * Eigen::Matrix2d::Identity();
  return belief;
}

Explanation FixSequence::explain(const SensorNoise& noise, double start_yaw, std::size_t legs) const {
  Explanation result;
  if (legs_.empty()) return result;
  Belief belief = start(noise, start_yaw);
  for (std::size_t i = 1; i < legs; ++i) {
    predict(belief, legs_[i], noise);
    result.log_likelihood += correct(belief, legs_[i], noise);
  }
  result.scale = {belief.mean[kScale], std::sqrt(belief.covariance(kScale, kScale))};
  result.gyro_bias = {belief.mean[kGyroBias], std::sqrt(belief.covariance(kGyroBias, kGyroBias))};
  return result;
}

void FixSequence::predict(Belief& belief, const Leg& leg, const SensorNoise& noise) {
  const double scale = belief.mean[kScale], gyro_bias = belief.mean[kGyroBias];
  const Eigen::Matrix2d R = rotation(belief.mean[kYaw]);
  const Eigen::Vector2d moved = R * (leg.displacement + leg.by_scale * scale + leg.by_gyro_bias * gyro_bias);
  const double kept = std::exp(-leg.duration / noise.wander_time);

  Eigen::Matrix<double, kSize, kSize> F = Eigen::Matrix<double, kSize, kSize>::Identity();
  F.block<2, 1>(kX, kYaw) = turned_left(moved);
  F.block<2, 1>(kX, kScale) = R * leg.by_scale;
  F.block<2, 1>(kX, kGyroBias) = R * leg.by_gyro_bias;
  F(kYaw, kGyroBias) = -leg.moving_time;
  F(kEast, kEast) = F(kNorth, kNorth) = kept;

  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = R;
  const OdometryNoise usual;
  Eigen::Matrix<double, kSize, kSize> Q = Eigen::Matrix<double, kSize, kSize>::Zero();
  Q.topLeftCorner<3, 3>() =
      turn *
      (noise.distance * noise.distance * leg.by_distance_noise + noise.yaw * noise.yaw * leg.by_yaw_noise) *
      turn.transpose();
  Q(kScale, kScale) = usual.scale_walk * usual.scale_walk * leg.moving_time;
  Q(kGyroBias, kGyroBias) = usual.gyro_bias_walk * usual.gyro_bias_walk * leg.moving_time;
  Q(kEast, kEast) = Q(kNorth, kNorth) = (1.0 - kept * kept) * noise.wander * noise.wander;

  Eigen::Matrix<double, kSize, 1> mean = belief.mean;
  mean.head<2>() += moved;
  mean[kYaw] += leg.turn - leg.moving_time * gyro_bias;
  mean.tail<2>() *= kept;
  kalman::predict<kSize>(belief, mean, F, Q);
}

double FixSequence::correct(Belief& belief, const Leg& leg, const SensorNoise& noise) {
  const Eigen::Vector2d arm = rotation(belief.mean[kYaw]) * leg.fix.antenna_in_base;
  Eigen::Matrix<double, 2, kSize> H = Eigen::Matrix<double, 2, kSize>::Zero();
  H.block<2, 2>(0, kX).setIdentity();
  H.block<2, 2>(0, kEast).setIdentity();
  H.col(kYaw) = turned_left(arm);
  const Eigen::Vector2d y = leg.fix.position - belief.mean.head<2>() - belief.mean.tail<2>() - arm;
  const Eigen::Matrix2d R = noise.white * noise.white * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d far = kOutlierSigma * kOutlierSigma * Eigen::Matrix2d::Identity();

  const double regular =
      std::log(1.0 - kOutlierShare) + kalman::compare<kSize, 2>(belief, y, H, R).log_likelihood;
  const double outlier =
      std::log(kOutlierShare) + kalman::compare<kSize, 2>(belief, y, H, R + far).log_likelihood;
  if (regular >= outlier) kalman::correct<kSize, 2>(belief, y, H, R);
  const double larger = std::max(regular, outlier);
  return larger + std::log1p(std::exp(std::min(regular, outlier) - larger));
}

}  // namespace multipath_localization
