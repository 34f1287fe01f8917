#include "ros/localization_node/restart_requests.hpp"

#include <ros/console.h>

#include <utility>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

RestartRequests::RestartRequests(ros::NodeHandle node, ros::NodeHandle private_node, std::string map_frame,
                                 const Datum& datum, Answers answers)
    : map_frame_(std::move(map_frame)), datum_(datum), answers_(std::move(answers)) {
  initial_pose_ = node.subscribe("initialpose", 5, &RestartRequests::on_pose, this);
  pose_to_set_ = node.subscribe("set_pose", 5, &RestartRequests::on_pose, this);
  set_pose_ = node.advertiseService("set_pose", &RestartRequests::on_set_pose, this);
  global_localization_ = node.advertiseService("global_localization", &RestartRequests::on_reset, this);
  reset_ = private_node.advertiseService("reset", &RestartRequests::on_reset, this);
  toggle_ = private_node.advertiseService("toggle", &RestartRequests::on_toggle, this);
}

bool RestartRequests::set_pose(const Pose& message) {
  const std::string frame = without_slash(message.header.frame_id);
  const std::optional<PosePrior> prior = to_prior(message);
  if (!frame.empty() && frame != map_frame_) {
    ROS_WARN("pose refused: it is given in %s, not in %s", shown(frame).c_str(), map_frame_.c_str());
  } else if (!prior) {
    ROS_WARN("pose refused: %s", defect_of(message).c_str());
  } else if (!datum_.map()) {
    ROS_WARN("pose refused: map has no datum yet; set the parameter datum or wait for the first fix");
  } else {
    answers_.start_at(*prior);
    return true;
  }
  return false;
}

bool RestartRequests::on_reset(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
  answers_.start_anew("asked to");
  return true;
}

bool RestartRequests::on_toggle(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  if (request.data && !enabled_) answers_.start_anew("switched on");
  enabled_ = request.data;
  if (!enabled_) answers_.pause();
  response.success = true;
  response.message = enabled_ ? "on" : "off: nothing is read or published";
  return true;
}

}  // namespace multipath_localization
