#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/node_handle.h>
#include <std_srvs/Empty.h>
#include <std_srvs/SetBool.h>

#include <functional>
#include <string>

#include "multipath_localization/SetPose.h"
#include "multipath_localization/core/estimate.hpp"
#include "ros/map/datum.hpp"

namespace multipath_localization {

/// What others ask of the estimator: to start at a pose (topics `initialpose` and `set_pose`, service
/// `set_pose`) or from nothing (services `global_localization` and `~reset`), or to pause (`~toggle`).
class RestartRequests {
 public:
  struct Answers {
    std::function<void(const PosePrior&)> start_at;
    std::function<void(const std::string& why)> start_anew;
    std::function<void()> pause;
  };
  /// A pose is refused, with a warning, that is not in `map_frame`, and while map has no `datum`.
  RestartRequests(ros::NodeHandle node, ros::NodeHandle private_node, std::string map_frame,
                  const Datum& datum, Answers answers);

  /// Whether the node is not paused. The reference holds as long as this object.
  [[nodiscard]] const bool& enabled() const { return enabled_; }

 private:
  using Pose = geometry_msgs::PoseWithCovarianceStamped;
  void on_pose(const Pose::ConstPtr& message) { set_pose(*message); }
  bool on_set_pose(SetPose::Request& request, SetPose::Response&) { return set_pose(request.pose); }
  bool on_reset(std_srvs::Empty::Request&, std_srvs::Empty::Response&);
  bool on_toggle(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool set_pose(const Pose& message);

  std::string map_frame_;
  const Datum& datum_;
  Answers answers_;
  bool enabled_ = true;
  ros::Subscriber initial_pose_, pose_to_set_;
  ros::ServiceServer reset_, global_localization_, toggle_, set_pose_;
};

}  // namespace multipath_localization
