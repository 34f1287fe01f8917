#include "ros/steering_node/safety_inputs.hpp"

#include <cmath>

#include "ros/inputs/antenna_frames.hpp"
#include "ros/messages/conversions.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

SafetyInputs::SafetyInputs(ros::NodeHandle node, const SteeringNodeParameters& parameters)
    : parameters_(parameters.safety), base_frame_(parameters.base_link_frame) {
  stop_in_ = node.subscribe<std_msgs::Bool>(
      "emergency_stop", 10, [this](const std_msgs::BoolConstPtr& message) { take_stop(message->data != 0); });
  if (!parameters_.stop_before_obstacles) return;
  frames_ = std::make_unique<tf2_ros::Buffer>();
  tf_ = std::make_unique<tf2_ros::TransformListener>(*frames_);
  scan_in_ = node.subscribe<sensor_msgs::LaserScan>(
      "scan", 1, [this](const sensor_msgs::LaserScanConstPtr& message) { take_scan(*message); });
}

void SafetyInputs::take_stop(bool asked) {
  stop_asked_ = asked;
  stop_arrived_ = ros::SteadyTime::now();
}

void SafetyInputs::take_scan(const sensor_msgs::LaserScan& scan) {
  scan_arrival_ = {scan.header.stamp, ros::SteadyTime::now()};
  const std::string frame = without_slash(scan.header.frame_id);
  try {
    const auto scanner = to_isometry(frames_->lookupTransform(base_frame_, frame, ros::Time(0)).transform);
    scan_ = scanner ? scan_points(scan, *scanner, parameters_.footprint) : ScanPoints{{}, "scan of no place"};
  } catch (const tf2::TransformException&) {
    scan_ = {{}, "no transform from " + shown(frame) + " to " + base_frame_};
  }
}

std::string SafetyInputs::fault_of_scan(double age) const {
  if (!parameters_.stop_before_obstacles) return "";
  if (std::isnan(age)) return "no scan yet";
  if (!(std::abs(age) <= parameters_.max_scan_age))
    return "scan is " + fixed_text(std::abs(age), 1) + " s old";
  return scan_.fault;
}

Hazards SafetyInputs::hazards(const std::vector<Pose2>& way, const CommandLimiter& limiter,
                              const Moment& now) const {
  Hazards hazards;
  hazards.stop_asked = stop_asked_;
  if (!stop_arrived_.isZero()) hazards.stop_input_age = (now.steady - stop_arrived_).toSec();
  const double age = scan_arrival_.age(now);
  hazards.scan_fault = fault_of_scan(age);
  if (!parameters_.stop_before_obstacles || !hazards.scan_fault.empty() || way.empty()) return hazards;
  const Pose2 scan_in_map = way.front() * inverse(limiter.carried_forward({}, age));
  std::vector<Eigen::Vector2d> obstacles;
  for (const Eigen::Vector2d& point : scan_.in_base) obstacles.push_back(scan_in_map * point);
  hazards.free_way = free_way(way, parameters_.footprint, obstacles);
  hazards.free_to_turn = free_to_turn(way.front(), parameters_.footprint, obstacles);
  return hazards;
}

}  // namespace multipath_localization
