#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "simulation/delivery_queue.hpp"
#include "simulation/sensor_faults.hpp"

namespace multipath_localization {

struct CompassParameters {
  double rate = 0.0;
  double offset = 0.0;
  double noise = 0.02;
  double declared_sigma = 0.02;
  double outlier_share = 0.01;

  void fields(ParameterVisitor& field);
};

/// What tells the heading: a compass, or a receiver with two antennas.
class Compass {
 public:
  Compass(const CompassParameters& parameters, const std::vector<SensorFault>& faults, std::uint64_t seed);

  /// Watches one step that ended at `time` [s] with the base at a yaw [rad]. Returns the headings delivered
  /// by now, spoilt by the faults.
  std::vector<Heading> step(double yaw, double time);

 private:
  CompassParameters parameters_;
  SensorFaults faults_;
  std::uint64_t seed_;
  std::uint32_t steps_ = 0;
  std::int64_t emitted_ = 0;
  DeliveryQueue<Heading> under_way_;
};

}  // namespace multipath_localization
