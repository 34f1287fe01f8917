#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include "multipath_localization/core/parameters.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/parameters/parameter_server.hpp"

namespace multipath_localization {
namespace {

struct TfFilterParameters {
  std::string drop_child_frame = "odom";

  void fields(ParameterVisitor& field) {
    field("drop_child_frame", drop_child_frame, {}, "transforms that give this frame a parent are dropped");
  }
};

/// Relays tf_in to tf_out without the transforms that another localisation recorded.
void run(ros::NodeHandle node, const std::string& dropped) {
  const ros::Publisher out = node.advertise<tf2_msgs::TFMessage>("tf_out", 100);
  const boost::function<void(const tf2_msgs::TFMessage&)> relay = [&](const tf2_msgs::TFMessage& in) {
    tf2_msgs::TFMessage kept;
    for (const auto& transform : in.transforms) {
      if (without_slash(transform.child_frame_id) != dropped) kept.transforms.push_back(transform);
    }
    if (!kept.transforms.empty()) out.publish(kept);
  };
  const ros::Subscriber in = node.subscribe<tf2_msgs::TFMessage>("tf_in", 100, relay);
  ros::spin();
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  namespace ml = multipath_localization;
  ros::init(argc, argv, "tf_filter");
  try {
    ml::TfFilterParameters parameters;
    ml::load(ml::read_parameters(ros::NodeHandle("~")), parameters);
    ml::run(ros::NodeHandle(), parameters.drop_child_frame);
  } catch (const ml::ParameterError& error) {
    ROS_FATAL("%s: %s", ros::this_node::getName().c_str(), error.what());
    return 1;
  }
  return 0;
}
