#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/random.hpp"
#include "simulated_drive.hpp"
#include "started_mixture_filter.hpp"

namespace multipath_localization {
namespace {

/// A robot whose satellites each keep an error of their own, that has driven for a minute and stands.
class Parked : public Started {
 public:
  explicit Parked(std::uint64_t seed) : Started(seed) {
    RandomStream random(seed, 0, 7);
    for (std::size_t i = 0; i < drive.sky.size(); ++i) drive.biases.push_back(2.5 * random.normal());
    drive.run(filter, 60.0);
    drive.speed = 0.0;
    drive.steps_per_epoch = 10;
    drive.run(filter, 60.0);
  }
};

TEST(PseudorangeMixtureFilter, StandingForAQuarterOfAnHourMakesNothingWorse) {
  double after_a_minute = 0.0;
  double after_fifteen = 0.0;
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 60; seed < 63; ++seed) {
    Parked run(seed);
    after_a_minute += run.drive.error(run.filter);
    double most = 0.0;
    run.drive.run(run.filter, 840.0, [&] {
      const double squared = nees(run.filter.estimate(), run.drive.truth);
      sum += squared;
      ++count;
      most = std::max(most, squared);
    });
    EXPECT_LT(most, 9.0) << "outside 3 sigma";
    after_fifteen += run.drive.error(run.filter);
  }
  EXPECT_LT(after_fifteen, 1.2 * after_a_minute);
  EXPECT_LT(sum / count, 4.0);
}

TEST(PseudorangeMixtureFilter, StandingAmongReflectionsGainsLittle) {
  Parked run(70);
  run.drive.delayed = {1, 2, 9};
  run.drive.run(run.filter, 60.0);
  const double sigma = std::sqrt(run.filter.estimate().covariance(0, 0));
  run.drive.run(run.filter, 840.0);
  EXPECT_GT(std::sqrt(run.filter.estimate().covariance(0, 0)), 0.7 * sigma);
  EXPECT_LT(run.drive.error(run.filter), 5.0);
}

}  // namespace
}  // namespace multipath_localization
