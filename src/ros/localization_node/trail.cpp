#include "ros/localization_node/trail.hpp"

#include <cmath>

namespace multipath_localization {

void Trail::add(const std_msgs::Header& header, const geometry_msgs::Pose& pose) {
  path_.header = header;
  if (!path_.poses.empty()) {
    const geometry_msgs::Point& last = path_.poses.back().pose.position;
    if (std::hypot(pose.position.x - last.x, pose.position.y - last.y) < spacing_) return;
  }
  geometry_msgs::PoseStamped stamped;
  stamped.header = header;
  stamped.pose = pose;
  path_.poses.push_back(stamped);
  if (path_.poses.size() > length_) path_.poses.erase(path_.poses.begin());
}

}  // namespace multipath_localization
