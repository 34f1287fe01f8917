#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/measurement_kinds.hpp"
#include "multipath_localization/core/reason_tally.hpp"
#include "ros/bags/bag_odometry.hpp"
#include "ros/bags/bag_refusals.hpp"
#include "ros/bags/bag_topics.hpp"
#include "ros/inputs/antenna_frames.hpp"
#include "ros/inputs/fix_pairing.hpp"
#include "ros/messages/gnss_message.hpp"

namespace multipath_localization {

struct ReceivedMessage {
  GnssMessage message;
  double arrival = 0.0;  ///< stamp of the last odometry before it [s]
};

/// The GNSS messages of a bag, and what was left out of each kind.
class BagMeasurements {
 public:
  /// All four outlive it.
  BagMeasurements(const BagTopics& topics, const BagOdometry& odometry, AntennaFrames& antennas,
                  BagRefusals& refusals)
      : topics_(topics), odometry_(odometry), antennas_(antennas), refusals_(refusals) {}

  void add(const GnssMessage& message);
  /// A fix of one of two antennas, which waits for that of the other.
  void add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix);
  /// There are no more: gives up what is still without its other half.
  void finish();

  /// Counts something left out of a kind of GNSS message.
  void refuse(std::size_t kind, Reason reason);
  /// The datum that the node would find by the messages (DatumSearch), nothing where none agree; leaves out
  /// those that are contradicted.
  std::optional<Geodetic> find_datum();

  [[nodiscard]] const std::vector<ReceivedMessage>& received() const { return received_; }
  /// What was left out of each kind.
  [[nodiscard]] const std::array<ReasonTally, kMeasurementNames.size()>& left_out() const {
    return left_out_;
  }

 private:
  void give_up(const sensor_msgs::NavSatFix& fix);
  [[nodiscard]] std::string topic_of(std::size_t kind) const;

  const BagTopics& topics_;
  const BagOdometry& odometry_;
  AntennaFrames& antennas_;
  BagRefusals& refusals_;
  FixPairing pairing_{GnssParameters{}.pair_tolerance};
  std::vector<ReceivedMessage> received_;
  std::array<ReasonTally, kMeasurementNames.size()> left_out_;
};

}  // namespace multipath_localization
