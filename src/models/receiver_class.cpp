#include "multipath_localization/models/receiver_class.hpp"

#include <algorithm>

namespace multipath_localization {

double ReceiverClass::noise_variance(bool noisy) const {
  const double quiet = quiet_sigma * quiet_sigma;
  return noisy ? std::max(noisy_sigma * noisy_sigma, 9.0 * quiet) : quiet;
}

void ReceiverClass::fields(ParameterVisitor& field) {
  field("prior", prior, {0.0, 1.0}, "1", "probability of this class at start");
  field("entry_rate", entry_rate, {0.0, 1.0}, "1/s",
        "rate of changing into this class from another, while moving");
  field("always_shadow", always_shadow, "the bias is always that of a shadow and the noise always noisy");
  field("quiet_sigma", quiet_sigma, {0.001, 100.0}, "m", "white noise of a quiet fix");
  field("noisy_sigma", noisy_sigma, {0.001, 100.0}, "m",
        "white noise of a noisy fix, at least 3 quiet_sigma is used");
  field("open_bias_sigma", open_bias_sigma, {0.0, 100.0}, "m", "bias under open sky");
  field("open_bias_time", open_bias_time, {0.1, 1e5}, "s", "correlation time of the bias under open sky");
  field("shadow_bias_sigma", shadow_bias_sigma, {0.01, 500.0}, "m", "bias in shadow, of a noisy fix");
  field("shadow_bias_time", shadow_bias_time, {0.1, 1e5}, "s",
        "correlation time of the bias in shadow, noisy fix");
  field("shadow_bias_walk", shadow_bias_walk, {0.001, 100.0}, "m/sqrt(s)",
        "random walk of the bias in shadow, quiet fix");
  field("shadow_entry_sigma", shadow_entry_sigma, {0.01, 500.0}, "m", "bias on entering a shadow");
  field("shadow_entry_rate", shadow_entry_rate, {0.0, 10.0}, "1/s", "rate of entering shadows");
  field("shadow_exit_rate", shadow_exit_rate, {0.0, 10.0}, "1/s", "rate of leaving shadows");
  field("shadow_at_start", shadow_at_start, {0.0, 1.0}, "1", "probability of starting in a shadow");
  field("open_noisy_entry_rate", open_noisy_entry_rate, {0.0, 100.0}, "1/s",
        "rate of turning noisy under open sky");
  field("open_noisy_exit_rate", open_noisy_exit_rate, {0.0, 100.0}, "1/s",
        "rate of turning quiet under open sky");
  field("shadow_noisy_entry_rate", shadow_noisy_entry_rate, {0.0, 100.0}, "1/s",
        "rate of turning noisy in shadow");
  field("shadow_noisy_exit_rate", shadow_noisy_exit_rate, {0.0, 100.0}, "1/s",
        "rate of turning quiet in shadow");
  field("slip_rate", slip_rate, {0.0, 10.0}, "1/s", "rate of wheels beginning to slip or to lock");
  field("outlier_probability", outlier_probability, {0.0, 0.5}, "1",
        "probability that a fix is a lone outlier");
  field("outlier_sigma", outlier_sigma, {0.1, 1000.0}, "m", "size of lone outliers");
  field("jump_rate", jump_rate, {0.0, 10.0}, "1/s",
        "rate of restarts from the fixes until the pose is confirmed");
  field("unseen_motion", unseen_motion, {0.0, 10.0}, "1",
        "motion that odometry knows nothing of, in parts of the usual speed");
  field("yaw_walk", yaw_walk, {0.0, 10.0}, "rad/sqrt(s)", "turning that odometry knows nothing of");
}

ReceiverClasses::ReceiverClasses() {
  street.prior = 0.38;
  street.entry_rate = 1e-5;
  street.open_bias_sigma = 0.2;

  canyon.prior = 0.3;
  canyon.always_shadow = true;
  canyon.noisy_sigma = 2.0;
  canyon.shadow_bias_sigma = 25.0;
  canyon.shadow_bias_time = 15.0;
  canyon.shadow_at_start = 1.0;
  canyon.slip_rate = 0.0;
  canyon.outlier_probability = 0.0;
  canyon.jump_rate = 0.0;

  noisy.prior = 0.01;
  noisy.quiet_sigma = 1.0;
  noisy.noisy_sigma = 3.0;
  noisy.open_bias_sigma = 0.5;
  noisy.entry_rate = 1e-7;

  drifting.prior = 0.3;
  drifting.quiet_sigma = 0.4;
  drifting.open_bias_sigma = 0.7;

  wheel_fault.prior = 0.01;
  wheel_fault.entry_rate = 1e-5;
  wheel_fault.shadow_entry_rate = 0.0;
  wheel_fault.shadow_at_start = 0.0;
  wheel_fault.slip_rate = 0.0;
  wheel_fault.jump_rate = 0.0;
  wheel_fault.unseen_motion = 1.0;
  wheel_fault.yaw_walk = 0.5;
}

void ReceiverClasses::fields(ParameterVisitor& field) {
  field.group("street", street, "good receiver, open sky and shadows by turns");
  field.group("canyon", canyon,
              "between tall buildings: always biased by tens of metres, changing within seconds");
  field.group("noisy", noisy, "plain receiver: as street, with white noise of a metre under open sky");
  field.group("drifting", drifting,
              "smoothing receiver: as street, with slow errors of a metre under open sky");
  field.group("wheel_fault", wheel_fault,
              "wheels that slip on and on, encoders that fail: odometry says nothing, the fixes are good");
}

const ReceiverClass& ReceiverClasses::operator[](std::size_t index) const {
  if (index == 0) return street;
  if (index == kCanyon) return canyon;
  if (index == kWheelFault) return wheel_fault;
  return index == 2 ? noisy : drifting;
}

}  // namespace multipath_localization
