#include "ros/parameters/parameter_server.hpp"
#include "ros/wheel_odometry_node/wheel_odometry_node.hpp"

int main(int argc, char** argv) {
  using namespace multipath_localization;
  ros::init(argc, argv, "wheel_odometry");
  try {
    WheelOdometryParameters parameters;
    load(read_parameters(ros::NodeHandle("~")), parameters);
    const WheelOdometryNode node(ros::NodeHandle(), parameters);
    ros::spin();
  } catch (const ParameterError& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
