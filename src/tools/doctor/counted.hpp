#pragma once

#include <algorithm>
#include <string>

#include "tools/doctor/finding.hpp"
#include "tools/doctor/observations.hpp"

namespace multipath_localization {

/// How many of the fixes that is true of.
template <class Predicate>
std::size_t count(const Observations& seen, const Predicate& predicate) {
  return static_cast<std::size_t>(std::count_if(
      seen.fixes.begin(), seen.fixes.end(), [&](const auto& arrived) { return predicate(arrived.message); }));
}

/// "fix: SOME of ALL what"
inline std::string of_all(std::size_t some, const Observations& seen, const std::string& what) {
  return text("fix: %zu of %zu %s", some, seen.fixes.size(), what.c_str());
}

/// Whether that is more than a tenth of the fixes, which nobody loses without being told.
inline bool is_loss(std::size_t some, const Observations& seen) { return 10 * some > seen.fixes.size(); }

}  // namespace multipath_localization
