#pragma once

#include <cstdint>
#include <functional>

namespace multipath_localization {

/// Share of `count` seeds, from 1 on, for which `holds` does. One filter of random numbers may go wrong on
/// one of them; a method that does so often is what is to be found.
inline double share_of_seeds(std::uint64_t count, const std::function<bool(std::uint64_t)>& holds) {
  std::uint64_t held = 0;
  for (std::uint64_t seed = 1; seed <= count; ++seed) held += holds(seed) ? 1U : 0U;
  return static_cast<double>(held) / static_cast<double>(count);
}

}  // namespace multipath_localization
