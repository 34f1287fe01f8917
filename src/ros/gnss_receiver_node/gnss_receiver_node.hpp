#pragma once

#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "receiver/byte_source.hpp"
#include "ros/gnss_receiver_node/gnss_receiver_parameters.hpp"
#include "ros/gnss_receiver_node/receiver_diagnostics.hpp"
#include "support/background_writer.hpp"

namespace multipath_localization {

/// Raw measurements and ephemerides of a receiver in, from its own stream or its driver's topics, epochs of
/// corrected pseudoranges out, as rinex_to_drive makes them of the same data.
class GnssReceiverNode {
 public:
  /// Throws ParameterError on an unusable parameter, RinexError on a navigation file that cannot be read.
  GnssReceiverNode(const ros::NodeHandle& node, const GnssReceiverParameters& parameters);

  /// Takes what comes until ROS shuts down or a file ends.
  void spin();

 private:
  using Shifted = topic_tools::ShapeShifter::ConstPtr;

  void read_navigation_files();
  void subscribe();
  void on_rawx(const Shifted& message);
  void on_sfrbx(const Shifted& message);
  void on_gnss_comm_epoch(const Shifted& message);
  void on_gnss_comm_ephemeris(const Shifted& message);
  void refuse(const std::string& topic);

  void take_bytes();
  void take(const ReceiverEpoch& epoch);
  /// Waits until it is time for an epoch of a file that is played.
  void wait_for(const GnssTime& time);
  /// Without waiting for the disk.
  void save_ephemerides();

  GnssReceiverParameters parameters_;
  ros::NodeHandle node_;
  LivePositioning positioning_;
  UbxReceiver receiver_;
  std::optional<ByteSource> source_;
  std::ofstream record_;
  ReceiverDiagnostics diagnostics_;
  BackgroundWriter writer_;
  ros::Publisher epochs_;
  std::vector<ros::Subscriber> topics_;
  ros::WallTime saved_ = ros::WallTime::now();
  std::optional<GnssTime> first_;  ///< epoch of a file
  ros::WallTime began_;            ///< when that was played
};

/// The time of an epoch as ROS stamps it, UTC. `leap_seconds`: GPS time - UTC.
ros::Time utc_stamp(const GnssTime& time, int leap_seconds);

}  // namespace multipath_localization
