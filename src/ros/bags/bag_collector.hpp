#pragma once

#include <nav_msgs/Odometry.h>
#include <rosbag/message_instance.h>
#include <sensor_msgs/Imu.h>
#include <tf2_msgs/TFMessage.h>

#include <optional>
#include <string>
#include <vector>

#include "evaluation/drive.hpp"
#include "ros/bags/bag_measurements.hpp"
#include "ros/bags/bag_odometry.hpp"
#include "ros/bags/bag_refusals.hpp"
#include "ros/bags/bag_topics.hpp"
#include "ros/bags/bag_truth.hpp"
#include "ros/inputs/antenna_frames.hpp"
#include "ros/messages/imu_conversions.hpp"

namespace multipath_localization {

/// Collects a bag's messages in the order they were recorded, as the localization node would take them.
class BagCollector {
 public:
  BagCollector(const std::string& file, const BagTopics& topics)
      : file_(file), topics_(topics), odometry_(file + ": " + topics.odometry) {}
  BagCollector(const BagCollector&) = delete;
  BagCollector& operator=(const BagCollector&) = delete;
  ~BagCollector() = default;

  /// Throws DriveError when odometry goes back in time, and for messages of a type or of a version of it that
  /// cannot be read.
  void take(const rosbag::MessageInstance& message);

  [[nodiscard]] const BagOdometry& odometry() const { return odometry_; }
  [[nodiscard]] const BagTruth& truth() const { return truth_; }
  [[nodiscard]] BagMeasurements& measurements() { return measurements_; }
  [[nodiscard]] const std::vector<RecordedYawRate>& yaw_rates() const { return yaw_rates_; }
  [[nodiscard]] const BagRefusals& refusals() const { return refusals_; }
  /// Where the antennas are on the base, by the bag's transforms.
  [[nodiscard]] AntennaFrames& antennas() { return antennas_; }
  /// The datum of truth's frame, nothing when the bag's transforms do not tell.
  [[nodiscard]] std::optional<Geodetic> datum() const;
  /// Whether the bag's transforms tell how its IMU is mounted.
  [[nodiscard]] bool knows_imu() const { return imu_.frame_known(); }

 private:
  template <class Message>
  [[nodiscard]] Message read(const rosbag::MessageInstance& message) const;
  void add(const nav_msgs::Odometry& message);
  void add(const sensor_msgs::Imu& message);
  void add(const tf2_msgs::TFMessage& message, bool is_static);
  void take_truth(const rosbag::MessageInstance& message);
  void take_gnss(const rosbag::MessageInstance& message);
  /// A velocity or heading, of either of its types.
  void take_by_type(const rosbag::MessageInstance& message);

  std::string file_;
  BagTopics topics_;
  BagRefusals refusals_;
  BagOdometry odometry_;
  BagTruth truth_;
  AntennaFrames antennas_{{}};
  ImuReader imu_{[this](const std::string& frame) { return antennas_.rotation_in_base(frame); }};
  std::vector<RecordedYawRate> yaw_rates_;
  BagMeasurements measurements_{topics_, odometry_, antennas_, refusals_};
};

}  // namespace multipath_localization
