#pragma once

#include "multipath_localization/estimators/fix_particle_filter.hpp"

namespace multipath_localization {

/// The filter of [NIS], Eqs. (3)-(43), as a configuration of `FixParticleFilter`.
///
/// The defaults are the readings of the paper that measured best. The paper to the letter is noise_scale 1,
/// max_steering_angle 1.57, bias_input absolute, bias_process_noise 0, ring_weight printed, likelihood_kernel
/// cross, use_declared_covariance false, fix_heading printed with fix_heading_distance 0, propagate_from
/// particles (section 3.3) or estimate (Algorithm 1), point_estimate mean.
struct NishidaParticleFilterParameters : FixParticleFilterParameters {
  void fields(ParameterVisitor& field);
};

}  // namespace multipath_localization
