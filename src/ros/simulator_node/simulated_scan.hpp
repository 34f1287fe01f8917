#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <string>
#include <vector>

#include "multipath_localization/core/pose.hpp"
#include "simulation/laser.hpp"

namespace multipath_localization {

/// A laser scanner among the buildings, on the topic `scan`; no topic where its rate is 0.
class SimulatedScan {
 public:
  SimulatedScan(ros::NodeHandle node, const LaserParameters& parameters,
                const std::vector<BuildingParameters>& buildings, std::uint64_t seed, std::string frame);

  /// Publishes a scan from `truth` in map, where one is due at `time` of the simulation [s].
  void step(const Pose2& truth, double time, const ros::Time& stamp);

 private:
  LaserParameters parameters_;
  Laser laser_;
  std::string frame_;
  ros::Publisher scan_;
};

}  // namespace multipath_localization
