#include "multipath_localization/models/motion/odometry_history.hpp"

#include <algorithm>

namespace multipath_localization {

void OdometryHistory::add(const OdometryIncrement& increment) {
  const Pose2 before = nodes_.empty() ? Pose2{} : nodes_.back().base_in_odom;
  nodes_.push_back({increment.stamp, before * displacement(increment), increment});
  while (nodes_.front().stamp < increment.stamp - length_) nodes_.pop_front();
}

std::optional<Pose2> OdometryHistory::base_then_in_base_now(double stamp) const {
  const auto node = std::lower_bound(nodes_.begin(), nodes_.end(), stamp,
                                     [](const Node& n, double t) { return n.stamp < t; });
  if (node == nodes_.end() || !(stamp >= node->stamp - node->increment.duration)) return std::nullopt;
  OdometryIncrement rest = node->increment;
  rest.duration = node->stamp - stamp;
  const Pose2 then_in_odom = node->base_in_odom * inverse(displacement(rest));
  return inverse(nodes_.back().base_in_odom) * then_in_odom;
}

}  // namespace multipath_localization
