#include "multipath_localization/estimators/nishida_particle_filter.hpp"

namespace multipath_localization {

void NishidaParticleFilterParameters::fields(ParameterVisitor& field) {
  common_fields(field);
  bias.fields(field);
  ring.fields(field);
}

}  // namespace multipath_localization
