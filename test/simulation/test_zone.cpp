#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "simulation/zone.hpp"

namespace multipath_localization {
namespace {

ZoneParameters walking() {
  ZoneParameters parameters;
  parameters.law = ZoneLaw::kRandomWalk;
  parameters.bias_sigma = 2.0;
  parameters.bias_time_constant = 5.0;
  parameters.bias_cap = 1e3;
  return parameters;
}

TEST(Zone, BiasIsAsLongAsTheShadowIsDeepUpToTheCap) {  // Eq. (44) of [NIS]
  const Zone zone(ZoneParameters{}, 1, 0);             // x < 0, direction west
  for (double x = -20.0; x <= 5.0; x += 0.5) {
    const double length = x < 0.0 ? std::min(-x, 5.0) : 0.0;
    EXPECT_NEAR((zone.bias({x, 3.0}) - Eigen::Vector2d(-length, 0.0)).norm(), 0.0, 1e-9) << x;
  }
}

TEST(Zone, HalfPlaneLiesWhereInwardPoints) {
  ZoneParameters parameters;
  parameters.edge_x = 1.0;
  parameters.edge_y = 2.0;
  parameters.inward = 0.5 * kPi;
  const Zone zone(parameters, 1, 0);
  EXPECT_NEAR(zone.depth({40.0, 5.0}), 3.0, 1e-12);
  EXPECT_NEAR(zone.depth({-7.0, 0.0}), -2.0, 1e-12);
}

TEST(Zone, PolygonHasNoBiasOutside) {
  ZoneParameters parameters = walking();
  parameters.shape = ZoneShape::kPolygon;
  parameters.corners = {0, 0, 10, 0, 10, 10, 0, 10};
  const Zone zone(parameters, 3, 0);
  EXPECT_GT(zone.bias({5.0, 5.0}).norm(), 0.0);
  EXPECT_EQ(zone.bias({11.0, 5.0}).norm(), 0.0);
  parameters.corners = {0, 0, 10, 0};
  EXPECT_THROW(Zone(parameters, 3, 0), ParameterError);
}

TEST(Zone, DirectionTurnsAtItsRate) {
  ZoneParameters parameters;
  parameters.direction = 0.0;
  parameters.direction_rate = 0.1;
  Zone zone(parameters, 1, 0);
  for (int i = 0; i < 1000; ++i) zone.step(0.01);
  const Eigen::Vector2d bias = zone.bias({-2.0, 0.0});
  EXPECT_NEAR(bias.norm(), 2.0, 1e-12);
  EXPECT_NEAR(std::atan2(bias.y(), bias.x()), 1.0, 1e-9);
}

TEST(Zone, DirectionWandersWithTheRootOfTime) {
  ZoneParameters parameters;
  parameters.direction = 0.0;
  parameters.direction_walk = 0.05;
  double squares = 0.0;
  const int seeds = 400;
  for (int seed = 0; seed < seeds; ++seed) {
    Zone zone(parameters, static_cast<std::uint64_t>(seed), 0);
    for (int i = 0; i < 100; ++i) zone.step(0.04);  // 4 s
    const Eigen::Vector2d bias = zone.bias({-2.0, 0.0});
    squares += std::pow(std::atan2(bias.y(), bias.x()), 2);
  }
  EXPECT_NEAR(std::sqrt(squares / seeds), 0.1, 0.015);  // 4 sigma of a standard deviation over 400 draws
}

TEST(Zone, WalkHasItsSigmaAndTimeConstant) {
  double variance = 0.0;
  double covariance = 0.0;
  const int seeds = 500;
  for (int seed = 0; seed < seeds; ++seed) {
    Zone zone(walking(), static_cast<std::uint64_t>(seed), 0);
    const Eigen::Vector2d before = zone.bias({-1.0, 0.0});
    for (int i = 0; i < 50; ++i) zone.step(0.1);  // one time constant
    const Eigen::Vector2d after = zone.bias({-1.0, 0.0});
    variance += 0.5 * after.squaredNorm() / seeds;
    covariance += 0.5 * before.dot(after) / seeds;
  }
  EXPECT_NEAR(variance, 4.0, 0.8);  // over 1000 draws, 4.5 sigma
  EXPECT_NEAR(covariance / 4.0, std::exp(-1.0), 0.15);
}

TEST(Zone, WalkStaysWithinTheCap) {
  ZoneParameters parameters = walking();
  parameters.bias_cap = 1.5;
  Zone zone(parameters, 5, 0);
  double longest = 0.0;
  for (int i = 0; i < 2000; ++i) {
    zone.step(0.1);
    longest = std::max(longest, zone.bias({-1.0, 0.0}).norm());
  }
  EXPECT_NEAR(longest, 1.5, 1e-12);
}

TEST(Zone, EachIndexHasABiasOfItsOwn) {
  const Zone first(walking(), 1, 0);
  const Zone second(walking(), 1, 1);
  EXPECT_GT((first.bias({-1.0, 0.0}) - second.bias({-1.0, 0.0})).norm(), 0.01);
}

}  // namespace
}  // namespace multipath_localization
