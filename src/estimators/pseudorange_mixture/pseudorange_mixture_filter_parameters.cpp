#include "estimators/pseudorange_mixture/pseudorange_mixture_filter.hpp"

namespace multipath_localization {

void RangeErrorParameters::fields(ParameterVisitor& field) {
  field("range_sigma", range_sigma, {0.1, 100.0}, "m", "noise of a pseudorange in line of sight");
  field("range_correlation_time", range_correlation_time, {0.0, 100.0}, "s",
        "noise of ranges closer in time than this is one and the same, whatever the rate of the receiver");
  field("evidence_time", evidence_time, {0.1, 1e3}, "s",
        "multipath stays alike for this long: data of this duration count once in weighing hypotheses");
  field("mode_time", mode_time, {0.1, 1e3}, "s",
        "a satellite is in line of sight, or not, for this long; its residuals of this duration count once");
  field("range_rate_sigma", range_rate_sigma, {0.01, 10.0}, "m/s", "noise of a range rate in line of sight");
  field("range_rate_correlation_time", range_rate_correlation_time, {0.0, 100.0}, "s",
        "like range_correlation_time");
  field("clock_jump", clock_jump, {1.0, 1e6}, "m",
        "the receiver clock jumped when most residuals are beyond this, and beyond five sigma");
  mixture.fields(field);
}

void PseudorangeMixtureFilterParameters::fields(ParameterVisitor& field) {
  field("hypotheses", hypotheses, {1, 10000}, "1", "Kalman filters at the start; most are soon dropped");
  field("subsets", subsets, {1, 100000}, "1", "random subsets of satellites whose positions are tried");
  field("start_sigma", start_sigma, {0.1, 1e4}, "m", "1 sigma of a hypothesis' position at its start");
  field("start_up_sigma", start_up_sigma, {0.1, 1e4}, "m", "1 sigma of its height and clock at its start");
  field("start_drift_sigma", start_drift_sigma, {0.1, 1e4}, "m/s", "1 sigma of the unknown clock drift");
  field(
      "least_weight", least_weight, {0.0, 1.0}, "1",
      "a hypothesis lighter than this part of what new ones get together, against the heaviest, is dropped");
  field("reseed_interval", reseed_interval, {0.1, 1e3}, "s",
        "until one cluster has won, new hypotheses are tried this often while moving or in doubt");
  field("reseed_probability", reseed_probability, {0.0, 0.5}, "1", "weight that they get together");
  field("watch_interval", watch_interval, {0.1, 1e3}, "s", "likewise once one has won");
  field("watch_probability", watch_probability, {0.0, 0.5}, "1", "weight that they get together then");
  field("align_probability", align_probability, {0.5, 1.0}, "1",
        "weight of the dominant cluster that settles position and heading");
  field("align_distance", align_distance, {0.0, 1e3}, "m", "distance over which it has to hold it");
  field("least_agreement", least_agreement, {0.0, 1.0}, "1",
        "satellites found in line of sight over those that C/N0 and elevation promise: below it the place is "
        "in doubt and the filter not aligned");
  field("slot_time", slot_time, {1.0, 1e5}, "s", "a satellite unseen for this long is forgotten");
  field("sigma_factor", sigma_factor, {1.0, 10.0}, "1",
        "published standard deviations of the pose in those of the hypotheses: no model of errors is exact");
  field("uncorrected_sigma", uncorrected_sigma, {0.0, 100.0}, "m",
        "1 sigma of what all pseudoranges of a drive may shift the position by alike: ionosphere and orbits, "
        "which nothing on the robot sees; added to the published position");
  field("position_sigma_floor", position_sigma_floor, {0.001, 100.0}, "m", "added to the published position");
  field.group("odometry", odometry, "trust in the wheel odometry");
  field.group("receiver", receiver, "what changes slowly about receiver and satellites");
  field.group("errors", errors, "errors of the measurements");
}

}  // namespace multipath_localization
