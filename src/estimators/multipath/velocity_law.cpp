#include "estimators/multipath/velocity_law.hpp"

#include <cmath>

#include "estimators/multipath/error_laws.hpp"

namespace multipath_localization::multipath {

namespace {

// Declared speed accuracies are right within a factor of three for two receivers of three.
constexpr double kLogSigma = 1.1;
constexpr double kShortestSlow = 0.5;  // the filter of a receiver that is quick [s]
constexpr double kLongestSlow = 6.0;   // and of one that is smooth, or reflections at walking pace [s]
constexpr double kMemory = 300.0;      // a receiver keeps its quality for minutes: a street [s]
constexpr double kBelieved = 0.997;    // of receivers that are wired and set up by people who then drive off

}  // namespace

void draw_velocity_errors(VelocityLaw& law, RandomStream& random) {
  law.white = std::exp(kLogSigma * random.normal());
  law.slow = std::exp(kLogSigma * random.normal());
  law.slow_time = log_uniform(kShortestSlow, kLongestSlow, random);
  law.delay = static_cast<std::size_t>(random.uniform() * static_cast<double>(kDelays));
}

void wander(VelocityLaw& law, double duration, RandomStream& random) {
  if (random.uniform() < duration / kMemory) draw_velocity_errors(law, random);
  if (random.uniform() < duration / kMemory) law.believed = random.uniform() < kBelieved;
}

}  // namespace multipath_localization::multipath
