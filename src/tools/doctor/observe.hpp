#pragma once

#include <string>

#include "tools/doctor/observations.hpp"

namespace multipath_localization {

/// Where to look; names of topics with or without leading slash.
struct ObservationRequest {
  std::string fix_topic = "gps/fix";
  std::string odometry_topic = "odom";
  std::string imu_topic = "imu/data";
  std::string velocity_topic = "gps/velocity";
  std::string heading_topic = "heading";
  std::string parameters;              ///< YAML of localization_node, for frames and datum; empty: none
  std::string node = "/localization";  ///< live: the node whose parameters count
  double seconds = 10.0;               ///< live: to watch for
};

/// Everything the checks want of a bag. Throws DriveError and ParameterError.
Observations observe_bag(const std::string& file, const ObservationRequest& request);

/// The same of running nodes; needs ros::init. Throws ParameterError.
Observations observe_live(const ObservationRequest& request);

}  // namespace multipath_localization
