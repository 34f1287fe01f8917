#include "ros/localization_node/antenna_placement.hpp"

#include <algorithm>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kSameAntenna = 0.05;      ///< two places of one are the same within this [m]
constexpr std::size_t kMostAssumed = 100;  ///< frames

}  // namespace

bool AntennaPlacement::waits(const GnssMessage& message, double stamp, double wall) {
  const std::vector<std::string> frames = frames_of(message);
  return std::any_of(frames.begin(), frames.end(), [&](const std::string& frame) {
    return !antennas_.in_base(frame) && antennas_.may_come(frame) &&
           patience_.lasts(without_slash(frame), stamp, wall);
  });
}

bool AntennaPlacement::appeared(const GnssMessage& message) {
  const std::vector<std::string> frames = frames_of(message);
  return std::any_of(frames.begin(), frames.end(), [this](const std::string& frame) {
    const auto assumed = assumed_.find(frame);
    const std::optional<Eigen::Vector2d> antenna = antennas_.in_base(frame);
    if (assumed == assumed_.end() || !antenna) return false;
    const Eigen::Vector2d before = assumed->second;
    assumed_.erase(assumed);
    return (*antenna - before).norm() > kSameAntenna;
  });
}

void AntennaPlacement::assume(const GnssMessage& message) {
  for (const std::string& frame : frames_of(message)) {
    if (!antennas_.in_base(frame) && assumed_.size() < kMostAssumed) assumed_.emplace(frame, otherwise_);
  }
}

}  // namespace multipath_localization
