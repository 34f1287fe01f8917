#include "simulation/velocity_receiver.hpp"

#include "simulation/periods.hpp"
#include "simulation/streams.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

void VelocityReceiverParameters::fields(ParameterVisitor& field) {
  field("rate", rate, {0.0, 1e3}, "Hz", "0: the receiver tells no velocity");
  field("white_sigma", white_sigma, {0.0, 10.0}, "m/s", "white noise, of each component");
  field("slow_sigma", slow_sigma, {0.0, 10.0}, "m/s", "correlated error, of each component");
  field("slow_time", slow_time, {0.01, 1e3}, "s", "its correlation time");
  field("lag", lag, {0.0, 2.0}, "s", "it is the velocity of this long before its stamp");
  field("latency", latency, {0.0, 10.0}, "s", "from the stamp to the arrival");
  field("declared_sigma", declared_sigma, {0.0, 10.0}, "m/s", "of each component");
  field("outlier_share", outlier_share, {0.0, 1.0}, "1", "of those under open sky that are reflected");
  field("outlier_share_shadow", outlier_share_shadow, {0.0, 1.0}, "1", "of those in a shadow");
  field("outlier_sigma", outlier_sigma, {0.0, 100.0}, "m/s", "how far such are off, of each component");
}

VelocityReceiver::VelocityReceiver(const VelocityReceiverParameters& parameters,
                                   const std::vector<SensorFault>& faults, std::uint64_t seed)
    : parameters_(parameters),
      faults_(faults, "velocity", seed, kVelocityFaultStream),
      random_(seed, 0, kVelocityStream),
      slow_(parameters.slow_sigma, parameters.slow_time, RandomStream(seed, 1, kVelocityStream)) {}

std::vector<GnssVelocity> VelocityReceiver::step(const Eigen::Vector2d& velocity, bool in_shadow, double time,
                                                 double duration) {
  lagging_.send(velocity, time + parameters_.lag);
  for (const Eigen::Vector2d& then : lagging_.take(time)) told_ = then;
  slow_.step(duration, random_);
  const auto due = periods(time, parameters_.rate);
  if (due <= emitted_) return under_way_.take(time);
  emitted_ = due;
  GnssVelocity made;
  made.stamp = time;
  made.velocity = told_ + slow_.value() + normal2(random_, parameters_.white_sigma);
  const double share = in_shadow ? parameters_.outlier_share_shadow : parameters_.outlier_share;
  if (random_.uniform() < share) made.velocity += normal2(random_, parameters_.outlier_sigma);
  made.covariance = square(parameters_.declared_sigma) * Eigen::Matrix2d::Identity();
  if (const auto spoilt = faults_.spoil(time, {made.velocity.x(), made.velocity.y(), 0.0})) {
    made.velocity = spoilt->value.head<2>();
    under_way_.send(made, time + parameters_.latency + spoilt->delay);
  }
  return under_way_.take(time);
}

}  // namespace multipath_localization
