#include "tools/live/node_process.hpp"

#include <XmlRpcClient.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace multipath_localization {

namespace {

int process_id(const std::string& node) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  std::string host;
  std::uint32_t port = 0;
  if (ros::master::execute("lookupNode", request, response, uri, false) &&
      ros::network::splitURI(static_cast<std::string>(uri), host, port)) {
    XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
    if (client.execute("getPid", request[0], response)) return static_cast<int>(response[2]);
  }
  throw std::runtime_error("no node " + node);
}

/// The fields of /proc/PID/`name` that follow the first `skipped` after `lead`.
std::istringstream fields_of(int pid, const std::string& name, char lead, int skipped) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/" + name);
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(text.rfind(lead) + 1));
  std::string skip;
  for (int field = 0; field < skipped; ++field) fields >> skip;
  return fields;
}

}  // namespace

NodeProcess::NodeProcess(const std::string& node) : pid_(process_id(node)) {}

double NodeProcess::cpu_time() const {
  std::istringstream fields = fields_of(pid_, "stat", ')', 11);
  double user = 0.0;
  double system = 0.0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double NodeProcess::resident_memory() const {
  std::istringstream fields = fields_of(pid_, "statm", '\n', 1);
  double pages = 0.0;
  fields >> pages;
  return 1e-6 * pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace multipath_localization
