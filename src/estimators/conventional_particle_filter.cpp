#include "multipath_localization/estimators/conventional_particle_filter.hpp"

namespace multipath_localization {

ConventionalParticleFilterParameters::ConventionalParticleFilterParameters() {
  ring.ring_fraction = 0.0;
  ring.shadow_weight = 0.0;
}

}  // namespace multipath_localization
