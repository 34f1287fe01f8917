#include "simulation/gauss_markov.hpp"

#include <cmath>

namespace multipath_localization {

Eigen::Vector2d normal2(RandomStream& random, double sigma) {
  const double x = random.normal();
  return {sigma * x, sigma * random.normal()};
}

void GaussMarkov2::step(double duration, RandomStream& random) {
  const double kept = std::exp(-duration / time_constant_);
  value_ = kept * value_ + normal2(random, sigma_ * std::sqrt(1.0 - kept * kept));
}

}  // namespace multipath_localization
