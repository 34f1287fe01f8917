#include "ros/inputs/frame_parameters.hpp"

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

void FrameParameters::fields(ParameterVisitor& field) {
  field("map_frame", map_frame, {}, "frame the pose is given in, ENU at the datum");
  field("odom_frame", odom_frame, {}, "frame the odometry is given in");
  field("base_link_frame", base_link_frame, {}, "frame of the base, x forward");
  for (std::string* frame : {&map_frame, &odom_frame, &base_link_frame}) *frame = without_slash(*frame);
}

}  // namespace multipath_localization
