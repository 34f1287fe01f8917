#include "estimators/pseudorange_mixture/error_scales.hpp"

#include <algorithm>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kMedianSigmas = 0.6745;  // within which half of all normal errors lie
constexpr double kScaleGain = 0.01;       // a hundred range rates change their scale by e
constexpr double kLeastRangeScale = 0.5;
constexpr double kMostRangeScale = 4.0;
constexpr double kLeastRateScale = 0.1;
constexpr double kMostRateScale = 5.0;
constexpr double kBiasMemory = 60.0;      // over which biases tell their size [s]
constexpr double kPriorSatellites = 4.0;  // that what the parameters say is worth
constexpr double kMostBiasScale = 4.0;

/// A scale by which half of all errors are to lie within the median of a normal one.
double towards_median(double scale, double sigmas, double weight) {
  const double step = std::exp(kScaleGain * weight);
  return std::abs(sigmas) > kMedianSigmas ? scale * step : scale / step;
}

}  // namespace

void ErrorScales::learn_range(double sigmas, double weight) {
  range = std::clamp(towards_median(range, sigmas, weight), kLeastRangeScale, kMostRangeScale);
}

void ErrorScales::learn_rate(double sigmas, double weight) {
  rate = std::clamp(towards_median(rate, sigmas, weight), kLeastRateScale, kMostRateScale);
}

void ErrorScales::learn_bias(double sum_of_squares, double satellites, double duration) {
  const double variance = (kPriorSatellites + sum_of_squares) / (kPriorSatellites + satellites);
  const double learnt = square(bias) + (variance - square(bias)) * (1.0 - std::exp(-duration / kBiasMemory));
  bias = std::sqrt(std::clamp(learnt, 1.0 / kMostBiasScale, kMostBiasScale));
}

void ErrorScales::mix(const ErrorScales& other, double share) {
  range += share * (other.range - range);
  rate += share * (other.rate - rate);
  bias += share * (other.bias - bias);
}

}  // namespace multipath_localization
