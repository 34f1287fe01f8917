#include <gtest/gtest.h>

#include <cmath>

#include "estimators/multipath/error_laws.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(ErrorLaw, SpansReceiversFromOptimistsToPessimists) {
  int optimists = 0;
  int pessimists = 0;
  RandomStream random(1, 1, 1);
  for (int i = 0; i < 4000; ++i) {
    const ErrorLaw law = draw_error_law(random);
    optimists += law.slow_sigma() > 5.0 ? 1 : 0;
    pessimists += law.slow_sigma() < 0.5 ? 1 : 0;
    EXPECT_GE(law.slow_sigma(), 0.3 - 1e-12);
    EXPECT_GE(law.slow_time(), 2.0 - 1e-9);
    EXPECT_LE(law.slow_time(), 150.0 + 1e-9);
    EXPECT_GE(law.open_sigma(), law.slow_sigma() - 1e-12);
  }
  EXPECT_GT(optimists, 200);
  EXPECT_GT(pessimists, 600);
}

TEST(ErrorLaw, WandersWithinItsPrior) {
  double mean = 0.0;
  double variance = 0.0;
  constexpr int kLaws = 2000;
  for (std::uint32_t i = 0; i < kLaws; ++i) {
    RandomStream random(2, 1, i);
    ErrorLaw law = draw_error_law(random);
    for (int k = 0; k < 100; ++k) wander_odometry(law, 30.0, random);
    mean += law.log_turn / kLaws;
    variance += square(law.log_turn) / kLaws;
  }
  EXPECT_NEAR(mean, 0.0, 0.08);
  EXPECT_NEAR(std::sqrt(variance), 0.8, 0.05);
}

TEST(ErrorLaw, OfFixesAndOfOdometryWanderApart) {
  RandomStream random(3, 1, 1);
  const ErrorLaw before = draw_error_law(random);
  ErrorLaw law = before;
  wander_fixes(law, 10.0, random);
  EXPECT_EQ(law.log_way, before.log_way);
  EXPECT_EQ(law.log_turn, before.log_turn);
  EXPECT_EQ(law.log_walk, before.log_walk);
  EXPECT_NE(law.log_white, before.log_white);
  law = before;
  wander_odometry(law, 10.0, random);
  EXPECT_EQ(law.log_white, before.log_white);
  EXPECT_NE(law.log_way, before.log_way);
}

TEST(ShadowLaw, StandsOutOfAnOpenSky) {
  RandomStream random(4, 1, 1);
  for (int i = 0; i < 1000; ++i) {
    const ShadowLaw fine = draw_shadow_law(0.02, 40.0, random);
    EXPECT_GE(fine.size, 1.5 - 1e-9);
    EXPECT_LE(fine.size, 40.0 + 1e-9);
    EXPECT_LE(fine.first, fine.size);
    EXPECT_LT(fine.noise, fine.size);
    EXPECT_GE(draw_shadow_law(30.0, 40.0, random).size, 90.0 - 1e-9);
  }
}

TEST(ShadowLaw, AfterAGapBeginsInFullAndMayBeHeldForMinutes) {
  RandomStream random(6, 1, 1);
  int held = 0;
  for (int i = 0; i < 2000; ++i) {
    const ShadowLaw law = draw_reacquired_law(0.3, 40.0, random);
    EXPECT_EQ(law.first, law.size);
    if (law.leave_rate > 1.0 / 60.0 || law.noise > 0.0) continue;
    ++held;
    EXPECT_GE(law.leave_rate, 1.0 / 600.0 - 1e-12);
    EXPECT_EQ(law.change_rate, law.leave_rate);
  }
  EXPECT_NEAR(held, 600, 90);
}

TEST(LogUniform, HasAsManyOfEachDecade) {
  RandomStream random(5, 1, 1);
  int low = 0;
  for (int i = 0; i < 4000; ++i) low += log_uniform(0.1, 10.0, random) < 1.0 ? 1 : 0;
  EXPECT_NEAR(low, 2000, 130);
}

}  // namespace
}  // namespace multipath_localization::multipath
