#pragma once

#include "estimators/nishida/fix_particle_filter.hpp"

namespace multipath_localization {

/// What [NIS] compares with, Eqs. (46), (47): the same filter without ring sampling and with the likelihood
/// of direct signals alone, as a configuration of `FixParticleFilter`.
struct ConventionalParticleFilterParameters : FixParticleFilterParameters {
  ConventionalParticleFilterParameters();

  void fields(ParameterVisitor& field) { common_fields(field); }
};

}  // namespace multipath_localization
