#include "ros/fault_injector_node/fault_injector_node.hpp"
#include "ros/parameters/parameter_server.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "fault_injector");
  const ros::NodeHandle own("~");
  try {
    multipath_localization::FaultInjectorParameters parameters;
    load(multipath_localization::read_parameters(own), parameters);
    const multipath_localization::FaultInjectorNode injector(ros::NodeHandle(), own, parameters);
    ros::spin();
  } catch (const multipath_localization::ParameterError& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
  return 0;
}
