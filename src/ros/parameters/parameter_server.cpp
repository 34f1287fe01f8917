#include "ros/parameters/parameter_server.hpp"

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

YAML::Node map_of(XmlRpc::XmlRpcValue& value, const std::string& path) {
  YAML::Node map(YAML::NodeType::Map);
  for (auto& [key, item] : value) map[key] = to_yaml(item, path.empty() ? key : path + "/" + key);
  return map;
}

YAML::Node list_of(XmlRpc::XmlRpcValue& value, const std::string& path) {
  YAML::Node list(YAML::NodeType::Sequence);
  for (int i = 0; i < value.size(); ++i)
    list.push_back(to_yaml(value[i], path + "[" + std::to_string(i) + "]"));
  return list;
}

}  // namespace

YAML::Node to_yaml(XmlRpc::XmlRpcValue value, const std::string& path) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeInvalid: return YAML::Node();
    case XmlRpc::XmlRpcValue::TypeBoolean: return YAML::Node(static_cast<bool>(value));
    case XmlRpc::XmlRpcValue::TypeInt: return YAML::Node(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble: return YAML::Node(static_cast<double>(value));
    case XmlRpc::XmlRpcValue::TypeString: return YAML::Node(static_cast<std::string>(value));
    case XmlRpc::XmlRpcValue::TypeArray: return list_of(value, path);
    case XmlRpc::XmlRpcValue::TypeStruct: return map_of(value, path);
    case XmlRpc::XmlRpcValue::TypeDateTime:
    case XmlRpc::XmlRpcValue::TypeBase64: break;
  }
  throw ParameterError(path + " is a date or binary, which no parameter is");
}

YAML::Node read_parameters(const ros::NodeHandle& node) {
  XmlRpc::XmlRpcValue value;
  if (!node.getParam(node.getNamespace(), value)) return YAML::Node();
  return to_yaml(value);
}

}  // namespace multipath_localization
