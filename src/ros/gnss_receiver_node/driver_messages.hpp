#pragma once

#include <topic_tools/shape_shifter.h>

#include <optional>
#include <string>

#include "rinex/ephemerides.hpp"
#include "rinex/observation_file.hpp"

/// Messages of receivers' drivers, read without their packages.
namespace multipath_localization {

/// The payload of UBX-RXM-RAWX that a ublox_msgs/RxmRAWX holds, which is laid out as the protocol's with the
/// length of its list before that; nothing of any other message.
std::optional<std::string> rawx_payload(const topic_tools::ShapeShifter& message);

/// The same of ublox_msgs/RxmSFRBX and UBX-RXM-SFRBX.
std::optional<std::string> sfrbx_payload(const topic_tools::ShapeShifter& message);

/// What a gnss_comm/GnssMeasMsg holds: of each satellite the pseudorange on L1, E1, B1I or else B1C, or G1.
/// Nothing of any other message, by its md5, and of one without measurements.
std::optional<RawEpoch> gnss_comm_epoch(const topic_tools::ShapeShifter& message);

/// The orbit in a gnss_comm/GnssEphemMsg or GnssGloEphemMsg; nothing of any other message, and of an
/// impossible orbit.
std::optional<Ephemeris> gnss_comm_ephemeris(const topic_tools::ShapeShifter& message);

}  // namespace multipath_localization
