#pragma once

#include <sensor_msgs/LaserScan.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "multipath_localization/guidance/footprint.hpp"

namespace multipath_localization {

/// What a scanner sees around the robot.
struct ScanPoints {
  std::vector<Eigen::Vector2d> in_base;  ///< seen from above [m]
  std::string fault;                     ///< why the scan cannot be driven by; empty where it can
};

/// The obstacles of a scan, for a scanner mounted there on the base. By REP 117 infinity is a free beam,
/// minus infinity something nearer than `range_min`, which counts as being there; NaN tells nothing, and a
/// scan of that alone is one of a blind scanner. What lies in the outline of the robot is the robot.
ScanPoints scan_points(const sensor_msgs::LaserScan& scan, const Eigen::Isometry3d& scanner_in_base,
                       const Footprint& robot);

}  // namespace multipath_localization
