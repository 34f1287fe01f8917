#pragma once

#include "../models/sky.hpp"
#include "good_fix.hpp"
#include "ros/messages/epoch_conversions.hpp"

namespace multipath_localization {

/// An epoch with nothing wrong about it: thirteen satellites seen from (320, -150, 12) m in that map.
inline PseudorangeEpoch good_observations() {
  PseudorangeEpoch epoch;
  epoch.stamp = 100.5;
  epoch.observations = observed(open_sky(), {320.0, -150.0, 12.0}, -136902.0, -136897.0);
  return epoch;
}

inline GnssEpoch good_epoch() {
  std_msgs::Header header;
  header.stamp = ros::Time(100, 500000000);
  header.frame_id = "gps";
  return to_message(good_observations(), berlin(), header);
}

}  // namespace multipath_localization
