#include "simulation/compass.hpp"

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/periods.hpp"
#include "simulation/streams.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

void CompassParameters::fields(ParameterVisitor& field) {
  field("rate", rate, {0.0, 1e4}, "Hz", "at most one heading per simulation step; 0: there is none");
  field("offset", offset, {-3.2, 3.2}, "rad", "constant error, of the mounting");
  field("noise", noise, {0.0, 3.2}, "rad", "white");
  field("declared_sigma", declared_sigma, {0.0, 3.2}, "rad", "what it claims");
  field("outlier_share", outlier_share, {0.0, 1.0}, "1", "of those that are any");
}

Compass::Compass(const CompassParameters& parameters, const std::vector<SensorFault>& faults,
                 std::uint64_t seed)
    : parameters_(parameters), faults_(faults, "heading", seed, kHeadingFaultStream), seed_(seed) {}

std::vector<Heading> Compass::step(double yaw, double time) {
  ++steps_;
  const auto due = periods(time, parameters_.rate);
  if (due > emitted_) {
    RandomStream random(seed_, steps_, kCompassStream);
    const bool outlier = random.uniform() < parameters_.outlier_share;
    const double any = kPi * (2.0 * random.uniform() - 1.0);
    const double told = yaw + parameters_.offset + parameters_.noise * random.normal();
    const auto spoilt = faults_.spoil(time, {0.0, 0.0, outlier ? any : told});
    if (spoilt) {
      const double read = wrap_angle(spoilt->value.z());
      under_way_.send({time, read, square(parameters_.declared_sigma)}, time + spoilt->delay);
    }
  }
  emitted_ = due;
  return under_way_.take(time);
}

}  // namespace multipath_localization
