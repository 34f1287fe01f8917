#include "models/motion/steering_motion.hpp"

#include <cmath>

#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "simd/elementary.hpp"

namespace multipath_localization {

namespace {

double deviation(double speed_weight, double angle_weight, double speed, double angle) {
  return std::sqrt(speed_weight * speed * speed + angle_weight * angle * angle);
}

double clamped(double x, double limit) {
  const double below = x < limit ? x : limit;
  return below > -limit ? below : -limit;
}

/// What each particle does within the increment.
struct Arcs {
  BlockValues half_turn;  ///< [rad]
  BlockValues speed;      ///< [m/s]
};

/// Eqs. (4)-(7) of [NIS].
void draw_arcs(const Normals* normals, SteeringMotion::Law law, Arcs* arcs, std::size_t size) {
  const double measured_turn = law.speed * std::tan(law.steering_angle);
  const double rate_scale = law.deviation_scale / law.wheelbase;
#pragma omp simd
  for (std::size_t i = 0; i < size; ++i) {
    const double v = law.speed + law.sigma_speed * static_cast<double>(normals->first()[i]);
    const double phi =
        clamped(law.steering_angle + law.sigma_steering * static_cast<double>(normals->second()[i]),
                law.max_steering_angle);
    const double yaw_rate = law.yaw_rate + rate_scale * (v * elementary::tan(phi) - measured_turn);
    arcs->half_turn[i] = 0.5 * yaw_rate * law.duration;
    arcs->speed[i] = law.speed + law.deviation_scale * (v - law.speed);
  }
}

/// What [NIS] has no need of: the part of the chord of a base that moves sideways as well.
void drift(PoseBlock poses, const Normals* normals, SteeringMotion::Law law, const Arcs* arcs) {
  const double noise = law.deviation_scale * law.sigma_lateral_speed;
#pragma omp simd
  for (std::size_t i = 0; i < poses.size; ++i) {
    const double half_turn = arcs->half_turn[i];
    const double v = law.lateral_speed + noise * static_cast<double>(normals->second()[i]);
    const double chord = v * law.duration * elementary::sinc(clamped(half_turn, kPi));
    const auto [s, c] = elementary::sincos_pi((poses.yaw[i] + half_turn) * (1.0 / kPi));
    poses.x[i] -= chord * s;
    poses.y[i] += chord * c;
  }
}

/// Eqs. (3), (8) of [NIS].
void follow_arcs(PoseBlock poses, const Normals* normals, SteeringMotion::Law law, const Arcs* arcs) {
  const double yaw_noise = law.deviation_scale * law.sigma_yaw_rate * law.duration;
#pragma omp simd
  for (std::size_t i = 0; i < poses.size; ++i) {
    const double half_turn = arcs->half_turn[i];
    const double chord = arcs->speed[i] * law.duration * elementary::sinc(clamped(half_turn, kPi));
    const auto [s, c] = elementary::sincos_pi((poses.yaw[i] + half_turn) * (1.0 / kPi));
    poses.x[i] += chord * c;
    poses.y[i] += chord * s;
    // The noise of Eq. (7) turns the robot but does not bend its arc.
    const double gamma = yaw_noise * static_cast<double>(normals->third()[i]);
    poses.yaw[i] = elementary::wrap(poses.yaw[i] + 2.0 * half_turn + gamma);
  }
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

double steering_angle(const OdometryIncrement& u, double wheelbase) {
  if (std::abs(u.speed) < kStandstillSpeed) return 0.0;
  return std::atan(wheelbase * u.yaw_rate / u.speed);
}

SteeringMotion::SteeringMotion(const OdometryIncrement& u, const SteeringNoiseParameters& parameters)
    : standing_(standing(u)) {
  law_.speed = u.speed;
  law_.lateral_speed = u.lateral_speed;
  law_.yaw_rate = u.yaw_rate;
  law_.duration = u.duration;
  law_.wheelbase = parameters.wheelbase;
  law_.max_steering_angle = parameters.max_steering_angle;
  law_.steering_angle = clamped(steering_angle(u, parameters.wheelbase), parameters.max_steering_angle);
  if (ground_speed(u) < kStandstillSpeed) return;
  const auto sigma = [&](double speed_weight, double angle_weight) {
    return std::sqrt(parameters.noise_scale) *
           deviation(speed_weight, angle_weight, ground_speed(u), law_.steering_angle);
  };
  law_.sigma_speed = sigma(parameters.alpha1, parameters.alpha2);
  law_.sigma_lateral_speed =
      std::sqrt(parameters.noise_scale * parameters.alpha1) * std::abs(u.lateral_speed);
  law_.sigma_steering = sigma(parameters.alpha3, parameters.alpha4);
  law_.sigma_yaw_rate = sigma(parameters.alpha5, parameters.alpha6);
  law_.deviation_scale = std::sqrt(parameters.noise_period / u.duration);
}

void SteeringMotion::move(InstructionSet set, const PoseBlock& poses, const Normals& normals) const {
  if (standing_) return;
  Arcs arcs;
  run<draw_arcs>(set, &normals, law_, &arcs, poses.size);
  if (law_.lateral_speed != 0.0) run<drift>(set, poses, &normals, law_, static_cast<const Arcs*>(&arcs));
  run<follow_arcs>(set, poses, &normals, law_, static_cast<const Arcs*>(&arcs));
}

}  // namespace multipath_localization
