#include "ros/wheel_odometry_node/wheel_odometry_parameters.hpp"

namespace multipath_localization {

namespace {

void require_measure(const char* name, double value) {
  if (value == 0.0) throw ParameterError(std::string(name) + " is not given: measure it, in metres");
}

}  // namespace

void WheelOdometryParameters::fields(ParameterVisitor& field) {
  field("source", source, {"joints", "ackermann"},
        "of what the wheels do: joint_states (sensor_msgs/JointState), or ackermann "
        "(ackermann_msgs/AckermannDriveStamped) as the base reports it");
  field("left_wheels", left_wheels, {}, "names of the left wheels' joints, parted by spaces");
  field("right_wheels", right_wheels, {}, "of the right wheels'");
  field(
      "steering_joints", steering_joints, {},
      "of those that steer, whose mean counts; empty: the base turns by its wheels. With them the wheels are "
      "those of the axle that does not steer, and may all be of one side");
  field("wheel_radius", geometry.wheel_radius, {0.0, 10.0}, "m",
        "way driven straight / (2 pi turns); to be given for joints");
  field("track", geometry.track, {0.0, 20.0}, "m",
        "between left and right wheels, of skidding ones that which turns in place tell; to be given for "
        "joints "
        "without steering");
  field("wheelbase", geometry.wheelbase, {0.0, 50.0}, "m",
        "between the axles; to be given where there is steering");
  field("axle", geometry.axle, {-50.0, 50.0}, "m",
        "x in base_link of the axle that does not steer; of skidding wheels, of their middle");
  field("max_speed", limits.max_speed, {0.1, 100.0}, "m/s", "faster wheels are not believed");
  field("max_yaw_rate", limits.max_yaw_rate, {0.1, 100.0}, "rad/s", "nor such that turn the base faster");
  field("max_gap", limits.max_gap, {0.1, 600.0}, "s", "longer gaps between messages are not bridged");
  field("odom_frame", odom_frame, {}, "frame of the odometry");
  field("base_link_frame", base_link_frame, {}, "frame of the base");
}

void WheelOdometryParameters::require_all() const {
  const WheelJoints named = joints();
  const bool by_joints = source == WheelSource::kJoints;
  const bool is_steered = !by_joints || !named.steering.empty();
  if (is_steered) require_measure("wheelbase", geometry.wheelbase);
  if (!by_joints) return;
  require_measure("wheel_radius", geometry.wheel_radius);
  if (named.left.empty() && named.right.empty())
    throw ParameterError("left_wheels and right_wheels name no joint");
  if (is_steered) return;
  require_measure("track", geometry.track);
  if (named.left.empty()) throw ParameterError("left_wheels names no joint");
  if (named.right.empty()) throw ParameterError("right_wheels names no joint");
}

WheelJoints WheelOdometryParameters::joints() const {
  return {words(left_wheels), words(right_wheels), words(steering_joints)};
}

}  // namespace multipath_localization
