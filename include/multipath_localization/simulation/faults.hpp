#pragma once

#include "multipath_localization/simulation/fix_faults.hpp"
#include "multipath_localization/simulation/odometry_faults.hpp"

namespace multipath_localization {

/// What goes wrong between the sensors and whoever uses them.
struct FaultParameters {
  FixFaultParameters fix;
  OdometryFaultParameters odometry;

  void fields(ParameterVisitor& field) {
    field.group("fix", fix, "fixes of a single antenna");
    field.group("odometry", odometry, "wheel odometry");
  }
};

}  // namespace multipath_localization
