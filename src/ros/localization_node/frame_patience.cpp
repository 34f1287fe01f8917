#include "ros/localization_node/frame_patience.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

constexpr std::size_t kMostFrames = 100;  ///< that are waited for

}  // namespace

bool FramePatience::lasts(const std::string& frame, double stamp, double wall) {
  if (begun_.count(frame) == 0 && begun_.size() >= kMostFrames) return false;
  Begun& begun = begun_.try_emplace(frame, Begun{stamp, wall}).first->second;
  begun.over = begun.over || std::abs(stamp - begun.stamp) > kPatience || wall - begun.wall > kPatience;
  return !begun.over;
}

}  // namespace multipath_localization
