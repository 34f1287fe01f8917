#pragma once

#include <ros/node_handle.h>

#include "multipath_localization/localization/localizer.hpp"
#include "ros/localization_node/gnss_inputs.hpp"
#include "ros/localization_node/gyro_input.hpp"
#include "ros/localization_node/localization_diagnostics.hpp"
#include "ros/localization_node/tilt_input.hpp"

namespace multipath_localization {

/// Reports now and then, on /diagnostics and on the console, what comes in, and what is waited for.
class PeriodicReports {
 public:
  /// What it looks at; all has to outlive it.
  struct Parts {
    LocalizationDiagnostics& diagnostics;
    GnssInputs& gnss;
    const InputMonitor& odometry;
    GyroInput& gyro;
    TiltInput& tilt;
    const Localizer& localizer;
    const bool& enabled;  ///< inputs are waited for
  };
  PeriodicReports(ros::NodeHandle node, const Parts& parts);

  /// What became of each input, as the node ends: roscpp's console is closed by then.
  void tell_sums() const;

 private:
  void report();
  void tell_what_is_missing() const;

  Parts parts_;
  ros::WallTimer report_timer_, missing_timer_;
};

}  // namespace multipath_localization
