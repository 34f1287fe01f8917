#include "rinex/line_reader.hpp"
#include "ros/gnss_receiver_node/gnss_receiver_node.hpp"
#include "ros/parameters/parameter_server.hpp"

int main(int argc, char** argv) {
  using namespace multipath_localization;
  ros::init(argc, argv, "gnss_receiver");
  try {
    GnssReceiverParameters parameters;
    load(read_parameters(ros::NodeHandle("~")), parameters);
    GnssReceiverNode node(ros::NodeHandle(), parameters);
    node.spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
