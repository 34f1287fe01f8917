#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "rinex/gnss_time.hpp"
#include "rinex/satellite_record.hpp"

namespace multipath_localization {

/// All of one instant, by the receiver's clock.
struct RawEpoch {
  GnssTime time;
  std::vector<RawObservation> observations;
};

/// What an observation file holds.
struct ObservationLog {
  std::vector<RawEpoch> epochs;       ///< later and later
  std::vector<std::string> left_out;  ///< what could not be used: file, line and reason of each
  std::vector<std::string> notices;   ///< what of a header is not believed: file, line and what
  /// Records of satellites of which nothing is taken, by system and the pseudoranges that they have: "BeiDou
  /// C5P", or "GPS without a pseudorange".
  std::map<std::string, std::size_t> unread;
};

/// Reads RINEX observations 2.00 to 2.12 and 3.00 to 3.05, several files joined in one too, whatever their
/// order. Of each satellite it takes the pseudorange of the first of `pseudorange_codes` that the satellite
/// has, with the Doppler shift and C/N0 of the same code. SBAS and NavIC are counted as unread; records of
/// cycle slips and of events are passed over.
///
/// | what cannot be used                                   | what is left out                              |
/// |-------------------------------------------------------|-----------------------------------------------|
/// | a number, a satellite, one a second time in its epoch | the record                                    |
/// | an epoch's line, or what is no line of an epoch       | all up to the next epoch                      |
/// | lines too few or too many for an epoch of version 2,  | the epoch: which line is whose cannot be told |
/// | where satellites are named in the epoch's line        |                                               |
/// | an epoch that the file breaks off in                  | the epoch                                     |
/// | a time out of order                                   | the epoch, so that as many as can be are kept |
/// | a later header                                        | all up to the next header                     |
///
/// Columns of an epoch's line that are moved by one or two are found. Throws RinexError where there is no
/// such file, no header or no types of observations in it.
ObservationLog read_observations(const std::string& file);

}  // namespace multipath_localization
