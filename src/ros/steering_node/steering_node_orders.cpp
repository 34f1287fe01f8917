// The orders that the owner of the robot gives by services.

#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <stdexcept>

#include "ros/messages/conversions.hpp"
#include "ros/steering_node/steering_node.hpp"

namespace multipath_localization {

void SteeringNode::offer_orders(ros::NodeHandle& private_node) {
  offer(private_node, "start", [this] { return mission_.start(); });
  offer(private_node, "pause", [this] { return mission_.pause(); });
  offer(private_node, "resume", [this] { return mission_.resume(); });
  offer(private_node, "skip", [this] { return mission_.skip(); });
  offer(private_node, "stop", [this] { return stop(); });
  offer(private_node, "record", [this] { return record_pose(); });
  offer(private_node, "save", [this] { return save(); });
  using Loop = std_srvs::SetBool;
  orders_.push_back(private_node.advertiseService<Loop::Request, Loop::Response>(
      "loop", [this](Loop::Request& request, Loop::Response& response) {
        const Answer answer = obey("loop", mission_.set_loop(request.data != 0));
        response.success = static_cast<unsigned char>(answer.done);
        response.message = answer.message;
        return true;
      }));
}

void SteeringNode::offer(ros::NodeHandle& private_node, const std::string& order,
                         const std::function<Answer()>& carry_out) {
  using Trigger = std_srvs::Trigger;
  orders_.push_back(private_node.advertiseService<Trigger::Request, Trigger::Response>(
      order, [this, order, carry_out](Trigger::Request&, Trigger::Response& response) {
        const Answer answer = obey(order, carry_out());
        response.success = static_cast<unsigned char>(answer.done);
        response.message = answer.message;
        return true;
      }));
}

Answer SteeringNode::obey(const std::string& order, const Answer& answer) {
  ROS_INFO_STREAM(order << (answer.done ? ": " : " refused: ") << answer.message);
  drive();
  return answer;
}

void SteeringNode::take_clicked_point(const geometry_msgs::PointStamped& message) {
  if (without_slash(message.header.frame_id) != parameters_.map_frame) {
    obey("clicked point", {false, "it is in frame '" + shown(message.header.frame_id) + "'"});
    return;
  }
  obey("clicked point", record({message.point.x, message.point.y}));
}

Answer SteeringNode::stop() {
  standing_since_ = {};  // zero is said again, whoever drives
  return mission_.stop();
}

Answer SteeringNode::record_pose() {
  const bool present = std::abs(pose_age(ros::Time::now())) <= parameters_.follower.max_pose_age;
  if (!present || !pose_.finite()) return {false, "there is no present pose"};
  if (trust_ == Trust::kNotReady || trust_ == Trust::kLost) {
    return {false, "the localisation does not know where the robot is"};
  }
  Answer answer = record(pose_.position());
  if (answer.done && trust_ != Trust::kGood) answer.message += "; beware, the localisation is not GOOD here";
  return answer;
}

Answer SteeringNode::record(const Eigen::Vector2d& in_map) {
  if (parameters_.waypoint_file.empty())
    return {false, "the parameter waypoint_file names no file to save to"};
  WaypointList recording = recording_.value_or(waypoints_);
  try {
    append(recording, in_map, origin_);
  } catch (const std::invalid_argument& reason) {
    return {false, reason.what()};
  }
  recording_ = recording;
  return {true, "waypoint " + std::to_string(recording.points.size()) + ", to be kept by save"};
}

Answer SteeringNode::save() {
  const std::string& file = parameters_.waypoint_file;
  if (!recording_) return {false, "nothing is recorded"};
  try {
    const WaypointList recording = moved(*recording_, origin_);
    write_waypoints(file, recording);
    waypoints_ = recording;
  } catch (const std::exception& reason) {
    return {false, reason.what()};
  }
  mission_.stop();
  recording_.reset();
  place_waypoints();
  return {true,
          std::to_string(waypoints_.points.size()) + " waypoints in " + file + "; start drives along them"};
}

}  // namespace multipath_localization
