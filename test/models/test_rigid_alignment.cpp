#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/rigid_alignment.hpp"

namespace multipath_localization {
namespace {

constexpr double kLength = 12.0;
constexpr double kStep = 0.1;

/// Drives and tells the alignment a fix at each step, made by `fix_of(truth, step)`.
template <class FixOf>
Pose2 drive(RigidAlignment& alignment, Pose2 truth, double distance, double speed, double yaw_rate,
            FixOf fix_of) {
  const auto steps = std::lround(distance / (std::abs(speed) * kStep));
  for (long i = 1; i <= steps; ++i) {
    const OdometryIncrement u{kStep * static_cast<double>(i), kStep, speed, yaw_rate};
    truth = truth * displacement(u);
    alignment.add(u);
    alignment.add(Eigen::Vector2d(fix_of(truth, static_cast<std::uint32_t>(i))));
  }
  return truth;
}

Eigen::Vector2d exact(const Pose2& truth, std::uint32_t /*step*/) { return truth.position(); }

TEST(RigidAlignment, FindsTheHeadingOfAnExactPathForwardAndInReverse) {
  for (const double speed : {2.0, -1.5}) {
    for (const double yaw_rate : {0.0, 0.2, -0.6}) {
      for (const double start : {-3.0, 0.0, 1.2}) {
        RigidAlignment alignment(kLength, 0.1, 0.01);
        const Pose2 truth = drive(alignment, {100.0, -50.0, start}, 15.0, speed, yaw_rate, exact);
        const auto heading = alignment.heading();
        ASSERT_TRUE(heading) << speed << " " << yaw_rate << " " << start;
        EXPECT_NEAR(angle_difference(heading->yaw, truth.yaw), 0.0, 1e-9);
        EXPECT_GE(heading->variance, 0.01);
        EXPECT_LT(heading->variance, 0.02);
      }
    }
  }
}

TEST(RigidAlignment, SaysNothingBeforeEnoughDistance) {
  RigidAlignment alignment(kLength, 0.1, 0.01);
  EXPECT_FALSE(alignment.heading());
  drive(alignment, {}, 0.75 * kLength, 2.0, 0.1, exact);
  EXPECT_FALSE(alignment.heading());
}

TEST(RigidAlignment, SaysNothingToARobotThatStands) {
  RigidAlignment alignment(kLength, 0.1, 0.01);
  for (std::uint32_t i = 0; i < 500; ++i) {
    RandomStream random(1, i, 0);
    alignment.add(OdometryIncrement{kStep * i, kStep, 0.0, 0.0});
    alignment.add(Eigen::Vector2d(random.normal(), random.normal()));
  }
  EXPECT_FALSE(alignment.heading());
}

TEST(RigidAlignment, SaysNothingWhenTheShapesContradict) {
  RigidAlignment there_and_back(kLength, 0.1, 0.01);
  drive(there_and_back, {}, kLength, 2.0, 0.0, [](const Pose2& truth, std::uint32_t) {
    return Eigen::Vector2d(std::min(truth.x, kLength - truth.x), 0.0);
  });
  EXPECT_FALSE(there_and_back.heading());

  RigidAlignment scattered(kLength, 0.1, 0.01);
  drive(scattered, {}, kLength, 2.0, 0.0, [](const Pose2& /*truth*/, std::uint32_t step) {
    RandomStream random(2, step, 0);
    return Eigen::Vector2d(10.0 * random.normal(), 10.0 * random.normal());
  });
  EXPECT_FALSE(scattered.heading());
}

TEST(RigidAlignment, ForgetsWhatLiesFurtherBackThanItsLength) {
  RigidAlignment alignment(kLength, 0.1, 0.01);
  const Pose2 half_way = drive(
      alignment, {}, 30.0, 2.0, 0.1,
      [](const Pose2& truth, std::uint32_t) -> Eigen::Vector2d { return rotation(1.0) * truth.position(); });
  const Pose2 truth = drive(alignment, half_way, kLength + 1.0, 2.0, 0.1, exact);
  const auto heading = alignment.heading();
  ASSERT_TRUE(heading);
  EXPECT_NEAR(angle_difference(heading->yaw, truth.yaw), 0.0, 1e-9);
  alignment.clear();
  EXPECT_FALSE(alignment.heading());
}

TEST(RigidAlignment, VarianceBoundsTheErrorOverSeededNoise) {
  constexpr int kSeeds = 200;
  constexpr double kSigma = 0.5;
  double normalised_square = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    RigidAlignment alignment(kLength, 0.1, 0.0);
    const Pose2 truth =
        drive(alignment, {5.0, 5.0, 2.0}, 13.0, 1.0, 0.1, [&](const Pose2& pose, std::uint32_t step) {
          RandomStream random(seed, step, 0);
          const double x = random.normal();
          return Eigen::Vector2d(pose.position() + kSigma * Eigen::Vector2d(x, random.normal()));
        });
    const auto heading = alignment.heading();
    ASSERT_TRUE(heading);
    const double error = angle_difference(heading->yaw, truth.yaw);
    normalised_square += error * error / heading->variance / kSeeds;
  }
  // The variance stated is twice that of independent noise: the mean square lies about 1/2.
  const double band = 3.3 * 0.5 * std::sqrt(2.0 / kSeeds);
  EXPECT_NEAR(normalised_square, 0.5, band);
}

}  // namespace
}  // namespace multipath_localization
