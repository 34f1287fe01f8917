#include "estimators/dual_antenna_ekf/dual_antenna_ekf.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/models/motion/differential_drive.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kUnknownYawVariance = kPi * kPi / 3.0;  ///< of a uniform heading [rad^2]
constexpr double kStandstill = 0.01;                     ///< wheels slower than this rest [m/s]
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

}  // namespace

void DualAntennaEkfParameters::fields(ParameterVisitor& field) {
  field("wheel_separation", wheel_separation, {0.01, 100.0}, "m", "B of Table 1 of [KAM]");
  field("wheel_noise", wheel_noise, {1e-6, 100.0}, "m/s",
        "of either wheel over the ground, root of Q of [KAM]: 0.1, 0.3, 1 for small, middle, large");
  field("wheel_noise_at_rest", wheel_noise_at_rest, {0.0, 100.0}, "m/s",
        "the same while both stand; as printed it is no other than in motion");
  field("noise_period", noise_period, {1e-4, 10.0}, "s",
        "of control, for which the two are meant; other increments get the same noise per time");
  field("heading_jacobian", heading_jacobian,
        "let a heading's error move the predicted position; false as printed: F = I, Eq. (3)");
  field("wrap_innovation", wrap_innovation,
        "take the heading's innovation round the circle; false as printed");
  field("subtract_mean", subtract_mean, "take the mean of pose_error off each pose; false as printed");
  field("pose_covariance", pose_covariance, {"declared", "measured"},
        "R of a pair: from what its fixes declare, or the covariance of pose_error");
  field.group("pose_error", pose_error, "of the poses that pairs tell, as measured in [KAM]");
  field(
      "gate", gate, {0.1, kNoLimit}, "1",
      "largest normalised innovation squared (3 dof) of a pair that is used: ten sigma, for wheels that slip "
      "much bend the prediction; .inf as printed");
  field("fix_gate", fix_gate, {0.1, kNoLimit}, "1", "the same (2 dof) of a single fix");
  field("baseline_gate", baseline_gate, {0.1, kNoLimit}, "1",
        "largest normalised square (1 dof) of the error of the distance between two antennas");
  field("baseline_tolerance", baseline_tolerance, {0.0, 10.0}, "m", "how well their mounting is known");
  field("reopen_after", reopen_after, {0.1, 3600.0}, "s", "rejections on end for this long open a gate");
  field("reopen_yaw_sigma", reopen_yaw_sigma, {0.0, kPi}, "rad", "added to the heading's uncertainty then");
  field("alignment_yaw_sigma", alignment_yaw_sigma, {0.01, 1.0}, "rad",
        "largest standard deviation of a heading that counts as aligned, or is started from");
  declared.fields(field);
}

DualAntennaEkf::DualAntennaEkf(const DualAntennaEkfParameters& parameters, std::uint64_t)
    : parameters_(parameters),
      pose_error_(parameters.pose_error),
      mean_error_(parameters.subtract_mean ? pose_error_.mean : Eigen::Vector3d::Zero()) {
  const bool singular = pose_error_.covariance.llt().info() != Eigen::Success;
  if (parameters_.pose_covariance == PoseCovariance::kMeasured && singular) {
    throw ParameterError("covariance of pose_error is singular, no measured R");
  }
}

Pose2 DualAntennaEkf::pose() const {
  return {belief_.mean(kX), belief_.mean(kY), wrap_angle(belief_.mean(kYaw))};
}

void DualAntennaEkf::start(const std::optional<PosePrior>& prior) {
  for (FixCheck* check : {&left_check_, &right_check_, &single_check_}) check->forget();
  phase_ = Phase::kWaiting;
  belief_ = Gaussian<kStates>{};
  rejected_pairs_.end();
  rejected_fixes_.end();
  now_ = 0.0;
  if (!prior || !usable(*prior)) return;
  now_ = prior->stamp;
  belief_.mean << prior->pose.x, prior->pose.y, wrap_angle(prior->pose.yaw);
  belief_.covariance = prior->covariance;
  const bool wide = prior->covariance(kYaw, kYaw) > square(parameters_.alignment_yaw_sigma);
  phase_ = wide ? Phase::kFollowing : Phase::kTracking;
  if (!wide) return;
  // From here the position follows the fixes, whatever the heading.
  belief_.covariance.block<2, 1>(kX, kYaw).setZero();
  belief_.covariance.block<1, 2>(kYaw, kX).setZero();
}

void DualAntennaEkf::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  now_ = u.stamp;
  if (phase_ == Phase::kFollowing) {
    auto position = belief_.covariance.topLeftCorner<2, 2>();
    const double sigma = mean_sigma(position) + ground_speed(u) * u.duration;
    position = square(sigma) * Eigen::Matrix2d::Identity();
  }
  if (phase_ != Phase::kTracking) return;
  const Pose2 end = pose() * displacement(u);
  const Eigen::Vector3d x(end.x, end.y, belief_.mean(kYaw) + u.yaw_rate * u.duration);  // Eq. (3)

  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  if (parameters_.heading_jacobian) F = motion_jacobians(pose(), u, {}).pose;
  const Eigen::Matrix<double, 3, 2> G = wheel_jacobian(pose(), u, parameters_.wheel_separation);
  const WheelSpeeds wheels = wheel_speeds(u.speed, u.yaw_rate, parameters_.wheel_separation);
  const double fastest = std::max({std::abs(wheels.left), std::abs(wheels.right), std::abs(u.lateral_speed)});
  const bool at_rest = fastest < kStandstill;
  const double sigma = at_rest ? parameters_.wheel_noise_at_rest : parameters_.wheel_noise;
  const double variance = square(sigma) * parameters_.noise_period / u.duration;
  Eigen::Matrix3d Q = variance * G * G.transpose();
  if (u.lateral_speed != 0.0) {  // departs: the rollers of an omnidirectional base err as its wheels do
    const Eigen::Vector2d across = u.duration * rotation(belief_.mean(kYaw)).col(1);
    Q.topLeftCorner<2, 2>() += 0.5 * variance * across * across.transpose();
  }
  kalman::predict<kStates>(belief_, x, F, Q);  // Eq. (4)
}

Innovation DualAntennaEkf::update(const Measurement& z) {
  if (const auto* fixes = std::get_if<DualAntennaFix>(&z)) return take(*fixes);
  if (const auto* fix = std::get_if<GnssFix>(&z)) return take(*fix);
  return refused(Reason::kUnused);
}

std::optional<Reason> DualAntennaEkf::defect(const DualAntennaFix& fixes) {
  if (!std::isfinite(fixes.stamp)) return Reason::kNotFinite;
  const std::optional<Reason> left = left_check_.defect(fixes.left);
  const std::optional<Reason> right = right_check_.defect(fixes.right);
  // A receiver at rest may well repeat itself, two at once do not.
  if (left && left != Reason::kFrozen) return left;
  if (right && right != Reason::kFrozen) return right;
  return left && right ? left : std::nullopt;
}

Innovation DualAntennaEkf::take(const DualAntennaFix& fixes) {
  if (const auto reason = defect(fixes)) return refused(*reason);
  DualAntennaFix believed = fixes;
  for (GnssFix* fix : {&believed.left, &believed.right}) {
    fix->covariance = believed_covariance(fix->covariance, parameters_.declared);
  }
  std::optional<DualAntennaPose> told = dual_antenna_pose(believed, parameters_.baseline_tolerance);
  if (!told || told->baseline_nis > parameters_.baseline_gate) return refused(Reason::kWrongBaseline);
  if (parameters_.pose_covariance == PoseCovariance::kMeasured) told->covariance = pose_error_.covariance;
  if (phase_ == Phase::kTracking) return track(*told);
  if (told->covariance(kYaw, kYaw) > square(parameters_.alignment_yaw_sigma)) {
    follow(believed.left);
  } else {
    align(*told);
  }
  return Innovation{Reason::kAccepted};
}

Innovation DualAntennaEkf::take(const GnssFix& fix) {
  if (const auto reason = single_check_.defect(fix)) return refused(*reason);
  GnssFix believed = fix;
  believed.covariance = believed_covariance(fix.covariance, parameters_.declared);
  if (phase_ == Phase::kTracking) return track(believed);
  follow(believed);
  return Innovation{Reason::kAccepted};
}

void DualAntennaEkf::follow(const GnssFix& fix) {
  phase_ = Phase::kFollowing;
  belief_.mean.head<2>() = fix.position;
  belief_.covariance.setZero();
  // The lever arm points nowhere known yet.
  belief_.covariance.topLeftCorner<2, 2>() =
      fix.covariance + fix.antenna_in_base.squaredNorm() * Eigen::Matrix2d::Identity();
  belief_.covariance(kYaw, kYaw) = kUnknownYawVariance;
}

void DualAntennaEkf::align(const DualAntennaPose& told) {
  phase_ = Phase::kTracking;
  belief_.mean = told.pose - mean_error_;
  belief_.covariance = told.covariance;
}

Innovation DualAntennaEkf::track(const DualAntennaPose& told) {
  Eigen::Vector3d y = told.pose - mean_error_ - belief_.mean;  // Eq. (6), H = I
  if (parameters_.wrap_innovation) y(kYaw) = wrap_angle(y(kYaw));
  return correct<3>(y, Eigen::Matrix3d::Identity(), told.covariance, parameters_.gate, rejected_pairs_);
}

Innovation DualAntennaEkf::track(const GnssFix& fix) {
  const Eigen::Vector3d told = belief_.mean + mean_error_;  // by a pair
  const Pose2 antennas{told(kX), told(kY), told(kYaw)};
  const Eigen::Vector2d y = fix.position - antennas * fix.antenna_in_base;
  return correct<2>(y, antenna_jacobian(antennas, fix.antenna_in_base), fix.covariance, parameters_.fix_gate,
                    rejected_fixes_);
}

template <int M>
Innovation DualAntennaEkf::correct(const Eigen::Matrix<double, M, 1>& y,
                                   const Eigen::Matrix<double, M, kStates>& H,
                                   const Eigen::Matrix<double, M, M>& R, double gate,
                                   RejectionStreak& rejections) {
  const auto compared = kalman::compare<kStates, M>(belief_, y, H, R);
  Innovation result{Reason::kGated, y.template head<2>(), compared.covariance.template topLeftCorner<2, 2>(),
                    compared.nis};
  if (compared.nis > gate) {
    if (rejections.add(now_) < parameters_.reopen_after) return result;
    // With y^2 more in the state the innovation is within one sigma: no distance keeps the gate shut.
    const double turn = M == kStates ? y(M - 1) : 0.0;
    belief_.covariance.topLeftCorner<2, 2>() +=
        y.template head<2>().squaredNorm() * Eigen::Matrix2d::Identity();
    belief_.covariance(kYaw, kYaw) += square(turn) + square(parameters_.reopen_yaw_sigma);
  }
  rejections.end();
  kalman::correct<kStates, M>(belief_, y, H, R);  // Eqs. (7)-(10), where (10) prints H' for H
  if (parameters_.wrap_innovation) belief_.mean(kYaw) = wrap_angle(belief_.mean(kYaw));
  result.reason = Reason::kAccepted;
  return result;
}

PoseEstimate DualAntennaEkf::estimate() const {
  PoseEstimate result;
  result.stamp = now_;
  if (phase_ == Phase::kWaiting) return result;
  result.valid = true;
  result.aligned =
      phase_ == Phase::kTracking && belief_.covariance(kYaw, kYaw) < square(parameters_.alignment_yaw_sigma);
  result.pose = pose();
  result.covariance = belief_.covariance;
  result.position_covariance_overall = belief_.covariance.topLeftCorner<2, 2>();
  return result;
}

std::vector<Hypothesis> DualAntennaEkf::hypotheses() const {
  if (phase_ == Phase::kWaiting) return {};
  return {{pose(), 1.0, Mode::kOpen}};
}

}  // namespace multipath_localization
