#include "multipath_localization/models/pseudorange/satellite_mixture.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kHalf = 0.5;
constexpr double kLeastPrior = 0.03;  // no C/N0 proves a mode
constexpr double kMostPrior = 0.97;
constexpr double kLeastCosine = 0.2;      // of the elevation: an edge delays at the zenith too
constexpr double kOutlierDensity = 1e-7;  // of errors of either mode that the mixture cannot explain [1/m]
constexpr double kAsymptotic = 10.0;      // from here on the series of erfc is exact to 1e-7

double log_gaussian(double error, double variance) {
  return -kHalf * (error * error / variance + std::log(2.0 * kPi * variance));
}

double log_erfc(double z) {
  if (z < kAsymptotic) return std::log(std::erfc(z));
  const double s = 1.0 / (2.0 * z * z);
  return -z * z - std::log(z * std::sqrt(kPi)) + std::log1p(-s * (1.0 - 3.0 * s * (1.0 - 5.0 * s)));
}

}  // namespace

void SatelliteMixtureParameters::fields(ParameterVisitor& field) {
  field("cn0_midpoint", cn0_midpoint, {-30.0, 30.0}, "dB",
        "C/N0 against that of the receiver's strong signals at which a satellite at 30 deg is as likely in "
        "line of sight as not");
  field("cn0_width", cn0_width, {0.1, 20.0}, "dB-Hz", "step of C/N0 that changes the odds of LOS by e");
  field("elevation_weight", elevation_weight, {0.0, 20.0}, "1",
        "change of the log odds of LOS per sine of the elevation");
  field("nlos_delay", nlos_delay, {1.0, 1000.0}, "m",
        "mean delay of a reflected signal at the horizon; falls with the cosine of the elevation");
}

double line_of_sight_prior(const SatelliteObservation& observation,
                           const SatelliteMixtureParameters& parameters) {
  const double cn0 = std::isfinite(observation.cn0) ? observation.cn0 : parameters.cn0_midpoint;
  const double log_odds = (cn0 - parameters.cn0_midpoint) / parameters.cn0_width +
                          parameters.elevation_weight * (std::sin(observation.elevation) - kHalf);
  return std::clamp(1.0 / (1.0 + std::exp(-log_odds)), kLeastPrior, kMostPrior);
}

double mean_nlos_delay(double elevation, const SatelliteMixtureParameters& parameters) {
  return parameters.nlos_delay * std::max(kLeastCosine, std::cos(elevation));
}

double log_exponentially_modified_gaussian(double error, double sigma, double mean) {
  const double ratio = sigma / mean;
  const double z = (ratio - error / sigma) / std::sqrt(2.0);
  return -std::log(2.0 * mean) + kHalf * ratio * ratio - error / mean + log_erfc(z);
}

MixtureWeight weigh(double error, double variance, double delay, double prior) {
  const double los = log_gaussian(error, variance);
  const double late = log_exponentially_modified_gaussian(error, std::sqrt(variance), delay);
  const double nlos = log_sum(late, std::log(kOutlierDensity));
  const double log_los = std::log(prior) + los;
  const double log_nlos = std::log1p(-prior) + nlos;
  MixtureWeight weight;
  weight.log_likelihood = log_sum(log_los, log_nlos);
  weight.log_ratio = los - nlos;
  weight.line_of_sight = std::exp(log_los - weight.log_likelihood);
  return weight;
}

}  // namespace multipath_localization
