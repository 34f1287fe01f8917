#include "estimators/nishida/nishida_particle_filter.hpp"

namespace multipath_localization {

NishidaParticleFilterParameters::NishidaParticleFilterParameters() {
  // The ring is centred on the estimate, so that nothing but the likelihood ties the estimate to the fix:
  // with the sharp product it wanders off for good, with the cross it stays at the fix.
  likelihood.likelihood_kernel = LikelihoodKernel::kCross;
}

void NishidaParticleFilterParameters::fields(ParameterVisitor& field) {
  common_fields(field);
  bias.fields(field);
  ring.fields(field);
}

}  // namespace multipath_localization
