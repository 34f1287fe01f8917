#include "estimators/pseudorange_particle/pseudorange_particle_filter_parameters.hpp"

namespace multipath_localization {

void SubsetLikelihoodParameters::fields(ParameterVisitor& field) {
  field("likelihood", likelihood, {"density", "distance"},
        "density = the normal density of the subset's position at the particle; distance = without its "
        "determinant, as Eq. (12) prints: a subset that says little then explains every particle");
  field("likelihood_sigma", likelihood_sigma, {0.01, 100.0}, "1", "sigma of Eq. (12)");
  field("outlier_sigma", outlier_sigma, {0.0, 1e4}, "m",
        "with density, no particle weighs less than one whose subset fixes it to no more than this on each "
        "axis; 0 = no such floor, as printed");
  field("tempering", tempering, {"time", "none"},
        "time = an epoch weighs as much as the time since the last one; none = each the same, as printed");
  field("evidence_rate", evidence_rate, {0.0, 100.0}, "1/s",
        "with tempering, whole epochs that a second of data is worth: errors last for seconds");
  field("standing_evidence", standing_evidence, {0.0, 1.0}, "1",
        "share of that while the robot stands, where reflections do not change");
}

void PseudorangeParticleFilterParameters::fields(ParameterVisitor& field) {
  field("particles", particles, {1, 100000}, "1", "hypotheses of position and heading");
  field("ess_fraction", ess_fraction, {0.0, 1.0}, "1",
        "resample at this effective share of the particles; 1 = at every epoch, as printed");
  field("start", start, {"robust", "plain"},
        "where particles start: robust = round the fix that doubts late signals; plain = round least squares "
        "over all, as printed");
  field("start_sigma", start_sigma, {0.0, 1e3}, "m",
        "spread of each coordinate round the fix, beside its own covariance");
  field("reset", reset, {"robust", "never"},
        "robust = particles are sent to the robust fix, a few at any time, all when none has a subset; never "
        "as printed");
  field("restart_rate", restart_rate, {0.0, 1.0}, "1/s",
        "share of the particles that start anew each second, from the robust fix with about their heading");
  field("reset_after", reset_after, {0.0, 600.0}, "s", "all start anew when none had a subset for this long");
  field("point_estimate", point_estimate, {"cluster", "mean"},
        "the estimate: cluster = mean of the dominant cluster; mean = of all particles, as printed");
  field("position_sigma_floor", position_sigma_floor, {0.001, 100.0}, "m",
        "added to the published position: a collapsed set of particles is not certain");
  field("weighting", weighting, {"signal", "declared"},
        "of pseudoranges: signal = by declared standard deviation, elevation and C/N0; declared = by the "
        "first alone, as printed");
  field("constellations", constellations, {"tied", "separate"},
        "clocks of the constellations: tied = one, their offsets are tracked; separate = a new one each at "
        "every epoch");
  field("inter_system_sigma", inter_system_sigma, {0.01, 1e4}, "m",
        "1 sigma of a tied constellation's offset at its first epoch");
  subset.fields(field);
  likelihood.fields(field);
  motion.fields(field);
  robust.fields(field);
}

}  // namespace multipath_localization
