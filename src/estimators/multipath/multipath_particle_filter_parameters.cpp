#include "estimators/multipath/multipath_particle_filter.hpp"

namespace multipath_localization {

void MultipathParticleFilterParameters::fields(ParameterVisitor& field) {
  tunable(field);
  field("turn_scale_sigma", turn_scale_sigma, {0.0, 0.5}, "1",
        "1 sigma of the unknown scale error of turns at start");
  field.group("odometry_jump", odometry_jump, "when the wheel odometry is suspected of a fault");
}

void MultipathParticleFilterParameters::tunable(ParameterVisitor& field) {
  field("particles", particles, {20, 100000}, "1",
        "hypotheses, each with a Kalman filter of its own; more until the heading is known");
  field("largest_bias", largest_bias, {1.0, 1e4}, "m", "of fixes in a shadow, about the width of a street");
  field("time_between_shadows", time_between_shadows, {1.0, 1e5}, "s",
        "of driving under open sky before the next house");
  field("stamp_sigma", stamp_sigma, {0.0, 10.0}, "s",
        "1 sigma of what the stamps of fixes and odometry may be apart: at speed it makes the pose less "
        "certain along the way");
  field("sigma_factor", sigma_factor, {1.0, 10.0}, "1",
        "published standard deviations of the pose in those of the hypotheses: no model of errors is exact");
  field("uncorrected_sigma", uncorrected_sigma, {0.0, 100.0}, "m",
        "1 sigma of what all fixes of a drive may be off by alike where the receiver gets no corrections "
        "(NavSatStatus 0): ionosphere and orbits, which nothing on the robot sees; added to the published "
        "position; 0 for one with corrections whose driver does not tell");
  field("position_sigma_floor", position_sigma_floor, {0.0, 100.0}, "m",
        "added to the published position: no covariance is believed below it");
  field.group("odometry", odometry, "how far the wheel odometry can be trusted, within a factor of two");
}

}  // namespace multipath_localization
