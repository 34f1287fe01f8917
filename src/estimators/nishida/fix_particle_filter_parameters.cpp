#include "estimators/nishida/fix_particle_filter.hpp"

namespace multipath_localization {

void RingParameters::fields(ParameterVisitor& field) {
  field("ring_fraction", ring_fraction, {0.0, 1.0}, "1",
        "share of the particles drawn on the ring round the estimate at each fix, Eq. (22)");
  field("ring_weight", ring_weight, {"deviation", "printed"},
        "weight of a particle on the ring, Eq. (26): deviation = by rho - r_hat; printed = by rho");
  field("shadow_place", shadow_place, {"ring", "vector"},
        "where a fix in shadow puts the robot, Eq. (32): ring = r_hat from it in any direction, as printed; "
        "vector "
        "= where the bias comes from");
  field("shadow_weight", shadow_weight, {0.0, 1.0}, "1", "share of the shadow's likelihood in Eq. (33)");
}

void FixParticleFilterParameters::common_fields(ParameterVisitor& field) {
  sampling.fields(field);
  field("ess_threshold", ess_threshold, {0.0, 100000.0}, "1",
        "resample when the effective sample size, Eq. (39), falls below it");
  field("propagate_from", propagate_from, {"particles", "estimate"},
        "where particles move on from after a fix: particles = each from itself, section 3.3; estimate = all "
        "from the estimate, Algorithm 1");
  field("point_estimate", point_estimate, {"cluster", "mean"},
        "the estimate: cluster = mean of the dominant cluster, never between two; mean = of all particles, "
        "as Eq. (35) prints");
  field("start_sigma", start_sigma, {0.0, 1e3}, "m",
        "spread of the particles round the first fix, beside sigma_b");
  field("position_sigma_floor", position_sigma_floor, {0.001, 100.0}, "m",
        "added to the published position: a collapsed set of particles is not certain");
  motion.fields(field);
  likelihood.fields(field);
  heading.fields(field);
}

}  // namespace multipath_localization
