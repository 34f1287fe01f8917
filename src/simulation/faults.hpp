#pragma once

#include <vector>

#include "simulation/fix_faults.hpp"
#include "simulation/odometry_faults.hpp"
#include "simulation/sensor_faults.hpp"

namespace multipath_localization {

/// What goes wrong between the sensors and whoever uses them.
struct FaultParameters {
  FixFaultParameters fix;
  OdometryFaultParameters odometry;
  std::vector<SensorFault> gyro;
  std::vector<SensorFault> velocity;
  std::vector<SensorFault> heading;

  void fields(ParameterVisitor& field) {
    field.group("fix", fix, "fixes of a single antenna");
    field.group("odometry", odometry, "wheel odometry");
    field.list("gyro", gyro, "yaw rates of a gyro beside the odometry, `size` in rad/s");
    field.list("velocity", velocity, "velocities of a receiver, `size` in m/s");
    field.list("heading", heading, "headings of a compass or of two antennas, `size` in rad");
  }
};

}  // namespace multipath_localization
