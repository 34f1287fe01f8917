// The orders that the owner of the robot gives by services.

#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "nodes/steering_node.hpp"

namespace multipath_localization {

void SteeringNode::offer_orders(ros::NodeHandle& private_node) {
  offer(private_node, "start", [this] { return mission_.start(); });
  offer(private_node, "pause", [this] { return mission_.pause(); });
  offer(private_node, "resume", [this] { return mission_.resume(); });
  offer(private_node, "skip", [this] { return mission_.skip(); });
  offer(private_node, "stop", [this] { return mission_.stop(); });
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

}  // namespace multipath_localization
