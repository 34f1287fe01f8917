#pragma once

#include <sensor_msgs/NavSatFix.h>

#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

/// A map frame to read fixes in.
inline const LocalFrame& berlin() {
  static const LocalFrame frame(Geodetic{52.5, 13.4, 40.0});
  return frame;
}

/// A fix with nothing wrong about it, near that frame's datum.
inline sensor_msgs::NavSatFix good_fix() {
  sensor_msgs::NavSatFix fix;
  fix.header.stamp = ros::Time(100, 500000000);
  fix.header.frame_id = "gps";
  fix.status.status = 0;
  fix.latitude = 52.501;
  fix.longitude = 13.402;
  fix.altitude = 45.0;
  fix.position_covariance = {4.0, 1.0, 0.0, 1.0, 9.0, 0.0, 0.0, 0.0, 16.0};
  fix.position_covariance_type = 3;
  return fix;
}

}  // namespace multipath_localization
