#pragma once

#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <string>

#include "ros/inputs/antenna_frames.hpp"

namespace multipath_localization {

/// What other nodes say on /tf: where antennas are on the base, and who else broadcasts our transforms.
class TfWatch {
 public:
  TfWatch(ros::NodeHandle node, const FrameParameters& frames);

  /// Where antennas are on the base.
  [[nodiscard]] AntennaFrames& antennas() { return antennas_; }
  [[nodiscard]] const AntennaFrames& antennas() const { return antennas_; }

  /// The other node that gives odom_frame or base_link_frame a parent, empty for none in the last seconds.
  [[nodiscard]] std::string broadcaster_of_odom() const { return broadcaster_of(frames_.odom_frame); }
  [[nodiscard]] std::string broadcaster_of_base() const { return broadcaster_of(frames_.base_link_frame); }

 private:
  struct Broadcaster {
    std::string name;
    ros::WallTime seen;
    bool is_static = false;
  };

  [[nodiscard]] std::string broadcaster_of(const std::string& child) const;
  void on_transforms(const ros::MessageEvent<tf2_msgs::TFMessage const>& event, bool is_static);

  FrameParameters frames_;
  AntennaFrames antennas_;
  std::map<std::string, Broadcaster> broadcasters_;  ///< by child frame: odom_frame and base_link_frame
  ros::Subscriber tf_;
  ros::Subscriber tf_static_;
};

}  // namespace multipath_localization
