#include "simulation/robot.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/models/motion/differential_drive.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

/// `value` moved towards `goal` by at most `step`.
double approach(double value, double goal, double step) {
  return value + std::clamp(goal - value, -step, step);
}

}  // namespace

void StrafeParameters::fields(ParameterVisitor& field) {
  field("start", start, {0.0, 1e9}, "s", "of the way sideways");
  field("duration", duration, {0.0, 1e9}, "s", "of the way sideways");
  field("speed", speed, {-100.0, 100.0}, "m/s", "to the left, beside the motion commanded");
}

void RobotParameters::fields(ParameterVisitor& field) {
  field("drive", drive, {"steering", "differential", "omnidirectional"},
        "steering: a front wheel, its noise by alpha; differential: two driven wheels, theirs by "
        "wheel_noise; omnidirectional: as differential, and strafes as told");
  field("wheelbase", wheelbase, {0.01, 100.0}, "m",
        "l of [NIS], front to rear axle; differential: makes a yaw rate of the steering angle");
  field("start_x", start_x, {-1e6, 1e6}, "m", "start in map, east");
  field("start_y", start_y, {-1e6, 1e6}, "m", "start in map, north");
  field("start_yaw", start_yaw, {-2.0 * kPi, 2.0 * kPi}, "rad", "start heading, counter-clockwise from east");
  field("max_speed", max_speed, {0.0, 100.0}, "m/s", "forwards and in reverse");
  field("max_acceleration", max_acceleration, {1e-3, 1e6}, "m/s^2", "speeding up and braking");
  field("max_steering_angle", max_steering_angle, {0.0, 1.5}, "rad", "to either side");
  field("max_steering_rate", max_steering_rate, {1e-3, 1e6}, "rad/s", "of the front wheel");
  field("alpha", alpha, {0.0, 1e6}, "mixed",
        "alpha1 ... alpha6 of Eqs. (5)-(7) of [NIS], noise of every step");
  field("noise_scale", noise_scale, {0.0, 1e3}, "1",
        "factor on all alpha: printed as they are they turn the front wheel by 17 rad at 10 m/s");
  field("wheel_separation", wheel_separation, {0.01, 100.0}, "m", "differential: B of [KAM]");
  field("wheel_noise", wheel_noise, {0.0, 100.0}, "m/s",
        "differential: of either wheel over the ground, drawn every step; Table 2 of [KAM] has 0.1, 0.3, 1");
  field.list("strafes", strafes, "ways sideways of an omnidirectional robot");
}

Robot::Robot(const RobotParameters& parameters, std::uint64_t seed)
    : parameters_(parameters),
      seed_(seed),
      pose_{parameters.start_x, parameters.start_y, wrap_angle(parameters.start_yaw)} {
  if (parameters_.alpha.size() != 6) throw ParameterError("alpha of the robot has not six entries");
}

void Robot::limit(const MotionCommand& command, double duration) {
  const MotionCommand goal = command.finite() ? command : MotionCommand{0.0, command_.steering_angle};
  const double speed = std::clamp(goal.speed, -parameters_.max_speed, parameters_.max_speed);
  const double angle =
      std::clamp(goal.steering_angle, -parameters_.max_steering_angle, parameters_.max_steering_angle);
  command_.speed = approach(command_.speed, speed, parameters_.max_acceleration * duration);
  command_.steering_angle =
      approach(command_.steering_angle, angle, parameters_.max_steering_rate * duration);
}

void Robot::step(const MotionCommand& command, double duration) {
  limit(command, duration);
  RandomStream random(seed_, ++steps_, kRobotStream);
  if (parameters_.drive == DriveKind::kSteering) {
    steer(random, duration);
  } else {
    roll(random, duration);
  }
  if (parameters_.drive == DriveKind::kOmnidirectional) strafe(random, duration);
  time_ += duration;
}

void Robot::steer(RandomStream& random, double duration) {
  const auto noise = [&](std::size_t first) {
    const double v = command_.speed;
    const double phi = command_.steering_angle;
    const double variance = parameters_.alpha[first] * v * v + parameters_.alpha[first + 1] * phi * phi;
    return std::sqrt(parameters_.noise_scale * variance) * random.normal();
  };
  MotionCommand moved = command_;
  double extra_turn = 0.0;
  // Departs from Eqs. (5)-(7) of [NIS], whose steering terms would push a parked robot about.
  if (command_.speed != 0.0) {
    moved.speed += noise(0);           // Eq. (5) of [NIS]
    moved.steering_angle += noise(2);  // Eq. (6) of [NIS]
    extra_turn = noise(4);             // Eq. (7) of [NIS]
  }
  const double arc_rate = multipath_localization::yaw_rate(moved, parameters_.wheelbase);
  pose_ = pose_ * displacement({0.0, duration, moved.speed, arc_rate});  // Eq. (8) of [NIS]
  pose_.yaw = wrap_angle(pose_.yaw + extra_turn * duration);
  speed_ = moved.speed;
  yaw_rate_ = arc_rate + extra_turn;
}

void Robot::roll(RandomStream& random, double duration) {
  const double turning = multipath_localization::yaw_rate(command_, parameters_.wheelbase);
  WheelSpeeds wheels = wheel_speeds(command_.speed, turning, parameters_.wheel_separation);
  if (command_.speed != 0.0) {
    wheels.left += parameters_.wheel_noise * random.normal();
    wheels.right += parameters_.wheel_noise * random.normal();
  }
  speed_ = multipath_localization::speed(wheels);
  yaw_rate_ = multipath_localization::yaw_rate(wheels, parameters_.wheel_separation);
  pose_ = pose_ * displacement({0.0, duration, speed_, yaw_rate_});
}

/// Sideways over the turn that the robot has just made.
void Robot::strafe(RandomStream& random, double duration) {
  double goal = 0.0;
  for (const StrafeParameters& way : parameters_.strafes) {
    if (time_ >= way.start && time_ < way.start + way.duration) goal = way.speed;
  }
  goal = std::clamp(goal, -parameters_.max_speed, parameters_.max_speed);
  strafing_ = approach(strafing_, goal, parameters_.max_acceleration * duration);
  lateral_speed_ = strafing_ == 0.0 ? 0.0 : strafing_ + parameters_.wheel_noise * random.normal();
  const Pose2 before = pose_ * inverse(displacement({0.0, duration, 0.0, yaw_rate_}));
  const Pose2 sideways = before * displacement({0.0, duration, 0.0, yaw_rate_, lateral_speed_});
  pose_.x = sideways.x;
  pose_.y = sideways.y;
}

}  // namespace multipath_localization
