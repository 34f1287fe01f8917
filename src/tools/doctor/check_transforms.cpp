#include <algorithm>
#include <cmath>
#include <set>

#include "ros/inputs/antenna_frames.hpp"
#include "ros/messages/conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {

namespace {

constexpr double kFarthestAntenna = 5.0;  // [m]
constexpr double kLargestTurn = 0.09;     // of the antenna's frame, 5 degrees [rad]

std::string joined(const std::set<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " and ") + name;
  return all;
}

/// Who broadcasts parent -> child, by child and parent.
using Edges = std::map<std::string, std::map<std::string, std::set<std::string>>>;

Edges edges(const Observations& seen) {
  Edges all;
  for (const Broadcast& broadcast : seen.transforms) {
    const std::string parent = without_slash(broadcast.transform.header.frame_id);
    all[without_slash(broadcast.transform.child_frame_id)][parent].insert(broadcast.node);
  }
  return all;
}

std::string place_antenna(const Observations& seen, const std::string& frame) {
  return "localization.yaml: antenna: [X, Y]   (X forwards, Y to the left, in metres), or a static "
         "transform " +
         seen.frames.base_link_frame + " -> " + frame;
}

/// The names a field takes over all messages.
template <class Message, class Field>
std::set<std::string> names(const std::vector<Arrived<Message>>& messages, const Field& field) {
  std::set<std::string> all;
  for (const Arrived<Message>& arrived : messages) all.insert(field(arrived.message));
  return all;
}

/// A frame that stays where it is while the robot drives.
bool is_fixed(const Observations& seen, const std::string& frame) {
  return frame == seen.frames.map_frame || frame == seen.frames.odom_frame;
}

Finding frame_of(const std::string& what, const std::string& frame, const std::string& expected,
                 const std::string& parameter) {
  if (frame.empty())
    return fix(what + " is empty", "in the odometry driver: " + what + " = \"" + expected + "\"");
  if (frame.front() == '/') {
    return fix(what + " is " + frame + ", which tf2 does not know with its slash",
               "in the driver: " + what + " = \"" + without_slash(frame) + "\"");
  }
  if (frame != expected) {
    return fix(what + " is " + frame + ", the node has " + expected,
               "localization.yaml: " + parameter + ": " + frame);
  }
  return pass(what + " is " + frame);
}

Finding frame_of_fix(const Observations& seen, const std::string& frame) {
  if (frame.empty()) {
    return fix("fix: header.frame_id is empty, so the antenna is taken to be at the base",
               "in the receiver's driver: frame_id: gps, and " + place_antenna(seen, "gps"));
  }
  if (is_fixed(seen, without_slash(frame))) {
    return fix("fix: header.frame_id is " + frame + ": that does not ride on the robot, the antenna does",
               "in the receiver's driver: frame_id: gps, and " + place_antenna(seen, "gps"));
  }
  if (frame.front() == '/') {
    return fix("fix: header.frame_id is " + frame + ", which tf2 does not know with its slash",
               "in the receiver's driver: frame_id: " + without_slash(frame));
  }
  return pass("fix: header.frame_id is " + frame);
}

/// Two parents or two broadcasters of a frame, empty for none.
std::string conflict_of(const std::string& child,
                        const std::map<std::string, std::set<std::string>>& parents) {
  if (parents.size() == 1) {
    const auto& [parent, nodes] = *parents.begin();
    return nodes.size() > 1 ? parent + " -> " + child + " comes from " + joined(nodes) : "";
  }
  std::string who;
  for (const auto& [parent, nodes] : parents) {
    who += (who.empty() ? "" : ", ") + parent + " (by " + joined(nodes) + ")";
  }
  return child + " has two parents: " + who;
}

/// Of a node that broadcasts that edge to odom.
Finding placed_by(const Observations& seen, const std::string& edge, const std::string& node) {
  if (seen.from_bag) {
    return fix(
        edge + " is in the bag" + (node.empty() ? "" : ", by " + node) + ", and will fight with ours",
        "play it by bag.launch, which drops it: roslaunch multipath_localization bag.launch bag:=FILE");
  }
  if (seen.types.count(without_slash(node) + "/fix_report") > 0) {
    return pass(edge + " is ours, by " + node);
  }
  return fix(edge + " is broadcast by " + node,
             "rosnode kill " + node + ", or localization.launch publish_tf:=false");
}

/// Of an antenna that tf places in the base.
Finding antenna_at(const Observations& seen, const std::string& frame, const Eigen::Isometry3d& antenna) {
  const Eigen::Vector3d at = antenna.translation();
  const double turn = Eigen::AngleAxisd(antenna.linear()).angle();
  const std::string& base = seen.frames.base_link_frame;
  const std::string what =
      text("tf: %s is at %.2f, %.2f, %.2f in %s", frame.c_str(), at.x(), at.y(), at.z(), base.c_str());
  if (!(at.head<2>().norm() <= kFarthestAntenna)) {
    return fix(what + ", which is off the robot", place_antenna(seen, frame));
  }
  if (turn <= kLargestTurn) return pass(what);
  return pass(what + text(", turned by %.0f degrees, which an antenna does not mind", turn * 180.0 / kPi));
}

/// Whether tf has that frame.
bool is_known(const Observations& seen, const std::string& frame) {
  return std::any_of(seen.transforms.begin(), seen.transforms.end(), [&](const Broadcast& broadcast) {
    return without_slash(broadcast.transform.header.frame_id) == frame ||
           without_slash(broadcast.transform.child_frame_id) == frame;
  });
}

/// Whether it is the node's name of the base that tf does not know, while it knows odometry's.
bool base_is_misnamed(const Observations& seen) {
  if (seen.odometry.empty() || is_known(seen, seen.frames.base_link_frame)) return false;
  return is_known(seen, without_slash(seen.odometry.back().message.child_frame_id));
}

Finding antenna_in(const Observations& seen, const std::string& frame) {
  if (frame == seen.frames.base_link_frame) return pass("fix: the antenna is at the base, as its frame says");
  AntennaFrames frames(seen.frames);
  for (const Broadcast& broadcast : seen.transforms) {
    frames.add(broadcast.transform, broadcast.is_static);
    frames.in_base(frame);  // which sees whether it moves
  }
  const std::optional<Eigen::Isometry3d> antenna = frames.pose(frame, seen.frames.base_link_frame);
  const bool rides = frames.in_base(frame).has_value();
  if (antenna && (rides || antenna->translation().head<2>().norm() > kFarthestAntenna)) {
    return antenna_at(seen, frame, *antenna);
  }
  if (antenna) return fix("tf: " + frames.described(frame), place_antenna(seen, frame));
  if (!seen.antenna.empty()) {
    return pass(text("fix: the antenna is at %.2f, %.2f on the base, by the parameter antenna",
                     seen.antenna[0], seen.antenna[1]));
  }
  if (base_is_misnamed(seen)) {
    return untold("tf: where " + frame + " is on the robot shows once base_link_frame is mended");
  }
  return fix("tf: nobody says where " + frame + " is on the robot", place_antenna(seen, frame));
}

}  // namespace

Findings check_frames(const Observations& seen) {
  Findings all;
  for (const std::string& frame : names(seen.fixes, [](const auto& m) { return m.header.frame_id; })) {
    all.push_back(frame_of_fix(seen, frame));
  }
  for (const std::string& frame : names(seen.odometry, [](const auto& m) { return m.header.frame_id; })) {
    if (without_slash(frame) == seen.frames.map_frame) {
      all.push_back(
          fix("odom: header.frame_id is " + frame + ": this is the output of a localisation, not odometry",
              "odom:=TOPIC of the base driver, whose frame is " + seen.frames.odom_frame));
    } else if (without_slash(frame) == seen.frames.base_link_frame) {
      all.push_back(fix("odom: header.frame_id is " + frame + ", which moves with the robot",
                        "in the odometry driver: header.frame_id = \"" + seen.frames.odom_frame + "\""));
    } else {
      all.push_back(frame_of("odom: header.frame_id", frame, seen.frames.odom_frame, "odom_frame"));
    }
  }
  for (const std::string& frame : names(seen.odometry, [](const auto& m) { return m.child_frame_id; })) {
    const std::string& base = seen.frames.base_link_frame;
    all.push_back(
        is_fixed(seen, without_slash(frame))
            ? fix("odom: child_frame_id is " + frame + ", which does not move with the robot",
                  "in the odometry driver: child_frame_id = \"" + base + "\", and the twist along its axes")
            : frame_of("odom: child_frame_id", frame, base, "base_link_frame"));
  }
  return all;
}

Findings check_parents(const Observations& seen) {
  Findings all;
  for (const auto& [child, parents] : edges(seen)) {
    const std::string conflict = conflict_of(child, parents);
    if (!conflict.empty())
      all.push_back(fix("tf: " + conflict, "stop one of them, as by publish_tf: false in its parameters"));
  }
  if (all.empty() && !seen.transforms.empty())
    all.push_back(pass("tf: every frame has one parent and one broadcaster"));
  return all;
}

Findings check_map_to_odom(const Observations& seen) {
  const Edges all = edges(seen);
  const auto odom = all.find(seen.frames.odom_frame);
  if (odom == all.end()) return {pass("tf: nobody else places " + seen.frames.odom_frame)};
  Findings found;
  for (const auto& [parent, nodes] : odom->second) {
    const std::string edge = "tf: " + parent + " -> " + seen.frames.odom_frame;
    for (const std::string& node : nodes) found.push_back(placed_by(seen, edge, node));
  }
  return found;
}

Findings check_antenna(const Observations& seen) {
  Findings all;
  for (std::string frame : names(seen.fixes, [](const auto& m) { return m.header.frame_id; })) {
    frame = without_slash(frame);
    if (!frame.empty() && !is_fixed(seen, frame)) all.push_back(antenna_in(seen, frame));
  }
  return all;
}

}  // namespace multipath_localization
