#include "ros/bags/bag_truth.hpp"

#include <iterator>
#include <optional>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

Reason BagTruth::add(const std_msgs::Header& header, const geometry_msgs::Pose& message) {
  const std::optional<Pose2> pose = to_pose2(message);
  if (!pose) return Reason::kInvalidPosition;
  turns_ = turns_ || pose->yaw != 0.0;
  poses_[header.stamp.toSec()] = *pose;
  frame_ = without_slash(header.frame_id);
  return Reason::kAccepted;
}

std::vector<TruthSample> BagTruth::samples() const {
  std::vector<TruthSample> samples;
  for (const auto& [stamp, base_in_map] : poses_) {
    samples.push_back({stamp, base_in_map, turns_, std::nullopt});
    const auto later = shadows_.upper_bound(stamp);
    if (shadows_.empty()) continue;
    samples.back().shadow = later == shadows_.begin() ? later->second : std::prev(later)->second;
  }
  return samples;
}

}  // namespace multipath_localization
