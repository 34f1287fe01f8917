#pragma once

#include <cstddef>
#include <string>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// Names of the frames of a robot that is simulated or played back.
struct RobotFrames {
  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_link_frame = "base_link";
  std::string gps_frame = "gps";
  std::string gps_left_frame = "gps_left";
  std::string gps_right_frame = "gps_right";

  void fields(ParameterVisitor& field);
  /// Of the antenna of a receiver of fixes: `gps_frame`, of further ones that with _2, _3 and so on.
  [[nodiscard]] std::string fix_frame(std::size_t receiver) const;
};

}  // namespace multipath_localization
