#include "simulation/odometer.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/random.hpp"
#include "simulation/periods.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

void SlipParameters::fields(ParameterVisitor& field) {
  field("start", start, {0.0, 1e9}, "s", "of the episode");
  field("duration", duration, {0.0, 1e9}, "s", "of the episode");
  field("ratio", ratio, {-1.0, 100.0}, "1",
        "wheel path beyond the robot's over the robot's; -1: locked wheels");
}

void OdometerParameters::fields(ParameterVisitor& field) {
  field("rate", rate, {0.1, 1e4}, "Hz", "at most one increment per simulation step");
  field("source", source, {"motion", "command"},
        "motion: what the robot did; command: what it was told, as the filter of [NIS] is fed");
  field("speed_scale_error", speed_scale_error, {-0.9, 10.0}, "1", "of measured speed over true, minus 1");
  field("speed_scale_error_sigma", speed_scale_error_sigma, {0.0, 0.3}, "1", "its spread from seed to seed");
  field("speed_noise", speed_noise, {0.0, 100.0}, "m/s", "white, per increment");
  field("speed_noise_ratio", speed_noise_ratio, {0.0, 10.0}, "1", "white, per increment, times the speed");
  field("gyro_bias", gyro_bias, {-10.0, 10.0}, "rad/s", "constant error of the yaw rate");
  field("gyro_bias_sigma", gyro_bias_sigma, {0.0, 10.0}, "rad/s", "its spread from seed to seed");
  field("yaw_rate_noise", yaw_rate_noise, {0.0, 100.0}, "rad/s", "white, per increment");
  field("slip_rate", slip_rate, {0.0, 10.0}, "1/s", "random wheel slips per second");
  field("slip_duration", slip_duration, {0.0, 1e4}, "s", "of a random slip");
  field("slip_ratio", slip_ratio, {-1.0, 100.0}, "1", "of a random slip, as in `slips`");
  field.list("slips", slips, "slips at known times");
}

Odometer::Odometer(const OdometerParameters& parameters, std::uint64_t seed)
    : parameters_(parameters), seed_(seed) {
  RandomStream random(seed_, 0, kOdometerStream);
  scale_ = 1.0 + parameters_.speed_scale_error + parameters_.speed_scale_error_sigma * random.normal();
  gyro_bias_ = parameters_.gyro_bias + parameters_.gyro_bias_sigma * random.normal();
}

double Odometer::slip_ratio(double time, double duration) {
  RandomStream random(seed_, steps_, kOdometerStream);
  const double start = time - duration;
  if (start >= slip_until_ && random.uniform() < parameters_.slip_rate * duration) {
    slip_until_ = start + parameters_.slip_duration;
  }
  if (start < slip_until_) return parameters_.slip_ratio;
  for (const SlipParameters& slip : parameters_.slips) {
    if (start >= slip.start && start < slip.start + slip.duration) return slip.ratio;
  }
  return 0.0;
}

std::optional<OdometryIncrement> Odometer::step(const Robot& robot, double time, double duration) {
  ++steps_;
  const bool told = parameters_.source == OdometerSource::kCommand;
  const double speed = told ? robot.command().speed : robot.speed();
  const double slip = slip_ratio(time, duration);
  slipping_ = slip != 0.0;
  distance_ += speed * (1.0 + slip) * duration;
  sideways_ += (told ? robot.strafing() : robot.lateral_speed()) * (1.0 + slip) * duration;
  turn_ += (told ? yaw_rate(robot.command(), robot.parameters().wheelbase) : robot.yaw_rate()) * duration;
  elapsed_ += duration;

  const auto due = periods(time, parameters_.rate);
  if (due <= emitted_) return std::nullopt;
  emitted_ = due;

  RandomStream random(seed_, steps_, kOdometerNoiseStream);
  OdometryIncrement increment{time, elapsed_, scale_ * distance_ / elapsed_, turn_ / elapsed_ + gyro_bias_,
                              scale_ * sideways_ / elapsed_};
  const double ratio_noise = parameters_.speed_noise_ratio * std::abs(increment.speed);
  increment.speed += std::hypot(parameters_.speed_noise, ratio_noise) * random.normal();
  increment.yaw_rate += parameters_.yaw_rate_noise * random.normal();
  if (robot.parameters().drive == DriveKind::kOmnidirectional) {
    const double lateral_ratio_noise = parameters_.speed_noise_ratio * std::abs(increment.lateral_speed);
    increment.lateral_speed += std::hypot(parameters_.speed_noise, lateral_ratio_noise) * random.normal();
  }
  distance_ = sideways_ = turn_ = elapsed_ = 0.0;
  return increment;
}

}  // namespace multipath_localization
