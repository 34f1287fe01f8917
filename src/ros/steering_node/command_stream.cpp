#include "ros/steering_node/command_stream.hpp"

#include <utility>

namespace multipath_localization {

namespace {

constexpr double kSayZeroFor = 1.0;  ///< when ordered to stand [s]

}  // namespace

std::optional<MotionCommand> CommandStream::towards(const FollowerOutput& wanted, bool stands,
                                                    const Moment& now) {
  urgent_ = wanted.urgent;
  const bool to_stand = wanted.command.speed == 0.0 && wanted.spin == 0.0;
  if (to_stand && !limiter_.at_rest()) return brake(now);
  stopping_ = false;
  const MotionCommand command = limiter_.limited(wanted.command, urgent_, step_to(now), wanted.spin);
  return leaves_to_others(stands, now.steady) ? std::nullopt : std::optional(command);
}

std::optional<MotionCommand> CommandStream::braked(const Moment& now) {
  return stopping_ ? std::optional(brake(now)) : std::nullopt;
}

MotionCommand CommandStream::halted() {
  limiter_.halt();
  return {};
}

MotionCommand CommandStream::brake(const Moment& now) {
  const MotionCommand command = limiter_.limited({}, urgent_, step_to(now));
  stopping_ = !limiter_.at_rest();
  return command;
}

double CommandStream::step_to(const Moment& now) {
  const Moment before = std::exchange(commanded_, now);
  const double step = now.stamp.toSec() - before.stamp.toSec();
  return step > 0.0 ? step : (now.steady - before.steady).toSec();
}

bool CommandStream::leaves_to_others(bool stands, const ros::SteadyTime& now) {
  if (!stands) {
    standing_since_ = {};
    return false;
  }
  if (standing_since_.isZero()) standing_since_ = now;
  return (now - standing_since_).toSec() > kSayZeroFor;
}

}  // namespace multipath_localization
