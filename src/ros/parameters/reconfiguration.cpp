#include "ros/parameters/reconfiguration.hpp"

#include <ros/console.h>

#include <utility>

namespace multipath_localization {

namespace {

void write(const ros::NodeHandle& node, const dynamic_reconfigure::Config& config) {
  for (const auto& parameter : config.doubles) node.setParam(parameter.name, parameter.value);
  for (const auto& parameter : config.ints) node.setParam(parameter.name, parameter.value);
  for (const auto& parameter : config.strs) node.setParam(parameter.name, parameter.value);
  for (const auto& parameter : config.bools) node.setParam(parameter.name, parameter.value != 0);
}

}  // namespace

Reconfiguration::Reconfiguration(ros::NodeHandle private_node, VisitParameters visit)
    : node_(std::move(private_node)),
      visit_(std::move(visit)),
      descriptions_(
          node_.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true)),
      updates_(node_.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, true)),
      set_(node_.advertiseService("set_parameters", &Reconfiguration::on_set, this)) {
  descriptions_.publish(to_description(visit_));
  updates_.publish(to_config(visit_));
}

bool Reconfiguration::on_set(dynamic_reconfigure::Reconfigure::Request& request,
                             dynamic_reconfigure::Reconfigure::Response& response) {
  for (const std::string& name : set_parameters(request.config, visit_)) {
    ROS_WARN("parameter %s is not changed: unknown, or not such a value", name.c_str());
  }
  response.config = to_config(visit_);
  write(node_, response.config);
  updates_.publish(response.config);
  return true;
}

}  // namespace multipath_localization
