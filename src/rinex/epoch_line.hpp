#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rinex/gnss_time.hpp"
#include "rinex/line_reader.hpp"

namespace multipath_localization {

/// What the line says that begins an epoch of observations.
struct EpochLine {
  bool version_2 = false;
  int flag = 0;   ///< 0, 1: observations, 6: cycle slips in their form, 2 to 5: events
  int count = 0;  ///< of satellites, of an event's lines

  [[nodiscard]] bool slips() const { return flag == 6; }
  [[nodiscard]] bool event() const { return flag >= 2 && !slips(); }

  /// The time in the current line, which has to be the epoch's. Throws RinexError.
  [[nodiscard]] GnssTime time(const LineReader& in, TimeScale scale, std::optional<int> leap_seconds) const;

  /// The satellites that an epoch of version 2 lists in its line, the current one, and those after it, each
  /// of 3 characters where all is well; none of version 3. Throws UnexpectedEnd.
  std::vector<std::string> satellites(LineReader& in) const;
};

/// Whether the current line looks like one that begins an epoch.
bool epoch_begins(const LineReader& in, bool version_2);

/// Reads the current line, and moves its columns to where they belong if they are off by one or two. Throws
/// RinexError.
EpochLine read_epoch_line(LineReader& in, bool version_2);

}  // namespace multipath_localization
