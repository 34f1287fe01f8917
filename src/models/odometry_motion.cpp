#include "multipath_localization/models/odometry_motion.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kStandstillSpeed = 0.01;   ///< [m/s]
constexpr double kStandstillYawRate = 0.1;  ///< [rad/s], above the bias and noise of a gyro

double sinc_slope(double x) {
  return std::abs(x) < 1e-4 ? -x / 3.0 : (x * std::cos(x) - std::sin(x)) / (x * x);
}

double deviation(double speed_weight, double angle_weight, const OdometryIncrement& u, double angle) {
  return std::sqrt(speed_weight * u.speed * u.speed + angle_weight * angle * angle);
}

}  // namespace

void SteeringNoiseParameters::fields(ParameterVisitor& field) {
  field("wheelbase", wheelbase, {0.01, 100.0}, "m", "l, Eq. (4): distance of the axles");
  field("alpha1", alpha1, {0.0, 1e3}, "1", "speed variance per speed^2, Eq. (5)");
  field("alpha2", alpha2, {0.0, 1e3}, "m^2/s^2", "speed variance per steering angle^2, Eq. (5)");
  field("alpha3", alpha3, {0.0, 1e3}, "s^2/m^2", "steering variance per speed^2, Eq. (6)");
  field("alpha4", alpha4, {0.0, 1e3}, "1", "steering variance per steering angle^2, Eq. (6)");
  field("alpha5", alpha5, {0.0, 1e3}, "1/m^2", "yaw rate variance per speed^2, Eq. (7)");
  field("alpha6", alpha6, {0.0, 1e3}, "1/s^2", "yaw rate variance per steering angle^2, Eq. (7)");
  field("noise_scale", noise_scale, {0.0, 1.0}, "1",
        "factor on all six; 1 as printed, where the steering noise of 17 rad wraps round the circle");
  field("noise_period", noise_period, {1e-4, 10.0}, "s",
        "Delta, for which the six are meant; other increments get the same noise per distance");
  field("max_steering_angle", max_steering_angle, {0.01, 1.57}, "rad",
        "no steering noise turns the wheel further; 1.57 as printed");
}

bool standing(const OdometryIncrement& u) {
  return std::abs(u.speed) < kStandstillSpeed && std::abs(u.yaw_rate) < kStandstillYawRate;
}

double steering_angle(const OdometryIncrement& u, double wheelbase) {
  if (std::abs(u.speed) < kStandstillSpeed) return 0.0;
  return std::atan(wheelbase * u.yaw_rate / u.speed);
}

SteeringMotion::SteeringMotion(const OdometryIncrement& u, const SteeringNoiseParameters& parameters)
    : u_(u),
      wheelbase_(parameters.wheelbase),
      max_steering_angle_(parameters.max_steering_angle),
      steering_angle_(std::clamp(steering_angle(u, wheelbase_), -max_steering_angle_, max_steering_angle_)) {
  if (std::abs(u.speed) < kStandstillSpeed) return;
  const auto sigma = [&](double speed_weight, double angle_weight) {
    return std::sqrt(parameters.noise_scale) * deviation(speed_weight, angle_weight, u, steering_angle_);
  };
  sigma_speed_ = sigma(parameters.alpha1, parameters.alpha2);
  sigma_steering_ = sigma(parameters.alpha3, parameters.alpha4);
  sigma_yaw_rate_ = sigma(parameters.alpha5, parameters.alpha6);
  deviation_scale_ = std::sqrt(parameters.noise_period / u.duration);
}

Pose2 SteeringMotion::sample(const Pose2& pose, RandomStream& random) const {
  if (standing(u_)) return pose;
  if (deviation_scale_ == 0.0) return pose * displacement(u_);
  const double v = u_.speed + sigma_speed_ * random.normal();
  const double phi = std::clamp(steering_angle_ + sigma_steering_ * random.normal(), -max_steering_angle_,
                                max_steering_angle_);
  const double turned = (v * std::tan(phi) - u_.speed * std::tan(steering_angle_)) / wheelbase_;
  OdometryIncrement drawn = u_;
  drawn.speed += deviation_scale_ * (v - u_.speed);
  drawn.yaw_rate += deviation_scale_ * turned;
  Pose2 moved = pose * displacement(drawn);
  // The noise of Eq. (7) turns the robot but does not bend its arc.
  const double gamma = sigma_yaw_rate_ * random.normal();
  moved.yaw = wrap_angle(moved.yaw + deviation_scale_ * gamma * u_.duration);
  return moved;
}

OdometryIncrement without_errors(const OdometryIncrement& u, const OdometerErrors& errors) {
  OdometryIncrement corrected = u;
  corrected.speed /= 1.0 + errors.speed_scale;
  corrected.yaw_rate -= errors.gyro_bias;
  return corrected;
}

Pose2 moved(const Pose2& pose, const OdometryIncrement& u, const OdometerErrors& errors) {
  return pose * displacement(without_errors(u, errors));
}

MotionJacobians motion_jacobians(const Pose2& pose, const OdometryIncrement& u,
                                 const OdometerErrors& errors) {
  const OdometryIncrement true_u = without_errors(u, errors);
  const double dt = u.duration;
  const double half_turn = 0.5 * true_u.yaw_rate * dt;
  const double a = pose.yaw + half_turn;
  const Eigen::Vector2d along(std::cos(a), std::sin(a));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d d = rotation(pose.yaw) * displacement(true_u).position();
  const double chord = d.dot(along);
  const double chord_per_rate = true_u.speed * dt * sinc_slope(half_turn) * 0.5 * dt;

  MotionJacobians result;
  result.pose.setIdentity();
  result.pose.block<2, 1>(0, 2) = chord * across;
  result.errors.setZero();
  result.errors.block<2, 1>(0, 0) = -d / (1.0 + errors.speed_scale);
  result.errors.block<2, 1>(0, 1) = -(chord_per_rate * along + 0.5 * dt * chord * across);
  result.errors(2, 1) = -dt;
  return result;
}

}  // namespace multipath_localization
