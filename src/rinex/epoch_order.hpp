#pragma once

#include <cstddef>
#include <vector>

#include "rinex/gnss_time.hpp"

namespace multipath_localization {

/// The places of the longest series of ever later times, of several as long the one that begins first: one
/// wrong date costs that one, wherever it is.
std::vector<std::size_t> longest_in_order(const std::vector<GnssTime>& times);

}  // namespace multipath_localization
