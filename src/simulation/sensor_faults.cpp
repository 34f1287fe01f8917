#include "multipath_localization/simulation/sensor_faults.hpp"

#include <limits>

#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

namespace {

Eigen::Vector3d normal3(RandomStream& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return {x, y, z};
}

}  // namespace

void SensorFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field("kind", kind, {"silent", "frozen", "reversed", "noisy", "late", "not_finite"},
        "silent: nothing comes; frozen: the first value again and again; reversed: of the other sign; noisy: "
        "white noise on top; late; not_finite: NaN");
  field("size", size, {0.0, 1e3}, "rad/s, m/s, s", "noisy: 1 sigma in the input's unit; late: by this [s]");
}

std::optional<SensorFaults::Spoilt> SensorFaults::spoil(double stamp, const Eigen::Vector3d& value) {
  RandomStream random(seed_, messages_++, stream_);
  Spoilt spoilt{value, 0.0};
  bool freezes = false;
  for (const SensorFault& fault : faults_) {
    if (!fault.holds(stamp - start_)) continue;
    if (fault.kind == "silent") return std::nullopt;
    if (fault.kind == "frozen") freezes = true;
    if (fault.kind == "reversed") spoilt.value = -spoilt.value;
    if (fault.kind == "noisy") spoilt.value += fault.size * normal3(random);
    if (fault.kind == "late") spoilt.delay += fault.size;
    if (fault.kind == "not_finite") spoilt.value.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  if (!freezes) {
    frozen_.reset();
  } else if (!frozen_) {
    frozen_ = spoilt.value;
  } else {
    spoilt.value = *frozen_;
  }
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
