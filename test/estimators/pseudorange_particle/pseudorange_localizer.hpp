#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <optional>
#include <string>

#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "pseudorange_drive.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {

inline Localizer localizer_with(const std::string& parameters = "{}", std::uint64_t seed = 1,
                                const std::optional<PosePrior>& prior = std::nullopt) {
  Localizer localizer(make_estimator("pseudorange_particle_filter", YAML::Load(parameters), seed), {});
  localizer.start(prior);
  return localizer;
}

inline double root_mean_square(PseudorangeDrive& drive, Localizer& localizer, double duration) {
  RootMeanSquare rms;
  drive.run(localizer, duration,
            [&] { rms.add(localizer.estimate().pose.position() - drive.truth.position()); });
  return rms.value();
}

}  // namespace multipath_localization
