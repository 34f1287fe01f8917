#include "evaluation/fix_claims.hpp"

#include <initializer_list>
#include <string>

namespace multipath_localization {

namespace {

/// What a column claims, one of those known; `otherwise` where there is no such column.
template <class Claim>
Claim claim_of(const CsvTable& table, std::size_t row, const std::string& column, Claim otherwise,
               std::initializer_list<Claim> known) {
  if (!table.has(column)) return otherwise;
  const double told = table.number(row, column);
  std::string numbers;
  for (const Claim claim : known) {
    if (told == static_cast<double>(claim)) return claim;
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(static_cast<int>(claim));
  }
  throw table.error(row, column + " is none of " + numbers);
}

}  // namespace

FixStatus status_of(const CsvTable& table, std::size_t row) {
  return claim_of(
      table, row, "status", FixStatus::kSingle,
      {FixStatus::kNone, FixStatus::kSingle, FixStatus::kSatelliteBased, FixStatus::kGroundBased});
}

FixLevel level_of(const CsvTable& table, std::size_t row) {
  return claim_of(
      table, row, "level", FixLevel::kUntold,
      {FixLevel::kUntold, FixLevel::kSingle, FixLevel::kDifferential, FixLevel::kFloat, FixLevel::kFixed});
}

}  // namespace multipath_localization
