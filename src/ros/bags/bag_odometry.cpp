#include "ros/bags/bag_odometry.hpp"

#include "evaluation/drive.hpp"
#include "ros/inputs/frame_parameters.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {

Reason BagOdometry::add(const nav_msgs::Odometry& message) {
  in_map_ = in_map_ || without_slash(message.header.frame_id) == FrameParameters().map_frame;
  const CheckedOdometry checked = reader_.read(message);
  if (checked.reason != Reason::kAccepted) return checked.reason;
  if (checked.restarted) note_restart(checked.increment.stamp);
  increments_.push_back(checked.increment);
  return checked.reason;
}

void BagOdometry::note_restart(double stamp) {
  if (increments_.empty()) return;
  const double last = increments_.back().stamp;
  if (stamp < last) {
    throw DriveError(name_ + " goes back in time, from " + std::to_string(last) + " to " +
                     std::to_string(stamp) + ": cut the bag there with rosbag filter");
  }
  silences_.push_back({last, stamp});
}

}  // namespace multipath_localization
