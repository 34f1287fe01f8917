#include <ros/ros.h>

#include "ros/localization_node/localization_node.hpp"
#include "ros/parameters/parameter_server.hpp"

int main(int argc, char** argv) {
  namespace ml = multipath_localization;
  ros::init(argc, argv, "localization_node");
  const ros::NodeHandle private_node("~");
  try {
    const ml::LocalizationSettings settings =
        ml::LocalizationSettings::from(ml::read_parameters(private_node));
    ml::LocalizationNode node(ros::NodeHandle(), private_node, settings);
    node.spin();
  } catch (const ml::ParameterError& error) {
    ROS_FATAL("%s: %s", ros::this_node::getName().c_str(), error.what());
    return 1;
  }
  return 0;
}
