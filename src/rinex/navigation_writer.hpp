#pragma once

#include <string>

#include "rinex/navigation_file.hpp"

namespace multipath_localization {

/// A navigation file, RINEX 3.04 of mixed systems, that `read_navigation` gives the same ephemerides and
/// ionosphere from, to the 13 and 5 digits that the format has. What they do not hold (issues of data,
/// accuracies, weeks of other scales) is filled in: other programs read it too, and it tells no more.
std::string navigation_text(const Navigation& navigation);

}  // namespace multipath_localization
