#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <optional>
#include <string>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "ros/messages/robot_frames.hpp"
#include "simulation/simulator.hpp"

namespace multipath_localization {

/// Publishes what the simulated receivers measure, on the topics of those that there are: `gps/fix`,
/// `gps_2/fix`, `gps/left/fix` and `gps/right/fix`, `gnss/epoch`, `gps/velocity`, `heading`; and where their
/// antennas are, on tf.
class SimulatedGnss {
 public:
  /// `origin`: stamp of simulated time 0.
  SimulatedGnss(ros::NodeHandle node, const SimulatorParameters& simulator, const RobotFrames& frames,
                const ros::Time& origin);

  /// `status`: what a fix claims in place of STATUS_FIX.
  void publish(const Measurement& measurement, std::optional<int> status);

 private:
  void publish(const GnssFix& fix, std::optional<int> status);
  void publish(const DualAntennaFix& fixes);
  void publish(const PseudorangeEpoch& epoch);
  void publish(const Heading& heading);
  void place_antennas(const SimulatorParameters& simulator);
  [[nodiscard]] std_msgs::Header header(double time, const std::string& frame) const;

  RobotFrames frames_;
  LocalFrame map_;
  ros::Time origin_;
  ros::Publisher fix_, fix_2_, left_, right_, epoch_, velocity_, heading_;
  tf2_ros::StaticTransformBroadcaster transforms_;
};

}  // namespace multipath_localization
