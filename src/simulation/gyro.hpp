#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "simulation/delivery_queue.hpp"
#include "simulation/sensor_faults.hpp"

namespace multipath_localization {

struct GyroParameters {
  double rate = 0.0;
  double bias = 0.0;
  double bias_sigma = 0.003;
  double noise = 5e-4;
  double scale_error = 0.0;

  void fields(ParameterVisitor& field);
};

/// A gyro beside the odometry.
class Gyro {
 public:
  Gyro(const GyroParameters& parameters, const std::vector<SensorFault>& faults, std::uint64_t seed);

  /// Watches one step that ended at `time` [s], over which the robot turned at `yaw_rate` [rad/s]. Returns
  /// the samples delivered by now, spoilt by the faults.
  std::vector<YawRate> step(double yaw_rate, double time);

 private:
  GyroParameters parameters_;
  SensorFaults faults_;
  std::uint64_t seed_;
  double bias_;
  std::uint32_t steps_ = 0;
  std::int64_t emitted_ = 0;
  DeliveryQueue<YawRate> under_way_;
};

}  // namespace multipath_localization
