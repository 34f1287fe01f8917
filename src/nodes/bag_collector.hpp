#pragma once

#include <geometry_msgs/Transform.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/message_instance.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/evaluation/drive.hpp"
#include "nodes/bag_topics.hpp"
#include "nodes/fix_pairing.hpp"
#include "nodes/gnss_message.hpp"
#include "nodes/odometry_reader.hpp"

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

  /// Throws DriveError when odometry goes back in time, and for messages of a type or of a version of it that
  /// cannot be read.
  void take(const rosbag::MessageInstance& message);
  /// There are no more: gives up what is still without its other half.
  void finish();

  /// Counts something left out of a kind of GNSS message.
  void refuse(std::size_t kind, Reason reason) { passes(topic_of(kind), reason); }

  /// Truth by stamp, with the shadow flag last said at each.
  [[nodiscard]] std::vector<TruthSample> truth() const;
  /// Where in the base the antenna of that frame is, nothing when the bag's static transforms do not tell.
  [[nodiscard]] std::optional<Eigen::Vector2d> antenna_in_base(const std::string& frame) const;
  /// The datum of truth's frame, nothing when the bag's static transforms do not tell.
  [[nodiscard]] std::optional<Geodetic> datum() const;
  [[nodiscard]] const std::vector<OdometryIncrement>& odometry() const { return odometry_; }
  /// Where odometry was silent for so long that the localization node starts afresh.
  [[nodiscard]] const std::vector<Silence>& silences() const { return silences_; }
  [[nodiscard]] const std::vector<ReceivedMessage>& received() const { return received_; }
  /// "TOPIC: REASON, N times" for what was left out.
  [[nodiscard]] std::vector<std::string> refusals() const;

 private:
  template <class Message>
  [[nodiscard]] Message read(const rosbag::MessageInstance& message) const;
  void add(const nav_msgs::Odometry& message);
  void add(const GnssMessage& message);
  void add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix);
  void add(const tf2_msgs::TFMessage& message);
  void note_restart(double stamp);
  void take_truth(const rosbag::MessageInstance& message);
  void add_truth(const std_msgs::Header& header, const geometry_msgs::Pose& message);
  void give_up(const sensor_msgs::NavSatFix& fix);
  /// Whether that reason lets it pass; counts it otherwise.
  bool passes(const std::string& topic, Reason reason);
  [[nodiscard]] std::string topic_of(std::size_t kind) const;
  [[nodiscard]] std::optional<geometry_msgs::Transform> transform(const std::string& parent,
                                                                  const std::string& child) const;

  std::string file_;
  BagTopics topics_;
  OdometryReader reader_{{}, ""};
  FixPairing pairing_{GnssParameters{}.pair_tolerance};
  tf2::BufferCore tf_;
  std::string base_frame_, truth_frame_;
  std::vector<OdometryIncrement> odometry_;
  std::vector<Silence> silences_;
  std::vector<ReceivedMessage> received_;
  std::map<double, Pose2> truth_;
  std::map<double, bool> shadows_;
  bool turns_ = false;  ///< truth has a heading: one that is always zero was never filled in
  std::map<std::string, int> refusals_;
};

}  // namespace multipath_localization
