#include "multipath_localization/estimators/steady_bias.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

void SteadyBiasParameters::fields(ParameterVisitor& field) {
  field("tolerance", tolerance, {0.01, 100.0}, "m",
        "a bias that changes by less is steady, a smaller one is none");
  field("distance", distance, {1.0, 1e5}, "m",
        "driving with a steady bias after which the pose is as likely to be wrong as the fixes");
  field("time", time, {1.0, 1e5}, "s", "the same in time, whichever comes later");
  field("prior", prior, {1e-9, 0.5}, "1", "probability that it is the pose, when the bias begins");
}

void SteadyBias::add(const Eigen::Vector2d& bias, double distance, double duration,
                     const SteadyBiasParameters& parameters) {
  if (bias.norm() < parameters.tolerance) return clear();
  const double step = std::min(distance / parameters.distance, duration / parameters.time);
  const bool steady = (bias - reference_).norm() < parameters.tolerance;
  way_ += steady ? step : -step;
  if (way_ <= 0.0) {
    way_ = step;
    reference_ = bias;
  } else if (steady) {
    reference_ += step / way_ * (bias - reference_);
  }
}

double SteadyBias::probability(const SteadyBiasParameters& parameters) const {
  if (way_ <= 0.0) return 0.0;
  return 1.0 / (1.0 + std::pow(1.0 / parameters.prior - 1.0, 1.0 - way_));
}

}  // namespace multipath_localization
