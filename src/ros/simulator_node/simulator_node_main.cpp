#include "ros/parameters/parameter_server.hpp"
#include "ros/simulator_node/simulator_node.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "simulator");
  const ros::NodeHandle own("~");
  try {
    multipath_localization::SimulatorNodeParameters parameters;
    load(multipath_localization::read_parameters(own), parameters);
    const multipath_localization::SimulatorNode simulator(ros::NodeHandle(), own, parameters);
    ros::spin();
  } catch (const multipath_localization::ParameterError& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
  return 0;
}
