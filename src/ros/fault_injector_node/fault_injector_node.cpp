#include "ros/fault_injector_node/fault_injector_node.hpp"

#include <std_msgs/String.h>

namespace multipath_localization {

namespace {

constexpr std::uint32_t kQueue = 200;

}  // namespace

FaultInjectorNode::FaultInjectorNode(ros::NodeHandle node, ros::NodeHandle private_node,
                                     const FaultInjectorParameters& parameters)
    : injector_(parameters) {
  fix_out_ = node.advertise<sensor_msgs::NavSatFix>("gps/fix_spoiled", kQueue);
  imu_out_ = node.advertise<sensor_msgs::Imu>("imu/data_spoiled", kQueue);
  velocity_out_ = node.advertise<geometry_msgs::TwistWithCovarianceStamped>("gps/velocity_spoiled", kQueue);
  heading_out_ = node.advertise<sensor_msgs::Imu>("heading_spoiled", kQueue);
  odometry_out_ = node.advertise<nav_msgs::Odometry>("odom_spoiled", kQueue);
  faults_ = private_node.advertise<std_msgs::String>("faults", 1, true);
  publish({});
  fix_in_ = node.subscribe<sensor_msgs::NavSatFix>(
      "gps/fix", kQueue,
      [this](const sensor_msgs::NavSatFixConstPtr& message) { publish(injector_.take(*message)); });
  imu_in_ =
      node.subscribe<sensor_msgs::Imu>("imu/data", kQueue, [this](const sensor_msgs::ImuConstPtr& message) {
        for (const sensor_msgs::Imu& spoilt : injector_.take(*message)) imu_out_.publish(spoilt);
      });
  using Velocity = geometry_msgs::TwistWithCovarianceStamped;
  velocity_in_ = node.subscribe<Velocity>("gps/velocity", kQueue, [this](const Velocity::ConstPtr& message) {
    for (const Velocity& spoilt : injector_.take(*message)) velocity_out_.publish(spoilt);
  });
  heading_in_ =
      node.subscribe<sensor_msgs::Imu>("heading", kQueue, [this](const sensor_msgs::ImuConstPtr& message) {
        for (const sensor_msgs::Imu& spoilt : injector_.take_heading(*message)) heading_out_.publish(spoilt);
      });
  odometry_in_ =
      node.subscribe<nav_msgs::Odometry>("odom", kQueue, [this](const nav_msgs::OdometryConstPtr& message) {
        std::vector<sensor_msgs::NavSatFix> fixes;
        const std::optional<nav_msgs::Odometry> spoilt = injector_.take(*message, fixes);
        if (spoilt) odometry_out_.publish(*spoilt);
        publish(fixes);
      });
}

void FaultInjectorNode::publish(const std::vector<sensor_msgs::NavSatFix>& fixes) {
  for (const sensor_msgs::NavSatFix& fix : fixes) fix_out_.publish(fix);
  std_msgs::String active;
  active.data = injector_.active();
  if (active.data == told_) return;
  told_ = active.data;
  faults_.publish(active);
}

}  // namespace multipath_localization
