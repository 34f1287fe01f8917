#pragma once

#include "estimators/nishida/fix_particle_filter.hpp"

namespace multipath_localization {

/// The filter of [NIS], Eqs. (3)-(43), as a configuration of `FixParticleFilter`.
///
/// The defaults are the readings that measured best with the start unknown, on a 2 m/s loop half in shadow:
/// they follow the fix without losing it. The paper to the letter is noise_scale 1, max_steering_angle 1.57,
/// bias_input absolute, bias_process_noise 0, ring_weight printed, use_declared_covariance false, fix_heading
/// printed with fix_heading_distance 0, point_estimate mean, and propagate_from particles (section 3.3) or
/// estimate (Algorithm 1); likelihood_kernel cross, ess_threshold 5, ring_fraction 0.05, shadow_weight 0.5,
/// the alphas, sigma_b, sigma_s, sigma_p, bias_motion, sky and shadow_place are as printed already. What
/// makes it hold its own simulation is config/working.
///
/// Departs, whatever the options: the ring is drawn at each fix and not at each odometry increment, which
/// come at one rate in [NIS]; and not before the heading is known, which [NIS] takes as given.
struct NishidaParticleFilterParameters : FixParticleFilterParameters {
  NishidaParticleFilterParameters();

  void fields(ParameterVisitor& field);
};

}  // namespace multipath_localization
