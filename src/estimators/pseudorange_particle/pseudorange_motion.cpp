#include "estimators/pseudorange_particle/pseudorange_motion.hpp"

#include <algorithm>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kSlowest = 0.5;         ///< whose direction counts as course [m/s]
constexpr double kVelocitySigma = 0.2;   ///< across the course [m/s]
constexpr double kSideslip = 0.01;       ///< 1 sigma between course and yaw [rad]
constexpr double kRolling = 0.05;        ///< by odometry, so that its direction counts [m/s]
constexpr double kFullNoiseSpeed = 1.0;  ///< slower, the odometry errs less [m/s]

void move_by_doppler(Pose2& pose, PseudorangeParticle& particle, const OdometryIncrement& u,
                     const OdometryIncrement& before, const PseudorangeMotionParameters& parameters,
                     RandomStream& random) {
  Eigen::Vector3d& velocity = *particle.velocity;
  if (parameters.velocity_follows_odometry) {
    velocity.head<2>() = rotation(u.yaw_rate * u.duration) * velocity.head<2>();
    const Eigen::Vector2d change(u.speed - before.speed, u.lateral_speed - before.lateral_speed);
    velocity.head<2>() += rotation(pose.yaw) * change;
  }
  const double sigma = parameters.doppler_walk * std::sqrt(u.duration);
  pose.x += velocity.x() * u.duration + sigma * random.normal();
  pose.y += velocity.y() * u.duration + sigma * random.normal();
  pose.yaw = wrap_angle(pose.yaw + (u.yaw_rate - particle.errors.gyro_bias) * u.duration);
  particle.height += velocity.z() * u.duration;
}

void move_by_odometry(Pose2& pose, PseudorangeParticle& particle, const OdometryIncrement& u,
                      const PseudorangeMotionParameters& parameters, RandomStream& random) {
  const double root = std::sqrt(u.duration);
  const double sigma = parameters.odometry_walk * root * std::min(1.0, ground_speed(u) / kFullNoiseSpeed);
  pose = moved(pose, u, particle.errors);
  pose.x += sigma * random.normal();
  pose.y += sigma * random.normal();
  pose.yaw = wrap_angle(pose.yaw + parameters.yaw_walk * root * random.normal());
  particle.errors.gyro_bias += parameters.gyro_bias_walk * root * random.normal();
}

}  // namespace

void PseudorangeMotionParameters::fields(ParameterVisitor& field) {
  field("motion", motion, {"auto", "doppler", "odometry"},
        "what moves the particles: doppler = the velocity of their satellites in line of sight, Eq. (8); "
        "odometry = speed and yaw rate; auto = doppler where an epoch gives it, else odometry");
  field("doppler_tolerance", doppler_tolerance, {0.0, 100.0}, "m/s",
        "a range rate this far off counts half in the velocity; 0 = all alike, as printed");
  field("doppler_walk", doppler_walk, {0.0, 100.0}, "m/sqrt(s)",
        "w of Eq. (8): noise of a position moved by Doppler");
  field("velocity_follows_odometry", velocity_follows_odometry,
        "between epochs the velocity turns with the yaw rate and grows with the speed; false as printed");
  field("odometry_walk", odometry_walk, {0.0, 100.0}, "m/sqrt(s)",
        "noise of a position moved by odometry at 1 m/s and above");
  field("height_walk", height_walk, {0.0, 100.0}, "m/sqrt(s)", "noise of the height while moving");
  field("yaw_walk", yaw_walk, {0.0, 10.0}, "rad/sqrt(s)", "noise of the heading while moving");
  field("speed_scale_sigma", speed_scale_sigma, {0.0, 0.5}, "1",
        "1 sigma of the unknown speed scale error at start");
  field("gyro_bias_sigma", gyro_bias_sigma, {0.0, 0.5}, "rad/s",
        "1 sigma of the unknown yaw rate bias at start");
  field("gyro_bias_walk", gyro_bias_walk, {0.0, 0.1}, "rad/s/sqrt(s)",
        "random walk of the yaw rate bias while moving");
}

void move(Pose2& pose, PseudorangeParticle& particle, const OdometryIncrement& u,
          const OdometryIncrement& before, const PseudorangeMotionParameters& parameters,
          RandomStream& random) {
  if (particle.velocity) {
    move_by_doppler(pose, particle, u, before, parameters, random);
  } else if (!standing(u)) {
    move_by_odometry(pose, particle, u, parameters, random);
  } else {
    return;
  }
  particle.height += parameters.height_walk * std::sqrt(u.duration) * random.normal();
  particle.course_variance += square(parameters.yaw_walk) * u.duration;
}

void adopt_velocity(Pose2& pose, PseudorangeParticle& particle, const Eigen::Vector3d& of_antenna,
                    const Eigen::Vector2d& antenna_in_base, const OdometryIncrement& u) {
  Eigen::Vector3d velocity = of_antenna;
  const Eigen::Vector2d lever = rotation(pose.yaw) * antenna_in_base;
  velocity.head<2>() -= u.yaw_rate * Eigen::Vector2d(-lever.y(), lever.x());
  particle.velocity = velocity;
  const double speed = velocity.head<2>().norm();
  if (speed < kSlowest) return;
  // The base need not point where it goes: backwards, or sideways. A lateral speed of 0 makes it +pi.
  const double ahead = ground_speed(u) > kRolling ? std::atan2(0.0 - u.lateral_speed, u.speed) : 0.0;
  const double course = std::atan2(velocity.y(), velocity.x()) + ahead;
  double& P = particle.course_variance;
  const double K = P / (P + square(kVelocitySigma / speed) + square(kSideslip));
  pose.yaw = wrap_angle(pose.yaw + K * angle_difference(course, pose.yaw));
  P *= 1.0 - K;
}

}  // namespace multipath_localization
