#pragma once

#include <vector>

#include "evaluation/drive.hpp"

namespace multipath_localization {

/// The fixes of a drive, by stamp, that the default filter takes to be free of reflections: nothing but open
/// sky from a second before them until three seconds after them, since a filter sees a shadow late.
std::vector<GnssFix> fixes_under_open_sky(const Drive& drive);

}  // namespace multipath_localization
