#include "estimators/nishida/conventional_particle_filter.hpp"

namespace multipath_localization {

ConventionalParticleFilterParameters::ConventionalParticleFilterParameters() {
  ring.ring_fraction = 0.0;
  ring.shadow_weight = 0.0;
  // With nothing but motion noise to follow a biased fix, less of it loses the fix for good.
  motion.noise_scale = 1e-2;
}

}  // namespace multipath_localization
