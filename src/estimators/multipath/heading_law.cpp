#include "estimators/multipath/heading_law.hpp"

#include <cmath>

namespace multipath_localization::multipath {

namespace {

constexpr double kLogSigma = 1.1;      // of the noise: a receiver declares what it likes, a compass nothing
constexpr double kOffsetSigma = 0.02;  // of antennas and compasses that are mounted with a square [rad]
constexpr double kWideOffsetSigma = 0.15;  // of those that are mounted by eye, or know magnetic north [rad]
constexpr double kByEye = 0.3;             // share of those
constexpr double kOffsetWalk = 5e-4;  // keeps the guesses of an offset apart from each other [rad/sqrt(s)]
constexpr double kMemory = 100.0;     // iron and reflections of a street [s]
constexpr double kBelieved = 0.97;    // of headings that have once been set up

double draw_noise(RandomStream& random) { return std::exp(kLogSigma * random.normal()); }

}  // namespace

void draw_heading_errors(HeadingLaw& law, double offset, RandomStream& random) {
  law.noise = draw_noise(random);
  law.offset = offset + (random.uniform() < kByEye ? kWideOffsetSigma : kOffsetSigma) * random.normal();
}

void wander(HeadingLaw& law, double duration, RandomStream& random) {
  if (random.uniform() < duration / kMemory) law.noise = draw_noise(random);
  if (random.uniform() < duration / kMemory) law.believed = random.uniform() < kBelieved;
  law.offset += kOffsetWalk * std::sqrt(duration) * random.normal();
}

}  // namespace multipath_localization::multipath
