#pragma once

#include <cstdint>
#include <optional>

#include "estimators/pseudorange_mixture/pseudorange_mixture_filter.hpp"
#include "satellite_drive.hpp"

namespace multipath_localization {

/// Fewer subsets: an open sky needs no search.
inline PseudorangeMixtureFilterParameters quick() {
  PseudorangeMixtureFilterParameters parameters;
  parameters.subsets = 100;
  parameters.hypotheses = 40;
  return parameters;
}

class Started {
 public:
  explicit Started(std::uint64_t seed, const PseudorangeMixtureFilterParameters& parameters = quick())
      : filter(parameters, seed), drive(seed) {
    filter.start(std::nullopt);
  }
  PseudorangeMixtureFilter filter;
  SatelliteDrive drive;
};

}  // namespace multipath_localization
