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
  mixture.fields(field);
}

void PseudorangeMixtureFilterParameters::fields(ParameterVisitor& field) {
  field("hypotheses", hypotheses, {1, 10000}, "1", "Kalman filters at the start; most are soon dropped");
  field("subsets", subsets, {1, 100000}, "1", "random subsets of satellites whose positions are tried");
  field("start_sigma", start_sigma, {0.1, 1e4}, "m", "1 sigma of a hypothesis' position at its start");
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
