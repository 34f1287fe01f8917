#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

#include "ros/inputs/antenna_frames.hpp"
#include "ros/localization_node/frame_patience.hpp"
#include "ros/messages/gnss_message.hpp"

namespace multipath_localization {

/// Which antennas tf has placed on the base, which it is still given a moment for, and which are taken to be
/// elsewhere meanwhile.
class AntennaPlacement {
 public:
  /// `antennas` has to outlive it.
  AntennaPlacement(AntennaFrames& antennas, const GnssParameters& parameters)
      : antennas_(antennas), otherwise_(parameters.antenna_otherwise()) {}

  /// Whether tf may yet place an antenna of the message and is given a moment to: at `stamp` of odometry, and
  /// `wall` of the wall clock [s].
  bool waits(const GnssMessage& message, double stamp, double wall);

  /// Whether tf has placed an antenna of the message since that was taken to be elsewhere.
  bool appeared(const GnssMessage& message);

  /// The message is used: those of its antennas that tf does not place are taken to be where the parameters
  /// say.
  void assume(const GnssMessage& message);

 private:
  AntennaFrames& antennas_;
  Eigen::Vector2d otherwise_;  ///< in the base [m]
  FramePatience patience_;
  std::map<std::string, Eigen::Vector2d> assumed_;  ///< by frame [m]
};

}  // namespace multipath_localization
