#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "multipath_localization/core/measurement_kinds.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/messages/epoch_conversions.hpp"
#include "ros/messages/heading_conversions.hpp"
#include "ros/messages/imu_conversions.hpp"
#include "ros/messages/velocity_conversions.hpp"

namespace multipath_localization {

/// A fix of one of a robot's receivers.
struct ReceiverFix : sensor_msgs::NavSatFix {
  ReceiverFix(const sensor_msgs::NavSatFix& fix = {}, std::size_t number = 0)  // NOLINT: most robots have one
      : sensor_msgs::NavSatFix(fix), receiver(number) {}

  std::size_t receiver;                ///< as in GnssFix
  FixLevel level = FixLevel::kUntold;  ///< as its driver tells beside it
};

/// What comes in of GNSS. The index is that of what becomes of it, in Measurement.
using GnssMessage = std::variant<ReceiverFix, FixPair, GnssEpoch, geometry_msgs::TwistWithCovarianceStamped,
                                 sensor_msgs::Imu>;

/// Receivers of fixes that a robot may have.
constexpr std::size_t kMostReceivers = 4;
/// "fix", of further receivers "fix_2", "fix_3" and so on.
std::string fix_name(std::size_t receiver);
/// "gps/fix", of further receivers "gps_2/fix", "gps_3/fix" and so on.
std::string fix_topic(std::size_t receiver);
/// "gps/level", of further receivers "gps_2/level" and so on.
std::string level_topic(std::size_t receiver);
/// The name of any kind: "dual", "epoch", ...
std::string name_of(const GnssMessage& message);
std::string name_of(const Measurement& measurement);

using UsedKinds = std::array<bool, kMeasurementNames.size()>;
static_assert(std::variant_size_v<GnssMessage> == kMeasurementNames.size());

/// How GNSS messages are read.
struct GnssParameters {
  std::vector<double> antenna;
  bool require_antenna_transform = false;
  double pair_tolerance = 0.05;
  double delay = 0.0;
  FixParameters fix;
  EpochParameters epoch;
  VelocityParameters velocity;
  HeadingParameters heading;

  /// Where a lone antenna is that tf does not place on the robot [m].
  [[nodiscard]] Eigen::Vector2d antenna_otherwise() const;
  /// ": a lone antenna is taken to be ...", what becomes of one that tf does not place on the robot.
  [[nodiscard]] std::string otherwise_at() const;

  /// Throws ParameterError on an antenna that is neither empty nor two numbers.
  void fields(ParameterVisitor& field);
};

/// A message as if it was stamped `delay` earlier [s]; a stamp of zero stays, and no other becomes zero.
template <class Stamped>
Stamped stamped_earlier(Stamped message, double delay) {
  if (message.header.stamp.isZero()) return message;
  const double stamp = message.header.stamp.toSec() - delay;
  const bool there_is = stamp > 0.0 && stamp < std::numeric_limits<std::uint32_t>::max();
  message.header.stamp = there_is ? message.header.stamp - ros::Duration(delay) : ros::Time(0, 1);
  return message;
}

/// A measurement, or the reason why there is none.
struct CheckedMeasurement {
  Reason reason = Reason::kAccepted;
  Measurement measurement;  ///< counts only when accepted
};

/// Finds the antenna of a frame on the base [m], nothing when tf does not know the frame.
using AntennaFinder = std::function<std::optional<Eigen::Vector2d>(const std::string& frame)>;

/// Of the antennas, one or two; none of a heading.
std::vector<std::string> frames_of(const GnssMessage& message);

/// Of a pair the later one's.
const std_msgs::Header& header_of(const GnssMessage& message);

/// Root of the mean horizontal variance as declared, of a pair over both [m], of a velocity [m/s], of a
/// heading [rad]; NaN where none is, as for an epoch.
double declared_sigma(const GnssMessage& message);

/// Number of pseudoranges of an epoch, 0 for fixes.
std::size_t satellites_of(const Measurement& measurement);
std::size_t satellites_of(const GnssMessage& message);

/// What of the message can be judged without datum and antenna: `accepted`, or the reason why not.
Reason check(const GnssMessage& message, const GnssParameters& parameters);

/// Where a message that passed `check` puts the antenna, of a pair the left one; nothing for an epoch that
/// does not tell, for a velocity and for a heading.
std::optional<Geodetic> place_of(const GnssMessage& message, const GnssParameters& parameters);

/// Reads a message by the tables of `to_fix`, `to_dual`, `to_epoch`, `to_velocity` and `to_heading`. An
/// antenna whose frame is unknown is taken to be where `antenna` says, by default at the base, unless its
/// transform is required or it is one of two; a sensor of a heading whose frame is unknown, to be turned as
/// the base is.
CheckedMeasurement to_measurement(const GnssMessage& message, const LocalFrame& map,
                                  const GnssParameters& parameters, const AntennaFinder& antenna_in_base,
                                  const RotationFinder& rotation_in_base = nullptr);

}  // namespace multipath_localization
