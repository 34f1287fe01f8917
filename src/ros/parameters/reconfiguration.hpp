#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/node_handle.h>

#include "ros/parameters/config_messages.hpp"

namespace multipath_localization {

/// A server for clients of dynamic_reconfigure, as rqt_reconfigure and dynparam are. What is set is written
/// to the parameter server as well, where the next start finds it.
class Reconfiguration {
 public:
  /// `visit` shows the parameters to a visitor that may change them, at any time between two callbacks.
  Reconfiguration(ros::NodeHandle private_node, VisitParameters visit);

 private:
  bool on_set(dynamic_reconfigure::Reconfigure::Request& request,
              dynamic_reconfigure::Reconfigure::Response& response);

  ros::NodeHandle node_;
  VisitParameters visit_;
  ros::Publisher descriptions_, updates_;
  ros::ServiceServer set_;
};

}  // namespace multipath_localization
