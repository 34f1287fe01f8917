#pragma once

#include <cstddef>

#include "multipath_localization/core/measurements.hpp"
#include "support/csv.hpp"

namespace multipath_localization {

/// What a row of a table of fixes claims in its column `status`, by default a single fix. Throws DriveError
/// for what is none.
FixStatus status_of(const CsvTable& table, std::size_t row);

/// The same of the column `level`, which tells nothing by default.
FixLevel level_of(const CsvTable& table, std::size_t row);

}  // namespace multipath_localization
