// The orders that the owner of the robot gives by services.

#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

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
  obey("clicked point", routes_.record({message.point.x, message.point.y}));
}

Answer SteeringNode::stop() {
  commands_.speak_again();
  return mission_.stop();
}

Answer SteeringNode::record_pose() {
  if (!pose_is_present() || !pose_.pose().finite()) return {false, "there is no present pose"};
  if (!pose_.known()) return {false, "the localisation does not know where the robot is"};
  Answer answer = routes_.record(pose_.pose().position());
  if (answer.done && pose_.trust() != Trust::kGood) {
    answer.message += "; beware, the localisation is not GOOD here";
  }
  return answer;
}

Answer SteeringNode::save() {
  outputs_.show_anew();
  return routes_.save();
}

}  // namespace multipath_localization
