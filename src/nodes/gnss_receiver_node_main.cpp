#include "multipath_localization/rinex/line_reader.hpp"
#include "nodes/gnss_receiver_node.hpp"
#include "nodes/parameter_server.hpp"

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
