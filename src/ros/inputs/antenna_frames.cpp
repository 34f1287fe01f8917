#include "ros/inputs/antenna_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "ros/messages/conversions.hpp"
#include "ros/messages/earth_frame.hpp"

namespace multipath_localization {

namespace {

constexpr double kSameMast = 0.2;          ///< [m]
constexpr double kFurthestAntenna = 20.0;  ///< from the base [m]
constexpr double kUnitLength = 0.01;       ///< off which a quaternion turns nothing
constexpr std::size_t kDeepestTree = 1000;
constexpr std::array<std::string_view, 5> kGround = {"map", "odom", kEarthFrame, "world", "utm"};

/// Whether one of a name's words, parted by slashes, dashes or underscores, is of a frame on the ground.
bool names_ground(const std::string& frame) {
  constexpr char kSeparators[] = "/_-";
  for (std::size_t begin = 0; begin <= frame.size();) {
    const std::size_t end = std::min(frame.find_first_of(kSeparators, begin), frame.size());
    const std::string_view word = std::string_view(frame).substr(begin, end - begin);
    if (std::find(kGround.begin(), kGround.end(), word) != kGround.end()) return true;
    begin = end + 1;
  }
  return false;
}

}  // namespace

void AntennaFrames::set_frames(const FrameParameters& frames) {
  if (frames.base_link_frame != frames_.base_link_frame) forget_found();
  frames_ = frames;
}

void AntennaFrames::forget_found() {
  first_found_.clear();
  moving_.clear();
}

std::optional<Eigen::Isometry3d> to_isometry(const geometry_msgs::Transform& child_in_parent) {
  const geometry_msgs::Vector3& t = child_in_parent.translation;
  const geometry_msgs::Quaternion& q = child_in_parent.rotation;
  const Eigen::Vector3d translation(t.x, t.y, t.z);
  const Eigen::Quaterniond turn(q.w, q.x, q.y, q.z);
  if (!translation.allFinite() || !(std::abs(turn.norm() - 1.0) <= kUnitLength)) return {};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = turn.normalized().toRotationMatrix();
  pose.translation() = translation;
  return pose;
}

bool AntennaFrames::add(const geometry_msgs::TransformStamped& transform, bool is_static) {
  const std::string child = without_slash(transform.child_frame_id);
  const std::string parent = without_slash(transform.header.frame_id);
  const std::optional<Eigen::Isometry3d> pose = to_isometry(transform.transform);
  if (!pose || child.empty() || parent.empty() || child == parent) return false;
  if (!is_short(child) || !is_short(parent) || transform.header.stamp.toSec() > kLatestStamp) return false;
  Joint& joint = joints_[child];
  if (is_static && (joint.parent != parent || !joint.child_in_parent.isApprox(*pose))) forget_found();
  joint = {parent, *pose};
  return true;
}

std::vector<std::string> AntennaFrames::with_ancestors(const std::string& frame) const {
  std::vector<std::string> line = {frame};
  for (auto joint = joints_.find(frame); joint != joints_.end() && line.size() < kDeepestTree;
       joint = joints_.find(line.back())) {
    line.push_back(joint->second.parent);
  }
  return line;
}

std::vector<std::string> AntennaFrames::between(const std::string& one, const std::string& other) const {
  const std::vector<std::string> up = with_ancestors(one);
  const std::vector<std::string> others = with_ancestors(other);
  const auto joins = [&](const std::string& f) { return std::find(up.begin(), up.end(), f) != up.end(); };
  const auto joint = std::find_if(others.begin(), others.end(), joins);
  if (joint == others.end()) return {};
  std::vector<std::string> way(up.begin(), std::find(up.begin(), up.end(), *joint) + 1);
  way.insert(way.end(), others.begin(), joint);
  return way;
}

Eigen::Isometry3d AntennaFrames::in_root(const std::string& frame) const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::vector<std::string> line = with_ancestors(frame);
  line.pop_back();
  for (const std::string& child : line) pose = joints_.at(child).child_in_parent * pose;
  return pose;
}

std::optional<Eigen::Isometry3d> AntennaFrames::pose(const std::string& frame,
                                                     const std::string& reference) const {
  const auto joint = joints_.find(frame);
  if (joint != joints_.end() && joint->second.parent == reference) return joint->second.child_in_parent;
  if (between(frame, reference).empty()) return {};
  return in_root(reference).inverse() * in_root(frame);
}

bool AntennaFrames::stays_on_ground(const std::string& frame) const {
  return frame == frames_.odom_frame || frame == frames_.map_frame || names_ground(frame);
}

bool AntennaFrames::rides(const std::string& frame) const {
  const std::vector<std::string> way = between(frame, frames_.base_link_frame);
  return !stays_on_ground(frame) &&
         std::none_of(way.begin(), way.end(), [this](const auto& f) { return stays_on_ground(f); });
}

std::optional<Eigen::Vector2d> AntennaFrames::in_base(const std::string& frame) {
  const std::string name = without_slash(frame);
  if (name.empty() || name == frames_.base_link_frame) return Eigen::Vector2d::Zero();
  const std::optional<Eigen::Isometry3d> now = pose(name, frames_.base_link_frame);
  if (!now || !rides(name) || moving_.count(name) > 0) return {};
  const Eigen::Vector2d place = now->translation().head<2>();
  if (!(place.norm() <= kFurthestAntenna)) return {};
  const Eigen::Vector2d first = first_found_.try_emplace(name, place).first->second;
  if ((place - first).norm() <= kSameMast) return first;
  moving_.insert(name);
  return {};
}

double AntennaFrames::height_in_base(const std::string& frame) const {
  const std::string name = without_slash(frame);
  if (name.empty() || name == frames_.base_link_frame) return 0.0;
  const std::optional<Eigen::Isometry3d> now = pose(name, frames_.base_link_frame);
  return now ? now->translation().z() : 0.0;
}

std::optional<Eigen::Quaterniond> AntennaFrames::rotation_in_base(const std::string& frame) const {
  const std::string name = without_slash(frame);
  if (name.empty() || name == frames_.base_link_frame) return Eigen::Quaterniond::Identity();
  const std::optional<Eigen::Isometry3d> now = pose(name, frames_.base_link_frame);
  if (!now || !rides(name)) return {};
  return Eigen::Quaterniond(now->rotation());
}

bool AntennaFrames::may_come(const std::string& frame) const {
  const std::string name = without_slash(frame);
  return !stays_on_ground(name) && between(name, frames_.base_link_frame).empty();
}

std::string AntennaFrames::described(const std::string& frame) const {
  const std::string name = without_slash(frame);
  if (!rides(name)) return frame + " (which does not ride on the robot)";
  if (moving_.count(name) > 0) return frame + " (which moves on the robot, or past it)";
  const std::optional<Eigen::Isometry3d> now = pose(name, frames_.base_link_frame);
  return frame + (now ? " (which is over 20 m from it)" : "");
}

}  // namespace multipath_localization
