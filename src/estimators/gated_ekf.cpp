#include "multipath_localization/estimators/gated_ekf.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/models/odometry_motion.hpp"

namespace multipath_localization {

namespace {

constexpr double kUnknownYawVariance = kPi * kPi / 3.0;  ///< of a uniform heading [rad^2]
constexpr double kWidestPriorYaw = 1.0;                  ///< a wider one counts as unknown [rad]
constexpr double kChordMismatchSigmas = 3.0;
constexpr double kChordMismatchShare = 0.1;

double square(double x) { return x * x; }
double angle_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

}  // namespace

void GatedEkfParameters::fields(ParameterVisitor& field) {
  field("gate", gate, {0.1, 1e6}, "1", "largest normalised innovation squared (2 dof) of a fix that is used");
  field("reopen_after", reopen_after, {0.1, 3600.0}, "s", "rejections on end for this long open the gate");
  field("reopen_yaw_sigma", reopen_yaw_sigma, {0.0, kPi}, "rad", "added to the heading's uncertainty then");
  field("alignment_distance", alignment_distance, {0.1, 1e3}, "m",
        "least chord driven before the heading is taken from it");
  field("alignment_yaw_sigma", alignment_yaw_sigma, {0.01, 1.0}, "rad",
        "largest standard deviation of a heading that counts as aligned; noisy fixes make the chord longer");
  declared.fields(field);
  field.group("odometry", odometry, "how far the wheel odometry can be trusted");
}

GatedEkf::GatedEkf(const GatedEkfParameters& parameters, std::uint64_t) : parameters_(parameters) {}

Pose2 GatedEkf::pose() const { return {belief_.mean(kX), belief_.mean(kY), wrap_angle(belief_.mean(kYaw))}; }

void GatedEkf::set_odometer_errors_unknown() {
  belief_ = Gaussian<kStates>{};
  belief_.covariance(kYaw, kYaw) = kUnknownYawVariance;
  belief_.covariance(kScale, kScale) = square(parameters_.odometry.scale_sigma);
  belief_.covariance(kGyroBias, kGyroBias) = square(parameters_.odometry.gyro_bias_sigma);
}

void GatedEkf::start(const std::optional<PosePrior>& prior) {
  fix_check_.forget();
  phase_ = Phase::kWaiting;
  base_in_odom_ = Pose2{};
  anchor_.reset();
  rejecting_since_.reset();
  now_ = 0.0;
  set_odometer_errors_unknown();
  if (!prior || !usable(*prior)) return;
  now_ = prior->stamp;
  belief_.mean.head<3>() << prior->pose.x, prior->pose.y, wrap_angle(prior->pose.yaw);
  belief_.covariance.topLeftCorner<3, 3>() = prior->covariance;
  phase_ = prior->covariance(2, 2) > square(kWidestPriorYaw) ? Phase::kFollowing : Phase::kTracking;
}

void GatedEkf::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  now_ = u.stamp;
  if (phase_ == Phase::kWaiting || standing(u)) return;
  if (phase_ == Phase::kFollowing) {
    base_in_odom_ = base_in_odom_ * displacement(u);
    auto position = belief_.covariance.topLeftCorner<2, 2>();
    const double sigma = std::sqrt(0.5 * position.trace()) + std::abs(u.speed) * u.duration;
    position = square(sigma) * Eigen::Matrix2d::Identity();
    return;
  }
  const OdometerErrors errors{belief_.mean(kScale), belief_.mean(kGyroBias)};
  const MotionJacobians jacobians = motion_jacobians(pose(), u, errors);
  const Pose2 end = moved(pose(), u, errors);
  Eigen::Matrix<double, kStates, 1> mean = belief_.mean;
  mean.head<3>() << end.x, end.y, end.yaw;

  using Matrix = Eigen::Matrix<double, kStates, kStates>;
  Matrix F = Matrix::Identity();
  F.topLeftCorner<3, 3>() = jacobians.pose;
  F.topRightCorner<3, 2>() = jacobians.errors;
  const OdometryNoise& noise = parameters_.odometry;
  const Eigen::Vector2d along = rotation(belief_.mean(kYaw)).col(0);
  Matrix Q = Matrix::Zero();
  Q.topLeftCorner<2, 2>() =
      square(noise.distance) * std::abs(u.speed) * u.duration * along * along.transpose();
  Q(kYaw, kYaw) = square(noise.yaw) * u.duration;
  Q(kScale, kScale) = square(noise.scale_walk) * u.duration;
  Q(kGyroBias, kGyroBias) = square(noise.gyro_bias_walk) * u.duration;
  kalman::predict<kStates>(belief_, mean, F, Q);
}

Innovation GatedEkf::update(const Measurement& z) {
  const auto* fix = std::get_if<GnssFix>(&z);
  if (fix == nullptr) return refused(Reason::kUnused);
  if (const auto reason = fix_check_.defect(*fix)) return refused(*reason);
  const Eigen::Matrix2d R = believed_covariance(fix->covariance, parameters_.declared);
  if (phase_ == Phase::kTracking) return track(*fix, R);
  Innovation result;
  result.reason = Reason::kAccepted;
  if (phase_ == Phase::kFollowing) {
    result.innovation = fix->position - pose().position();
    result.covariance = belief_.covariance.topLeftCorner<2, 2>() + R;
    result.nis = result.innovation.dot(result.covariance.llt().solve(result.innovation));
  }
  follow(*fix, R);
  try_to_align(*fix, R);
  return result;
}

void GatedEkf::follow(const GnssFix& fix, const Eigen::Matrix2d& R) {
  phase_ = Phase::kFollowing;
  belief_.mean.head<2>() = fix.position;
  belief_.covariance.topRows<2>().setZero();
  belief_.covariance.leftCols<2>().setZero();
  // The lever arm points nowhere known yet.
  belief_.covariance.topLeftCorner<2, 2>() =
      R + fix.antenna_in_base.squaredNorm() * Eigen::Matrix2d::Identity();
}

void GatedEkf::try_to_align(const GnssFix& fix, const Eigen::Matrix2d& R) {
  const Anchor here{base_in_odom_ * fix.antenna_in_base, fix.position, R, now_};
  if (!anchor_) anchor_ = here;
  const Eigen::Vector2d driven = here.antenna_in_odom - anchor_->antenna_in_odom;
  const Eigen::Vector2d seen = here.antenna_in_map - anchor_->antenna_in_map;
  const double sigma = std::sqrt(0.5 * (anchor_->covariance + R).trace());
  const double chord = driven.norm();
  if (chord < parameters_.alignment_distance || sigma > parameters_.alignment_yaw_sigma * chord) return;
  const double mismatch = std::abs(seen.norm() - chord);
  if (mismatch > kChordMismatchSigmas * sigma + kChordMismatchShare * chord) {
    anchor_ = here;  // one of the two ends was an outlier, or the wheels slipped
    return;
  }
  align(fix, R, wrap_angle(base_in_odom_.yaw + angle_of(seen) - angle_of(driven)));
}

void GatedEkf::align(const GnssFix& fix, const Eigen::Matrix2d& R, double yaw) {
  const Eigen::Vector2d seen = fix.position - anchor_->antenna_in_map;
  const Eigen::RowVector2d yaw_by_end = Eigen::RowVector2d(-seen.y(), seen.x()) / seen.squaredNorm();
  const Pose2 base = Pose2{fix.position.x(), fix.position.y(), yaw} *
                     Pose2{-fix.antenna_in_base.x(), -fix.antenna_in_base.y(), 0.0};
  set_odometer_errors_unknown();
  belief_.mean.head<3>() << base.x, base.y, yaw;

  // Base = end of the chord - lever arm turned by yaw; the chord's two ends err independently.
  const Eigen::Vector2d base_by_yaw = -antenna_jacobian(base, fix.antenna_in_base).col(2);
  Eigen::Matrix<double, 3, 4> J;
  J.bottomRows<1>() << yaw_by_end, -yaw_by_end;
  J.topRows<2>() = base_by_yaw * J.bottomRows<1>();
  J.topLeftCorner<2, 2>() += Eigen::Matrix2d::Identity();
  Eigen::Matrix4d ends = Eigen::Matrix4d::Zero();
  ends.topLeftCorner<2, 2>() = R;
  ends.bottomRightCorner<2, 2>() = anchor_->covariance;
  belief_.covariance.topLeftCorner<3, 3>() = J * ends * J.transpose();

  // A gyro bias has turned the odometry by T g at the chord's end, but the chord itself by half of that.
  const double lag = 0.5 * (now_ - anchor_->stamp);
  Eigen::Matrix<double, kStates, kStates> F = Eigen::Matrix<double, kStates, kStates>::Identity();
  F(kYaw, kGyroBias) = -lag;
  belief_.covariance = F * belief_.covariance * F.transpose();
  belief_.covariance(kYaw, kYaw) += square(parameters_.odometry.yaw) * lag;
  phase_ = Phase::kTracking;
}

Innovation GatedEkf::track(const GnssFix& fix, const Eigen::Matrix2d& R) {
  Eigen::Matrix<double, 2, kStates> H = Eigen::Matrix<double, 2, kStates>::Zero();
  H.leftCols<3>() = antenna_jacobian(pose(), fix.antenna_in_base);
  const Eigen::Vector2d y = fix.position - pose() * fix.antenna_in_base;
  const auto compared = kalman::compare<kStates, 2>(belief_, y, H, R);
  Innovation result{Reason::kGated, compared.innovation, compared.covariance, compared.nis};
  if (compared.nis > parameters_.gate) {
    if (!reopens()) return result;
    // With |y|^2 more in position the innovation is within one sigma: no distance keeps the gate shut.
    belief_.covariance.topLeftCorner<2, 2>() += y.squaredNorm() * Eigen::Matrix2d::Identity();
    belief_.covariance(kYaw, kYaw) += square(parameters_.reopen_yaw_sigma);
  }
  rejecting_since_.reset();
  kalman::correct<kStates, 2>(belief_, y, H, R);
  belief_.mean(kYaw) = wrap_angle(belief_.mean(kYaw));
  result.reason = Reason::kAccepted;
  return result;
}

bool GatedEkf::reopens() {
  if (!rejecting_since_) rejecting_since_ = now_;
  return now_ - *rejecting_since_ >= parameters_.reopen_after;
}

PoseEstimate GatedEkf::estimate() const {
  PoseEstimate result;
  result.stamp = now_;
  if (phase_ == Phase::kWaiting) return result;
  result.valid = true;
  result.aligned =
      phase_ == Phase::kTracking && belief_.covariance(kYaw, kYaw) < square(parameters_.alignment_yaw_sigma);
  result.pose = pose();
  result.covariance = belief_.covariance.topLeftCorner<3, 3>();
  result.position_covariance_overall = belief_.covariance.topLeftCorner<2, 2>();
  return result;
}

std::vector<Hypothesis> GatedEkf::hypotheses() const {
  if (phase_ == Phase::kWaiting) return {};
  return {{pose(), 1.0, Mode::kOpen}};
}

}  // namespace multipath_localization
