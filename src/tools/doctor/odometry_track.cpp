#include "tools/doctor/odometry_track.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kRounding = 1e-6;  ///< between the end of an increment and the start of the next [s]

}  // namespace

OdometryTrack::OdometryTrack(const std::vector<OdometryIncrement>& increments) {
  Pose2 pose;
  double distance = 0.0;
  for (const OdometryIncrement& increment : increments) {
    nodes_.push_back({increment, pose, distance});
    pose = pose * displacement(increment);
    distance += ground_speed(increment) * increment.duration;
  }
}

const OdometryTrack::Node* OdometryTrack::at(double stamp) const {
  const auto node = std::lower_bound(nodes_.begin(), nodes_.end(), stamp,
                                     [](const Node& n, double t) { return n.increment.stamp < t; });
  if (node == nodes_.end()) return nullptr;
  const double start = node->increment.stamp - node->increment.duration;
  return stamp < start - kRounding ? nullptr : &*node;
}

std::optional<Pose2> OdometryTrack::pose(double stamp) const {
  const Node* node = at(stamp);
  if (node == nullptr) return std::nullopt;
  OdometryIncrement part = node->increment;
  part.duration -= part.stamp - stamp;
  return node->start * displacement(part);
}

std::optional<double> OdometryTrack::distance(double stamp) const {
  const Node* node = at(stamp);
  if (node == nullptr) return std::nullopt;
  const double duration = node->increment.duration - (node->increment.stamp - stamp);
  return node->distance + ground_speed(node->increment) * duration;
}

std::vector<Chord> chords(const std::vector<GnssFix>& fixes, const OdometryTrack& track, double length) {
  std::vector<Chord> all;
  const GnssFix* first = nullptr;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  for (const GnssFix& fix : fixes) {
    const std::optional<Pose2> base = track.pose(fix.stamp);
    if (!base) continue;
    const Eigen::Vector2d antenna = *base * fix.antenna_in_base;
    if (first != nullptr && (antenna - from).norm() < length) continue;
    if (first != nullptr)
      all.push_back({first->stamp, fix.stamp, fix.position - first->position, antenna - from});
    first = &fix;
    from = antenna;
  }
  return all;
}

}  // namespace multipath_localization
