#include "simulation/sensor_faults.hpp"

#include <algorithm>
#include <limits>

#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

namespace {

Eigen::Vector3d normal3(RandomStream& random) {
  const double x = random.normal();
  const double y = random.normal();
  return {x, y, random.normal()};
}

/// What a fault makes of a value that is sent all the same.
void apply(const SensorFault& fault, RandomStream& random, SensorFaults::Spoilt& spoilt) {
  if (fault.kind == "reversed") spoilt.value = -spoilt.value;
  if (fault.kind == "offset") spoilt.value.array() += fault.size;
  if (fault.kind == "noisy") spoilt.value += fault.size * normal3(random);
  if (fault.kind == "late") spoilt.delay += fault.size;
  if (fault.kind == "not_finite") spoilt.value.setConstant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

void SensorFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field(
      "kind", kind, {"silent", "frozen", "reversed", "offset", "noisy", "late", "not_finite"},
      "silent: nothing comes; frozen: the first value again and again; reversed: of the other sign; offset: "
      "always off by as much; noisy: white noise on top; late; not_finite: NaN");
  field("size", size, {0.0, 1e3}, "rad/s, m/s, rad, s",
        "offset: of each component, and noisy: 1 sigma, in the input's unit; late: by this [s]");
}

std::optional<SensorFaults::Spoilt> SensorFaults::spoil(double stamp, const Eigen::Vector3d& value) {
  RandomStream random(seed_, messages_++, stream_);
  Spoilt spoilt{value, 0.0};
  const auto holds = [&](const char* kind) {
    return std::any_of(faults_.begin(), faults_.end(), [&](const SensorFault& fault) {
      return fault.kind == kind && fault.holds(stamp - start_);
    });
  };
  if (holds("silent")) return std::nullopt;
  for (const SensorFault& fault : faults_) {
    if (fault.holds(stamp - start_)) apply(fault, random, spoilt);
  }
  if (!holds("frozen")) {
    frozen_.reset();
    return spoilt;
  }
  if (!frozen_) frozen_ = spoilt.value;
  spoilt.value = *frozen_;
  return spoilt;
}

std::vector<std::string> SensorFaults::active(double now) const {
  std::vector<std::string> all;
  for (const SensorFault& fault : faults_) {
    if (fault.holds(now - start_)) all.push_back(what_ + ": " + fault.kind);
  }
  return all;
}

}  // namespace multipath_localization
