#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "default_localizer.hpp"
#include "estimators/multipath/multipath_particle_filter.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

TEST(MultipathParticleFilter, SameSeedSameBytesOtherSeedDiffers) {
  const auto last = [](std::uint64_t seed) {
    SimulatedDrive robot(1);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 20.0);
    return numbers_of(localizer.estimate());
  };
  EXPECT_EQ(last(7), last(7));
  EXPECT_NE(last(7), last(8));
}

TEST(MultipathParticleFilter, StartingAgainForgetsEverything) {
  SimulatedDrive fresh(1);
  Localizer localizer = default_localizer(3);
  fresh.run(localizer, 20.0);
  const auto expected = numbers_of(localizer.estimate());
  localizer.start(std::nullopt);
  EXPECT_FALSE(localizer.estimate().valid);
  SimulatedDrive again(1);
  again.run(localizer, 20.0);
  EXPECT_EQ(numbers_of(localizer.estimate()), expected);
}

TEST(MultipathParticleFilter, UnusableFixesAreRefusedWithTheReasonAndChangeNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MultipathParticleFilter filter({}, 1);
  MultipathParticleFilter untouched({}, 1);
  Reason frozen = Reason::kUnused;
  Reason not_finite = Reason::kUnused;
  Reason negative = Reason::kUnused;
  for (int i = 1; i <= 100; ++i) {
    const OdometryIncrement u{0.2 * i, 0.2, 1.5, 0.1};
    filter.predict(u);
    untouched.predict(u);
    RandomStream random(4, static_cast<std::uint32_t>(i), 0);
    GnssFix fix;
    fix.stamp = u.stamp;
    fix.position = {0.3 * i + 0.3 * random.normal(), 0.3 * random.normal()};
    GnssFix bad = fix;
    bad.position.x() = nan;
    not_finite = filter.update(bad).reason;
    bad = fix;
    bad.covariance(1, 1) = -1.0;
    negative = filter.update(bad).reason;
    EXPECT_TRUE(filter.update(fix).accepted());
    EXPECT_TRUE(untouched.update(fix).accepted());
    frozen = filter.update(fix).reason;
    filter.predict({u.stamp, 0.1, nan, 0.0});
    filter.predict({u.stamp, -0.1, 1.0, 0.0});
  }
  EXPECT_EQ(not_finite, Reason::kNotFinite);
  EXPECT_EQ(negative, Reason::kInvalidCovariance);
  EXPECT_EQ(frozen, Reason::kFrozen);
  EXPECT_EQ(numbers_of(filter.estimate()), numbers_of(untouched.estimate()));
}

TEST(MultipathParticleFilter, FixesTenThousandKilometresAwayGiveNumbersStill) {
  SimulatedDrive robot(5);
  Localizer localizer = default_localizer(1);
  robot.run(localizer, 40.0);
  robot.bias = [](double time) { return Eigen::Vector2d(time > 42.0 ? 0.0 : 1e7, 0.0); };
  robot.run(localizer, 20.0, [&] { ASSERT_TRUE(all_finite(localizer.estimate())); });
  for (const Hypothesis& hypothesis : localizer.hypotheses()) {
    EXPECT_TRUE(hypothesis.pose.finite());
    EXPECT_TRUE(std::isfinite(hypothesis.weight));
  }
}

TEST(MultipathParticleFilter, IsTunedWithoutMovingItsPose) {
  SimulatedDrive robot(6);
  Localizer localizer = default_localizer(6);
  robot.run(localizer, 60.0);
  ASSERT_TRUE(localizer.estimate().aligned);
  for (const std::size_t particles : {100U, 900U}) {
    const std::vector<double> before = numbers_of(localizer.estimate());
    load_fields(
        YAML::Load("{particles: " + std::to_string(particles) + ", odometry: {distance: 0.02}}"),
        [&](ParameterVisitor& field) { localizer.tune_estimator(field); }, "");
    EXPECT_EQ(numbers_of(localizer.estimate()), before);
    robot.run(localizer, 20.0);
    EXPECT_EQ(localizer.hypotheses().size(), particles);
    EXPECT_TRUE(localizer.estimate().aligned);
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 1.0);
  }
  load_fields(
      YAML::Load("{position_sigma_floor: 7}"),
      [&](ParameterVisitor& field) { localizer.tune_estimator(field); }, "");
  EXPECT_GT(localizer.estimate().covariance(0, 0), 49.0);
}

}  // namespace
}  // namespace multipath_localization
