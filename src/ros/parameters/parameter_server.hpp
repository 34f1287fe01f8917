#pragma once

#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

#include <string>

namespace multipath_localization {

/// The value as YAML: structs as maps, arrays as lists, numbers without loss. Throws ParameterError naming
/// `path` on a date or binary value.
YAML::Node to_yaml(XmlRpc::XmlRpcValue value, const std::string& path = "");

/// Everything in the namespace of `node` (for `ros::NodeHandle("~")` the node's private parameters), null
/// when there is nothing. The only reader of the parameter server; `load()` checks what comes out.
YAML::Node read_parameters(const ros::NodeHandle& node);

}  // namespace multipath_localization
