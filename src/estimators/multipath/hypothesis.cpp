#include "estimators/multipath/hypothesis.hpp"

#include <Eigen/LU>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr int kOdometryErrors = kSlowX - kScale;
constexpr double kLostHeadingVariance = 0.1;      // [rad^2]
constexpr double kShiftedHeadingVariance = 0.01;  // [rad^2]
constexpr double kRestNoise = 0.003;   // of a gyro at rest with a running engine beside it [rad/sqrt(s)]
constexpr double kImuBiasWalk = 2e-5;  // of a cheap gyro while it warms up [rad/s/sqrt(s)]

}  // namespace

Eigen::Matrix2d Hypothesis::bias_covariance() const {
  return covariance_of_sum(covariance, kSlowX, kShadowX);
}

void Hypothesis::propagate(const OdometrySum& odometry, const OdometryNoise& noise) {
  if (const GyroAtRest& gyro = odometry.gyro_at_rest(); gyro.time > 0.0) {
    observe(*this, kImuBias, gyro.rate(), square(kRestNoise) / gyro.time);
  }
  if (odometry.moving_time() <= 0.0) return;
  const OdometryErrors& at = odometry.errors();
  using Errors = Eigen::Matrix<double, kOdometryErrors, 1>;
  const auto errors =
      (Errors() << at.scale, at.gyro_bias, at.turn_scale, at.curvature, at.imu_bias).finished();
  const Eigen::Vector3d correction = odometry.by_errors() * (mean.segment<kOdometryErrors>(kScale) - errors);
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  turned.topLeftCorner<2, 2>() = rotation(mean(kYaw));
  const Eigen::Vector2d way = turned.topLeftCorner<2, 2>() * (odometry.displacement() + correction.head<2>());
  // Of the pose by heading and errors of the odometry.
  constexpr int kCauses = kOdometryErrors + 1;
  Eigen::Matrix<double, 3, kCauses> J;
  J << Eigen::Vector3d(-way.y(), way.x(), 0.0), turned * odometry.by_errors();

  mean.head<2>() += way;
  mean(kYaw) = wrap_angle(mean(kYaw) + odometry.turn() + correction(2));
  covariance.topRows<3>() += J * covariance.middleRows<kCauses>(kYaw).eval();
  covariance.leftCols<3>() += covariance.middleCols<kCauses>(kYaw).eval() * J.transpose();
  others.cross.topRows<3>() += J * others.cross.middleRows<kCauses>(kYaw).eval();
  Eigen::Matrix3d unsure = odometry.noise().total(law.odometry_noise());
  if (law.blind) unsure += odometry.noise().untold_turns();
  const Eigen::Matrix3d noise_in_map = turned * unsure * turned.transpose();
  covariance.topLeftCorner<3, 3>() += noise_in_map;
  velocity.way_noise += noise_in_map.topLeftCorner<2, 2>();
  const double walk = std::exp(2.0 * law.log_walk) * odometry.moving_time();
  covariance(kScale, kScale) += square(noise.scale_walk) * walk;
  covariance(kGyroBias, kGyroBias) += square(noise.gyro_bias_walk) * walk;
  covariance(kImuBias, kImuBias) += square(kImuBiasWalk) * odometry.moving_time();
}

void Hypothesis::renew_heading(double yaw, double variance) {
  mean(kYaw) = wrap_angle(yaw);
  covariance.row(kYaw).setZero();
  covariance.col(kYaw).setZero();
  covariance(kYaw, kYaw) = variance;
  others.cross.row(kYaw).setZero();
}

void Hypothesis::change_level(FixLevel from, FixLevel to, RandomStream& random) {
  const double slow_before = law.slow_sigma();
  static_cast<FixLaw&>(law) = level_laws.change(from, to, law, random);
  level *= slow_before / law.slow_sigma();
}

void Hypothesis::adopt(const Hypothesis& other) {
  law = other.law;
  level_laws = other.level_laws;
  constexpr int n = kOdometryErrors;
  mean.segment<n>(kScale) = other.mean.segment<n>(kScale);
  covariance.block<n, n>(kScale, kScale) = other.covariance.block<n, n>(kScale, kScale);
}

void Hypothesis::place_at(const GnssFix& fix) {
  const Eigen::Vector2d lever = rotation(mean(kYaw)) * fix.antenna_in_base;
  const Eigen::Vector2d by_yaw(-lever.y(), lever.x());
  const double yaw_variance = covariance(kYaw, kYaw);
  const double slow = square(law.slow_sigma() * level);
  const double shadow = in_shadow ? square(shadow_law.size) : 0.0;
  const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
  mean.head<2>() = fix.position - lever;
  mean.tail<4>().setZero();
  covariance.topRows<2>().setZero();
  covariance.leftCols<2>().setZero();
  covariance.bottomRows<4>().setZero();
  covariance.rightCols<4>().setZero();
  covariance.topLeftCorner<2, 2>() = law.white_variance() * fix.covariance + (slow + shadow) * I +
                                     yaw_variance * by_yaw * by_yaw.transpose();
  covariance.block<2, 1>(kX, kYaw) = -yaw_variance * by_yaw;
  covariance.block<1, 2>(kYaw, kX) = -yaw_variance * by_yaw.transpose();
  covariance.block<2, 2>(kSlowX, kSlowX) = slow * I;
  covariance.block<2, 2>(kX, kSlowX) = covariance.block<2, 2>(kSlowX, kX) = -slow * I;
  covariance.block<2, 2>(kShadowX, kShadowX) = shadow * I;
  covariance.block<2, 2>(kX, kShadowX) = covariance.block<2, 2>(kShadowX, kX) = -shadow * I;
}

void Hypothesis::correct(const GnssFix& fix, const Eigen::Matrix2d& noise) {
  const Eigen::Vector2d lever = rotation(mean(kYaw)) * fix.antenna_in_base;
  const Eigen::Vector2d by_yaw(-lever.y(), lever.x());
  Eigen::Matrix<double, kStateSize, 2> PH =
      covariance.leftCols<2>() + covariance.col(kYaw) * by_yaw.transpose() + covariance.middleCols<2>(kSlowX);
  if (in_shadow) PH += covariance.middleCols<2>(kShadowX);
  Eigen::Matrix2d S = PH.topRows<2>() + by_yaw * PH.row(kYaw) + PH.middleRows<2>(kSlowX) + noise;
  if (in_shadow) S += PH.middleRows<2>(kShadowX);
  Eigen::Vector2d innovation = fix.position - mean.head<2>() - lever - mean.segment<2>(kSlowX);
  if (in_shadow) innovation -= mean.segment<2>(kShadowX);
  const Eigen::Matrix<double, kStateSize, 2> K = PH * S.inverse();
  if (!others.errors.empty()) {
    Eigen::Matrix<double, 2, kStateSize> H = Eigen::Matrix<double, 2, kStateSize>::Zero();
    H.leftCols<2>() = H.middleCols<2>(kSlowX) = Eigen::Matrix2d::Identity();
    H.col(kYaw) = by_yaw;
    if (in_shadow) H.middleCols<2>(kShadowX) = Eigen::Matrix2d::Identity();
    others.correct(H, K, S, innovation);
  }
  mean += K * innovation;
  mean(kYaw) = wrap_angle(mean(kYaw));
  covariance -= K * PH.transpose();
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
}

void observe(Hypothesis& h, StateIndex index, double value, double variance) {
  const State PH = h.covariance.col(index);
  const double S = PH(index) + variance;
  const double innovation = value - h.mean(index);
  h.others.correct(State::Unit(index).transpose(), PH / S, Eigen::Matrix<double, 1, 1>(S),
                   Eigen::Matrix<double, 1, 1>(innovation));
  h.mean += PH * (innovation / S);
  h.mean(kYaw) = wrap_angle(h.mean(kYaw));
  h.covariance -= (PH * PH.transpose() / S).eval();
}

void take_heading(Hypothesis& h, double yaw, double variance, const Eigen::Vector2d& from_start) {
  h.mean.head<2>() += (rotation(yaw) - rotation(h.mean(kYaw))) * from_start;
  h.renew_heading(yaw, variance);
  const Eigen::Vector2d way = rotation(yaw) * from_start;
  const Eigen::Vector2d by_yaw(-way.y(), way.x());
  h.covariance.topLeftCorner<2, 2>() += variance * by_yaw * by_yaw.transpose();
  h.covariance.block<2, 1>(kX, kYaw) = variance * by_yaw;
  h.covariance.block<1, 2>(kYaw, kX) = variance * by_yaw.transpose();
  h.velocity.seeks_course = false;
}

void lose(Hypothesis& h, double variance, RandomStream& random) {
  renew_receivers(h, random);
  h.covariance.topLeftCorner<2, 2>().diagonal().array() += variance;
  if (random.uniform() < 0.5) {
    h.renew_heading(2.0 * kPi * random.uniform(), kLostHeadingVariance);
    h.velocity.seeks_course = true;
  } else {
    h.covariance(kYaw, kYaw) += kShiftedHeadingVariance;
  }
}

void move_by_bias(Hypothesis& h) {
  count_from_fixes(h);
  h.mean.head<2>() += h.mean.segment<2>(kShadowX);
  h.covariance.topRows<2>() += h.covariance.middleRows<2>(kShadowX).eval();
  h.covariance.leftCols<2>() += h.covariance.middleCols<2>(kShadowX).eval();
  h.others.cross.topRows<2>() += h.others.cross.middleRows<2>(kShadowX).eval();
  decay(h, kShadowX, 0.0, 0.0);
}

void decay(Hypothesis& hypothesis, StateIndex first, double keep, double variance) {
  if (keep != 1.0) {
    hypothesis.mean.segment<2>(first) *= keep;
    hypothesis.covariance.middleRows<2>(first) *= keep;
    hypothesis.covariance.middleCols<2>(first) *= keep;
    hypothesis.others.cross.middleRows<2>(first) *= keep;
  }
  hypothesis.covariance(first, first) += variance;
  hypothesis.covariance(first + 1, first + 1) += variance;
}

}  // namespace multipath_localization::multipath
