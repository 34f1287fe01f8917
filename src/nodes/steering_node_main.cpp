#include "nodes/parameter_server.hpp"
#include "nodes/steering_node.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "steering");
  const ros::NodeHandle own("~");
  try {
    const auto settings =
        multipath_localization::SteeringSettings::from(multipath_localization::read_parameters(own));
    const multipath_localization::SteeringNode steering(ros::NodeHandle(), own, settings);
    ros::spin();
  } catch (const multipath_localization::ParameterError& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
  return 0;
}
