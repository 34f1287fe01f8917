#pragma once

#include <string>
#include <vector>

#include "receiver/live_positioning.hpp"
#include "receiver/ubx_receiver.hpp"
#include "tools/doctor/finding.hpp"

namespace multipath_localization {

/// What was seen of a receiver's own stream.
struct RawStream {
  std::string name;
  std::string trouble;  ///< why it cannot be read; empty where it can
  std::size_t bytes = 0;
  std::size_t messages = 0;  ///< of UBX, whole
  std::size_t checksum_errors = 0;
  StreamCounts counts;
  std::vector<GnssTime> epochs;
  std::size_t with_position = 0;   ///< of them, those that became corrected epochs
  LivePositioning::Standing last;  ///< at the last of them
};

/// Reads a file to its end, anything else for so long [s]. `source`, `baud`: as of ByteSource, which throws
/// ParameterError.
RawStream observe_stream(const std::string& source, int baud, double seconds);

/// Whether there are bytes, UBX messages, RXM-RAWX often enough and without gaps, RXM-SFRBX, ephemerides of
/// the satellites heard, and positions.
Findings check_stream(const RawStream& seen);

}  // namespace multipath_localization
