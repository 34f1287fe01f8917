#include "ros/messages/robot_frames.hpp"

namespace multipath_localization {

void RobotFrames::fields(ParameterVisitor& field) {
  field("map_frame", map_frame, {}, "of truth, zones and buildings");
  field("odom_frame", odom_frame, {}, "in which odometry starts at zero");
  field("base_link_frame", base_link_frame, {}, "of the robot");
  field("gps_frame", gps_frame, {},
        "of the antenna of fixes and pseudoranges; further receivers have that with _2 and so on");
  field("gps_left_frame", gps_left_frame, {}, "of the left one of two antennas");
  field("gps_right_frame", gps_right_frame, {}, "of the right one");
}

std::string RobotFrames::fix_frame(std::size_t receiver) const {
  return receiver == 0 ? gps_frame : gps_frame + "_" + std::to_string(receiver + 1);
}

}  // namespace multipath_localization
