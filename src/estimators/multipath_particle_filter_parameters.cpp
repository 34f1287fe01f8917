#include "multipath_localization/estimators/multipath_particle_filter.hpp"

namespace multipath_localization {

void MultipathParticleFilterParameters::fields(ParameterVisitor& field) {
  tunable(field);
  field.group("classes", classes, "kinds of place and receiver");
}

void MultipathParticleFilterParameters::tunable(ParameterVisitor& field) {
  field("particles", particles, {20, 100000}, "1", "hypotheses, each with a Kalman filter of its own");
  field("ess_fraction", ess_fraction, {0.0, 1.0}, "1",
        "resample below this effective share of a class's hypotheses");
  field("class_floor", class_floor, {0.0, 0.2}, "1",
        "least share of the hypotheses that a receiver class keeps");
  field("class_evidence_time", class_evidence_time, {0.01, 1000.0}, "s",
        "fixes within this time count as one piece of evidence about the receiver class");
  field("restart_sigma", restart_sigma, {0.1, 100.0}, "m",
        "uncertainty of position at a restart from the fixes");
  field("largest_bias", largest_bias, {0.1, 1e4}, "m",
        "a larger bias is believed in a canyon alone; elsewhere it makes the pose unconfirmed");
  field("doubtful_sigma", doubtful_sigma, {0.1, 1e6}, "m",
        "so does a larger standard deviation of position over all hypotheses");
  field("heading_restart_rate", heading_restart_rate, {0.0, 1.0}, "1/s",
        "rate of restarts of the heading from the fixes once the pose is confirmed");
  field("slip_end_rate", slip_end_rate, {0.01, 100.0}, "1/s", "rate of wheel slip ending");
  field("alignment_length", alignment_length, {1.0, 200.0}, "m",
        "distance over which the fixes give the heading for restarts");
  field("alignment_variance_floor", alignment_variance_floor, {1e-6, 1.0}, "rad^2",
        "variance of that heading at best: a bias that turns tilts it");
  field("confirm_probability", confirm_probability, {0.5, 1.0}, "1",
        "probability of open sky that counts towards confirming the pose");
  field("confirm_distance", confirm_distance, {0.0, 1000.0}, "m",
        "driving under open sky that confirms the pose");
  field("confirmed_start", confirmed_start, "whether a pose to start from counts as confirmed");
  field("sigma_factor", sigma_factor, {1.0, 10.0}, "1",
        "published standard deviations of the pose in those of the hypotheses: no model of errors is exact");
  field("position_sigma_floor", position_sigma_floor, {0.0, 100.0}, "m",
        "added to the published position: no covariance is believed below it");
  field("unconfirmed_sigma", unconfirmed_sigma, {0.0, 100.0}, "m",
        "added instead until the pose is confirmed: it may have started in a shadow");
  field.group("odometry", odometry, "how far the wheel odometry can be trusted");
  field.group("steady_bias", steady_bias, "when a bias of the fixes is rather an error of the pose");
  field.group("odometry_jump", odometry_jump, "when the wheel odometry is suspected of a fault");
}

}  // namespace multipath_localization
