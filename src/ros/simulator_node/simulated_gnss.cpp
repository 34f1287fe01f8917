#include "ros/simulator_node/simulated_gnss.hpp"

#include "ros/messages/conversions.hpp"
#include "ros/messages/epoch_conversions.hpp"
#include "ros/messages/heading_conversions.hpp"
#include "ros/messages/velocity_conversions.hpp"

namespace multipath_localization {

namespace {

constexpr std::uint32_t kQueue = 50;

bool has_receiver(const SimulatorParameters& simulator) { return simulator.receiver.rate > 0.0; }
bool has_second(const SimulatorParameters& simulator) { return simulator.second_receiver.rate > 0.0; }
bool has_pair(const SimulatorParameters& simulator) { return simulator.dual_receiver.rate > 0.0; }

}  // namespace

SimulatedGnss::SimulatedGnss(ros::NodeHandle node, const SimulatorParameters& simulator,
                             const RobotFrames& frames, const ros::Time& origin)
    : frames_(frames), map_(simulator.datum()), origin_(origin) {
  if (has_receiver(simulator)) fix_ = node.advertise<sensor_msgs::NavSatFix>("gps/fix", kQueue);
  if (has_receiver(simulator) && simulator.receiver.source == ReceiverSource::kSatellites) {
    epoch_ = node.advertise<GnssEpoch>("gnss/epoch", kQueue);
  }
  if (has_second(simulator)) fix_2_ = node.advertise<sensor_msgs::NavSatFix>("gps_2/fix", kQueue);
  if (has_pair(simulator)) {
    left_ = node.advertise<sensor_msgs::NavSatFix>("gps/left/fix", kQueue);
    right_ = node.advertise<sensor_msgs::NavSatFix>("gps/right/fix", kQueue);
  }
  if (simulator.velocity.rate > 0.0) {
    velocity_ = node.advertise<geometry_msgs::TwistWithCovarianceStamped>("gps/velocity", kQueue);
  }
  if (simulator.compass.rate > 0.0) heading_ = node.advertise<sensor_msgs::Imu>("heading", kQueue);
  place_antennas(simulator);
}

void SimulatedGnss::place_antennas(const SimulatorParameters& simulator) {
  const ReceiverParameters& receiver = simulator.receiver;
  const DualReceiverParameters& pair = simulator.dual_receiver;
  std::vector<geometry_msgs::TransformStamped> antennas;
  const auto place = [&](const std::string& frame, double x, double y, double z) {
    geometry_msgs::TransformStamped& antenna = antennas.emplace_back();
    antenna.header = header(0.0, frames_.base_link_frame);
    antenna.child_frame_id = frame;
    antenna.transform = to_transform(Pose2{x, y, 0.0});
    antenna.transform.translation.z = z;
  };
  place(frames_.gps_frame, receiver.antenna_x, receiver.antenna_y, receiver.antenna_z);
  if (has_second(simulator)) {
    const SecondReceiverParameters& second = simulator.second_receiver;
    place(frames_.fix_frame(1), second.antenna_x, second.antenna_y, receiver.antenna_z);
  }
  if (has_pair(simulator)) {
    place(frames_.gps_left_frame, pair.antenna_x, 0.5 * pair.baseline, 0.0);
    place(frames_.gps_right_frame, pair.antenna_x, -0.5 * pair.baseline, 0.0);
  }
  transforms_.sendTransform(antennas);
}

void SimulatedGnss::publish(const Measurement& measurement, std::optional<int> status) {
  if (const auto* fix = std::get_if<GnssFix>(&measurement)) publish(*fix, status);
  if (const auto* fixes = std::get_if<DualAntennaFix>(&measurement)) publish(*fixes);
  if (const auto* epoch = std::get_if<PseudorangeEpoch>(&measurement)) publish(*epoch);
  if (const auto* heading = std::get_if<Heading>(&measurement)) publish(*heading);
  if (const auto* velocity = std::get_if<GnssVelocity>(&measurement)) {
    velocity_.publish(to_message(*velocity, header(velocity->stamp, frames_.gps_frame)));
  }
}

void SimulatedGnss::publish(const Heading& heading) {
  heading_.publish(to_message(heading, header(heading.stamp, frames_.base_link_frame)));
}

void SimulatedGnss::publish(const GnssFix& fix, std::optional<int> status) {
  if (fix.receiver > 0) {
    return fix_2_.publish(to_message(fix, map_, header(fix.stamp, frames_.fix_frame(1))));
  }
  sensor_msgs::NavSatFix message = to_message(fix, map_, header(fix.stamp, frames_.gps_frame));
  if (status) message.status.status = static_cast<std::int8_t>(*status);
  fix_.publish(message);
}

void SimulatedGnss::publish(const DualAntennaFix& fixes) {
  left_.publish(to_message(fixes.left, map_, header(fixes.left.stamp, frames_.gps_left_frame)));
  right_.publish(to_message(fixes.right, map_, header(fixes.right.stamp, frames_.gps_right_frame)));
}

void SimulatedGnss::publish(const PseudorangeEpoch& epoch) {
  epoch_.publish(to_message(epoch, map_, header(epoch.stamp, frames_.gps_frame)));
}

std_msgs::Header SimulatedGnss::header(double time, const std::string& frame) const {
  std_msgs::Header message;
  message.stamp = origin_ + ros::Duration(time);
  message.frame_id = frame;
  return message;
}

}  // namespace multipath_localization
