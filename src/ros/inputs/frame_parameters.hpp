#pragma once

#include <string>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// Names of the frames of REP-105; a leading slash, which tf2 knows none of, is left out.
struct FrameParameters {
  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_link_frame = "base_link";

  void fields(ParameterVisitor& field);
};

}  // namespace multipath_localization
