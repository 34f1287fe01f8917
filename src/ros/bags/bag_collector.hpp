#pragma once

#include <nav_msgs/Odometry.h>
#include <rosbag/message_instance.h>
#include <tf2_msgs/TFMessage.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/drive.hpp"
#include "multipath_localization/core/reason_tally.hpp"
#include "ros/bags/bag_topics.hpp"
#include "ros/inputs/antenna_frames.hpp"
#include "ros/inputs/fix_pairing.hpp"
#include "ros/inputs/odometry_reader.hpp"
#include "ros/messages/gnss_message.hpp"
#include "ros/messages/imu_conversions.hpp"

namespace multipath_localization {

struct ReceivedMessage {
  GnssMessage message;
  double arrival = 0.0;  ///< stamp of the last odometry before it [s]
};

struct Silence {
  double begin = 0.0;  ///< stamp of the last message before [s]
  double end = 0.0;    ///< and of the first that is used after [s]
};

/// Collects a bag's messages in the order they were recorded, as the localization node would take them.
class BagCollector {
 public:
  BagCollector(std::string file, const BagTopics& topics) : file_(std::move(file)), topics_(topics) {}
  BagCollector(const BagCollector&) = delete;
  BagCollector& operator=(const BagCollector&) = delete;
  ~BagCollector() = default;

  /// Throws DriveError when odometry goes back in time, and for messages of a type or of a version of it that
  /// cannot be read.
  void take(const rosbag::MessageInstance& message);
  /// There are no more: gives up what is still without its other half.
  void finish();

  /// Counts something left out of a kind of GNSS message.
  void refuse(std::size_t kind, Reason reason);
  /// The datum that the node would find by the messages (DatumSearch); leaves out those that are
  /// contradicted. Throws DriveError where none agree.
  Geodetic find_datum();

  /// Truth by stamp, with the shadow flag last said at each.
  [[nodiscard]] std::vector<TruthSample> truth() const;
  /// Where the antennas are on the base, by the bag's transforms.
  [[nodiscard]] AntennaFrames& antennas() { return antennas_; }
  /// The datum of truth's frame, nothing when the bag's transforms do not tell.
  [[nodiscard]] std::optional<Geodetic> datum() const;
  [[nodiscard]] const std::vector<OdometryIncrement>& odometry() const { return odometry_; }
  /// Where odometry was silent for so long that the localization node starts afresh.
  [[nodiscard]] const std::vector<Silence>& silences() const { return silences_; }
  [[nodiscard]] const std::vector<ReceivedMessage>& received() const { return received_; }
  [[nodiscard]] const std::vector<RecordedYawRate>& yaw_rates() const { return yaw_rates_; }
  /// Whether the bag's transforms tell how its IMU is mounted.
  [[nodiscard]] bool knows_imu() const { return imu_.frame_known(); }
  /// What was left out of each kind of GNSS message.
  [[nodiscard]] const std::array<ReasonTally, kMeasurementNames.size()>& left_out() const {
    return left_out_;
  }
  /// "TOPIC: REASON, N times" for what was left out.
  [[nodiscard]] std::vector<std::string> refusals() const;
  /// The same in one line in brackets; empty where nothing was.
  [[nodiscard]] std::string all_refusals() const;
  /// Whether odometry's frame is that of map, whose odometry the localization node refuses.
  [[nodiscard]] bool odometry_in_map() const { return odometry_in_map_; }

 private:
  template <class Message>
  [[nodiscard]] Message read(const rosbag::MessageInstance& message) const;
  void add(const nav_msgs::Odometry& message);
  void add(const sensor_msgs::Imu& message);
  void take_by_type(const rosbag::MessageInstance& message);
  /// When a message of that stamp came in: the stamp of the last odometry before it [s].
  [[nodiscard]] double arrival(double stamp) const;
  void add(const GnssMessage& message);
  void add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix);
  void add(const tf2_msgs::TFMessage& message, bool is_static);
  void note_restart(double stamp);
  void take_truth(const rosbag::MessageInstance& message);
  void add_truth(const std_msgs::Header& header, const geometry_msgs::Pose& message);
  void give_up(const sensor_msgs::NavSatFix& fix);
  /// Whether that reason lets it pass; counts it otherwise.
  bool passes(const std::string& topic, Reason reason);
  [[nodiscard]] std::string topic_of(std::size_t kind) const;

  std::string file_;
  BagTopics topics_;
  OdometryReader reader_{{}, ""};
  FixPairing pairing_{GnssParameters{}.pair_tolerance};
  AntennaFrames antennas_{{}};
  ImuReader imu_{[this](const std::string& frame) { return antennas_.rotation_in_base(frame); }};
  std::vector<RecordedYawRate> yaw_rates_;
  std::string truth_frame_;
  std::vector<OdometryIncrement> odometry_;
  std::vector<Silence> silences_;
  std::vector<ReceivedMessage> received_;
  std::map<double, Pose2> truth_;
  std::map<double, bool> shadows_;
  bool turns_ = false;  ///< truth has a heading: one that is always zero was never filled in
  std::map<std::string, int> refusals_;
  bool odometry_in_map_ = false;
  std::array<ReasonTally, kMeasurementNames.size()> left_out_;
};

}  // namespace multipath_localization
