#pragma once

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// What one pseudorange is: measured along the line of sight (LOS), or late over a reflection or round an
/// edge (NLOS), as [SUZ] tells the two apart; here by probabilities instead of thresholds.
struct SatelliteMixtureParameters {
  double cn0_midpoint = -8.0;
  double cn0_width = 2.2;
  double elevation_weight = 3.0;
  double nlos_delay = 40.0;

  void fields(ParameterVisitor& field);
};

/// Probability that a satellite is in line of sight before its pseudorange is looked at, within (0, 1):
/// logistic in C/N0 and in the sine of the elevation. An untold C/N0 counts as the midpoint.
double line_of_sight_prior(const SatelliteObservation& observation,
                           const SatelliteMixtureParameters& parameters);

/// Mean delay of a reflected signal [m]: a wall at a distance delays by twice that times cos(elevation).
double mean_nlos_delay(double elevation, const SatelliteMixtureParameters& parameters);

/// Log density [log 1/m] at `error` of a Gaussian of standard deviation `sigma` > 0 plus an independent
/// exponential of mean `mean` > 0 [m]: the exponentially modified Gaussian. Finite in both far tails.
double log_exponentially_modified_gaussian(double error, double sigma, double mean);

/// One residual under the mixture.
struct MixtureWeight {
  double log_likelihood = 0.0;
  double log_ratio = 0.0;      ///< log of the likelihoods' ratio, LOS over NLOS
  double line_of_sight = 0.0;  ///< probability of LOS afterwards
};

/// Weighs a residual `error` [m] of `variance` > 0 [m^2] as if in LOS; NLOS adds an exponential delay of mean
/// `delay` [m]. `prior` of LOS within (0, 1).
MixtureWeight weigh(double error, double variance, double delay, double prior);

}  // namespace multipath_localization
