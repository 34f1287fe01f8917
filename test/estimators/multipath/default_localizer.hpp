#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "estimators/multipath/multipath_particle_filter.hpp"
#include "multipath_localization/localization/localizer.hpp"

namespace multipath_localization {

/// The default filter as it comes on a stream, started without a prior.
inline Localizer default_localizer(std::uint64_t seed) {
  Localizer localizer(std::make_unique<MultipathParticleFilter>(MultipathParticleFilterParameters{}, seed),
                      LocalizerParameters{});
  localizer.start(std::nullopt);
  return localizer;
}

}  // namespace multipath_localization
