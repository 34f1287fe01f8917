#include "evaluation/fix_claims.hpp"

namespace multipath_localization {

FixStatus status_of(const CsvTable& table, std::size_t row) {
  if (!table.has("status")) return FixStatus::kSingle;
  const double status = table.number(row, "status");
  for (const FixStatus known :
       {FixStatus::kNone, FixStatus::kSingle, FixStatus::kSatelliteBased, FixStatus::kGroundBased}) {
    if (status == static_cast<double>(known)) return known;
  }
  throw table.error(row, "status is none of -1, 0, 1, 2");
}

FixLevel level_of(const CsvTable& table, std::size_t row) {
  if (!table.has("level")) return FixLevel::kUntold;
  const double level = table.number(row, "level");
  for (const FixLevel known :
       {FixLevel::kUntold, FixLevel::kSingle, FixLevel::kDifferential, FixLevel::kFloat, FixLevel::kFixed}) {
    if (level == static_cast<double>(known)) return known;
  }
  throw table.error(row, "level is none of 0, 1, 2, 3, 4");
}

}  // namespace multipath_localization
