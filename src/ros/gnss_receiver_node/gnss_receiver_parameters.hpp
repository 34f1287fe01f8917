#pragma once

#include <string>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// Parameters of gnss_receiver_node.
struct GnssReceiverParameters {
  std::string source;
  int baud = 0;
  std::string stamps = "receiver";
  std::string frame = "gps";
  double elevation_mask_deg = 5.0;
  std::string ephemeris_file;
  std::string navigation_file;
  std::string record_file;
  double rate = 1.0;

  /// Throws ParameterError on a file that is no absolute path.
  void fields(ParameterVisitor& field);
};

}  // namespace multipath_localization
