#include "ros/localization_node/odometry_input.hpp"

#include <ros/console.h>

#include <utility>

namespace multipath_localization {

namespace {

constexpr std::uint32_t kQueue = 5000;  ///< seconds of odometry at 1 kHz

}  // namespace

OdometryInput::OdometryInput(ros::NodeHandle node, const OdometryParameters& parameters,
                             const std::string& map_frame, Take take)
    : reader_(parameters, map_frame),
      take_(std::move(take)),
      monitor_("odom",
               {node.subscribe("odom", kQueue, &OdometryInput::on_odometry, this,
                               ros::TransportHints().tcpNoDelay())},
               true) {}

CheckedOdometry OdometryInput::read(const nav_msgs::Odometry& message) {
  monitor_.arrived();
  CheckedOdometry checked = reader_.read(message);
  monitor_.count(checked.reason);
  if (checked.reason == Reason::kAccepted) return checked;
  if (const std::string why = monitor_.complaint(); !why.empty()) ROS_WARN("%s", why.c_str());
  return checked;
}

}  // namespace multipath_localization
