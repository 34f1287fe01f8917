#include "simulation/gyro.hpp"

#include <cmath>

#include "multipath_localization/core/random.hpp"
#include "simulation/periods.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

void GyroParameters::fields(ParameterVisitor& field) {
  field("rate", rate, {0.0, 1e4}, "Hz", "at most one sample per simulation step; 0: there is no gyro");
  field("bias", bias, {-10.0, 10.0}, "rad/s", "constant error");
  field("bias_sigma", bias_sigma, {0.0, 10.0}, "rad/s", "its spread from seed to seed");
  field("noise", noise, {0.0, 10.0}, "rad/sqrt(s)", "white");
  field("scale_error", scale_error, {-0.9, 10.0}, "1", "of measured rate over true, minus 1");
}

Gyro::Gyro(const GyroParameters& parameters, const std::vector<SensorFault>& faults, std::uint64_t seed)
    : parameters_(parameters), faults_(faults, "gyro", seed, kGyroFaultStream), seed_(seed) {
  RandomStream random(seed_, 0, kGyroStream);
  bias_ = parameters_.bias + parameters_.bias_sigma * random.normal();
}

std::vector<YawRate> Gyro::step(double yaw_rate, double time) {
  ++steps_;
  const auto due = periods(time, parameters_.rate);
  if (due <= emitted_) return under_way_.take(time);
  emitted_ = due;
  RandomStream random(seed_, steps_, kGyroStream);
  const double noise = parameters_.noise * std::sqrt(parameters_.rate) * random.normal();
  const double told = yaw_rate * (1.0 + parameters_.scale_error) + bias_ + noise;
  if (const auto spoilt = faults_.spoil(time, {0.0, 0.0, told})) {
    under_way_.send({time, spoilt->value.z()}, time + spoilt->delay);
  }
  return under_way_.take(time);
}

}  // namespace multipath_localization
