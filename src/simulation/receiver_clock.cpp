#include "simulation/receiver_clock.hpp"

#include <cmath>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

void ReceiverClockParameters::fields(ParameterVisitor& field) {
  field("drift_sigma", drift_sigma, {0.0, 1e4}, "m/s", "spread of the drift at the start, by seed");
  field("drift_walk", drift_walk, {0.0, 1e3}, "m/s/sqrt(s)", "random walk of the drift");
  field(
      "steer", steer, {1e-6, 1.0}, "s",
      "the clock is put back by this as soon as it is off by half of it; at the start it is off by any less");
}

ReceiverClock::ReceiverClock(const ReceiverClockParameters& parameters, std::uint64_t seed)
    : parameters_(parameters), seed_(seed) {
  RandomStream random(seed_, 0, kReceiverClockStream);
  bias_ = (random.uniform() - 0.5) * parameters_.steer * kSpeedOfLight;
  drift_ = parameters_.drift_sigma * random.normal();
}

void ReceiverClock::step(double duration) {
  RandomStream random(seed_, ++steps_, kReceiverClockStream);
  bias_ += drift_ * duration;
  drift_ += parameters_.drift_walk * std::sqrt(duration) * random.normal();
  const double steer = parameters_.steer * kSpeedOfLight;
  bias_ -= steer * std::round(bias_ / steer);
}

}  // namespace multipath_localization
