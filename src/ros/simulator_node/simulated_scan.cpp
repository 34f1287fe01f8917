#include "ros/simulator_node/simulated_scan.hpp"

#include <sensor_msgs/LaserScan.h>

#include <utility>

namespace multipath_localization {

SimulatedScan::SimulatedScan(ros::NodeHandle node, const LaserParameters& parameters,
                             const std::vector<BuildingParameters>& buildings, std::uint64_t seed,
                             std::string frame)
    : parameters_(parameters), laser_(parameters, buildings, seed), frame_(std::move(frame)) {
  if (parameters_.rate > 0.0) scan_ = node.advertise<sensor_msgs::LaserScan>("scan", 10);
}

void SimulatedScan::step(const Pose2& truth, double time, const ros::Time& stamp) {
  if (!laser_.due(time)) return;
  sensor_msgs::LaserScan message;
  message.header.stamp = stamp;
  message.header.frame_id = frame_;
  message.angle_min = static_cast<float>(-kPi);
  message.angle_increment = static_cast<float>(laser_.increment());
  message.angle_max = static_cast<float>(kPi - laser_.increment());
  message.scan_time = static_cast<float>(1.0 / parameters_.rate);
  message.range_min = static_cast<float>(parameters_.range_min);
  message.range_max = static_cast<float>(parameters_.range_max);
  message.ranges = laser_.scan(truth);
  scan_.publish(message);
}

}  // namespace multipath_localization
