#include "estimators/ekf/chord_alignment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/models/fix/gnss_position.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

using odometry_state::kGyroBias;
using odometry_state::kYaw;

constexpr double kWidestPriorYaw = 1.0;  ///< a wider one counts as unknown [rad]
constexpr double kChordMismatchSigmas = 3.0;
constexpr double kChordMismatchShare = 0.1;

double angle_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

}  // namespace

void ChordAlignmentParameters::fields(ParameterVisitor& field) {
  field("alignment_distance", alignment_distance, {0.1, 1e3}, "m",
        "least chord driven before the heading is taken from it");
  field("alignment_yaw_sigma", alignment_yaw_sigma, {0.01, 1.0}, "rad",
        "largest standard deviation of a heading that counts as aligned; noisy fixes make the chord longer");
}

ChordAlignment::ChordAlignment(const ChordAlignmentParameters& parameters, const OdometryNoise& noise)
    : parameters_(parameters), noise_(noise) {
  start(std::nullopt);
}

void ChordAlignment::start(const std::optional<PosePrior>& prior) {
  state_ = State{odometry_state::Vector::Zero(), odometry_state::unknown_covariance(noise_)};
  base_in_odom_ = Pose2{};
  moving_time_ = 0.0;
  anchor_.reset();
  missing_ = parameters_.alignment_distance;
  started_ = aligned_ = false;
  if (!prior || !usable(*prior)) return;
  state_.mean.head<3>() << prior->pose.x, prior->pose.y, wrap_angle(prior->pose.yaw);
  state_.covariance.topLeftCorner<3, 3>() = prior->covariance;
  started_ = true;
  aligned_ = prior->covariance(2, 2) <= square(kWidestPriorYaw);
  if (aligned_) return;
  // From here the position follows the fixes, whatever the heading.
  state_.covariance.block<2, 1>(0, kYaw).setZero();
  state_.covariance.block<1, 2>(kYaw, 0).setZero();
}

void ChordAlignment::predict(const OdometryIncrement& u) {
  if (!started_ || standing(u)) return;
  moving_time_ += u.duration;
  base_in_odom_ = base_in_odom_ * displacement(u);
  auto position = state_.covariance.topLeftCorner<2, 2>();
  const double sigma = mean_sigma(position) + ground_speed(u) * u.duration;
  position = square(sigma) * Eigen::Matrix2d::Identity();
}

Innovation ChordAlignment::update(const GnssFix& fix, const Eigen::Matrix2d& R) {
  Innovation result;
  result.reason = Reason::kAccepted;
  if (started_) {
    result.innovation = fix.position - pose().position();
    result.covariance = state_.covariance.topLeftCorner<2, 2>() + R;
    result.nis = result.innovation.dot(result.covariance.llt().solve(result.innovation));
  }
  follow(fix, R);
  try_to_align(fix, R);
  return result;
}

void ChordAlignment::follow(const GnssFix& fix, const Eigen::Matrix2d& R) {
  started_ = true;
  state_.mean.head<2>() = fix.position;
  state_.covariance.topRows<2>().setZero();
  state_.covariance.leftCols<2>().setZero();
  // The lever arm points nowhere known yet.
  state_.covariance.topLeftCorner<2, 2>() =
      R + fix.antenna_in_base.squaredNorm() * Eigen::Matrix2d::Identity();
}

void ChordAlignment::try_to_align(const GnssFix& fix, const Eigen::Matrix2d& R) {
  const Anchor here{base_in_odom_ * fix.antenna_in_base, fix.position, R, moving_time_};
  if (!anchor_) anchor_ = here;
  const Eigen::Vector2d driven = here.antenna_in_odom - anchor_->antenna_in_odom;
  const Eigen::Vector2d seen = here.antenna_in_map - anchor_->antenna_in_map;
  const double sigma = mean_sigma(anchor_->covariance + R);
  const double chord = driven.norm();
  missing_ = std::max(parameters_.alignment_distance, sigma / parameters_.alignment_yaw_sigma) - chord;
  if (missing_ > 0.0) return;
  const double mismatch = std::abs(seen.norm() - chord);
  if (mismatch > kChordMismatchSigmas * sigma + kChordMismatchShare * chord) {
    anchor_ = here;  // one of the two ends was an outlier, or the wheels slipped
    return;
  }
  align(fix, R, wrap_angle(base_in_odom_.yaw + angle_of(seen) - angle_of(driven)));
}

void ChordAlignment::align(const GnssFix& fix, const Eigen::Matrix2d& R, double yaw) {
  const Eigen::Vector2d seen = fix.position - anchor_->antenna_in_map;
  const Eigen::RowVector2d yaw_by_end = Eigen::RowVector2d(-seen.y(), seen.x()) / seen.squaredNorm();
  const Pose2 base = Pose2{fix.position.x(), fix.position.y(), yaw} *
                     Pose2{-fix.antenna_in_base.x(), -fix.antenna_in_base.y(), 0.0};
  state_ = State{odometry_state::Vector::Zero(), odometry_state::unknown_covariance(noise_)};
  state_.mean.head<3>() << base.x, base.y, yaw;

  // Base = end of the chord - lever arm turned by yaw; the chord's two ends err independently.
  const Eigen::Vector2d base_by_yaw = -antenna_jacobian(base, fix.antenna_in_base).col(2);
  Eigen::Matrix<double, 3, 4> J;
  J.bottomRows<1>() << yaw_by_end, -yaw_by_end;
  J.topRows<2>() = base_by_yaw * J.bottomRows<1>();
  J.topLeftCorner<2, 2>() += Eigen::Matrix2d::Identity();
  Eigen::Matrix4d ends = Eigen::Matrix4d::Zero();
  ends.topLeftCorner<2, 2>() = R;
  ends.bottomRightCorner<2, 2>() = anchor_->covariance;
  state_.covariance.topLeftCorner<3, 3>() = J * ends * J.transpose();

  // A gyro bias has turned the odometry by T g at the chord's end, but the chord itself by half of that.
  const double lag = 0.5 * (moving_time_ - anchor_->moving_time);
  odometry_state::Matrix F = odometry_state::Matrix::Identity();
  F(kYaw, kGyroBias) = -lag;
  state_.covariance = F * state_.covariance * F.transpose();
  state_.covariance(kYaw, kYaw) += square(noise_.yaw) * lag;
  aligned_ = true;
}

}  // namespace multipath_localization
