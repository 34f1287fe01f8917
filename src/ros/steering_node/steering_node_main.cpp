#include "ros/parameters/parameter_server.hpp"
#include "ros/steering_node/graceful_shutdown.hpp"
#include "ros/steering_node/steering_node.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "steering", ros::init_options::NoSigintHandler);
  const ros::NodeHandle own("~");
  try {
    const auto settings =
        multipath_localization::SteeringSettings::from(multipath_localization::read_parameters(own));
    multipath_localization::SteeringNode steering(ros::NodeHandle(), own, settings);
    multipath_localization::spin_until_shutdown([&] { steering.halt(); });
  } catch (const multipath_localization::ParameterError& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
  return 0;
}
