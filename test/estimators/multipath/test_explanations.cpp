#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "estimators/multipath/explanations.hpp"

namespace multipath_localization::multipath {
namespace {

/// At the origin and sure of it, under open sky, with a receiver of 0.3 m.
Hypothesis settled() {
  Hypothesis h;
  h.level = 0.3;
  h.law.log_slow = std::log(0.5);
  h.law.log_slow_time = std::log(20.0);
  h.covariance.diagonal() << 0.01, 0.01, 1e-4, 1e-6, 1e-8, 1e-6, 0.0, 1e-8, 0.01, 0.01, 0.0, 0.0;
  return h;
}

Sighting sighting_at(const Eigen::Vector2d& position) {
  Sighting z;
  z.fix.position = position;
  z.fix.covariance = 0.09 * Eigen::Matrix2d::Identity();
  z.duration = 1.0;
  z.level = 0.3;
  z.usual_speed = 2.0;
  z.shadow_entry_rate = 1.0 / 60.0;
  return z;
}

/// Share of 400 draws for which it holds afterwards.
template <class Property>
double share(const Hypothesis& before, const Sighting& z, Property property) {
  int count = 0;
  for (std::uint32_t i = 0; i < 400; ++i) {
    RandomStream random(11, 1, i);
    Hypothesis h = before;
    const Evidence evidence = explain(h, z, random);
    count += property(h, evidence) ? 1 : 0;
  }
  return count / 400.0;
}

double log_stay(Hypothesis h, const Sighting& z) {
  RandomStream random(13, 1, 1);
  return explain(h, z, random).log_stay;
}

bool in_shadow(const Hypothesis& h, const Evidence&) { return h.in_shadow; }
bool event(const Hypothesis&, const Evidence& evidence) { return evidence.event; }

TEST(Explanations, AFixWhereItIsExpectedIsNoEvent) {
  EXPECT_LT(share(settled(), sighting_at({0.1, -0.2}), event), 0.06);
}

TEST(Explanations, AFixFarAwayIsAnOutlierOrAShadow) {
  const Sighting far = sighting_at({10.0, 0.0});
  EXPECT_GT(share(settled(), far, event), 0.99);
  EXPECT_GT(share(settled(), far, in_shadow), 0.1);
  for (std::uint32_t i = 0; i < 50; ++i) {
    RandomStream random(12, 1, i);
    Hypothesis h = settled();
    explain(h, far, random);
    if (!h.in_shadow) continue;
    EXPECT_LT(h.pose().position().norm(), 1.0) << "the bias takes it up";
  }
}

TEST(Explanations, AWorseDeclaredSigmaMakesAShadowLikelier) {
  const Eigen::Vector2d off(10.0, 0.0);
  Sighting worse = sighting_at(off);
  worse.fix.covariance *= 16.0;
  worse.level = 1.2;
  EXPECT_GT(share(settled(), worse, in_shadow), 1.2 * share(settled(), sighting_at(off), in_shadow));
}

Hypothesis in_a_shadow_of(const Eigen::Vector2d& bias) {
  Hypothesis h = settled();
  h.in_shadow = true;
  h.shadow_law = {8.0, 30.0, 0.3, 4.0, 0.08, 1 / 30.0};
  h.mean.tail<2>() = bias;
  h.covariance.bottomRightCorner<2, 2>() = 0.04 * Eigen::Matrix2d::Identity();
  return h;
}

TEST(Explanations, AShadowEndsWhenTheFixesComeBack) {
  const Hypothesis shaded = in_a_shadow_of({8.0, 0.0});
  EXPECT_GT(share(shaded, sighting_at({8.1, 0.2}), in_shadow), 0.9);
  EXPECT_LT(share(shaded, sighting_at({0.1, 0.1}), in_shadow), 0.2);
}

TEST(Explanations, AReceiverThatHoldsOnToItsErrorIsNotBelievedSooner) {
  Hypothesis held = in_a_shadow_of({8.0, 0.0});
  held.shadow_law = {8.0, 1e4, 0.0, 8.0, 1 / 300.0, 1 / 300.0};
  const Sighting same = sighting_at({8.0, 0.0});
  EXPECT_NEAR(log_stay(held, same), -2.0 / 300.0, 1e-3);
  EXPECT_LT(log_stay(in_a_shadow_of({8.0, 0.0}), same), 10.0 * log_stay(held, same));
}

TEST(Explanations, OdometryMayBeWrongAfterAGapOfTheFixes) {
  const auto displaced = [](const Hypothesis& h, const Evidence&) { return h.mean.x() > 40.0; };
  Sighting far = sighting_at({50.0, 0.0});
  far.duration = 60.0;
  const double before = share(settled(), far, displaced);
  far.after_gap = true;
  EXPECT_GT(share(settled(), far, displaced), before + 0.02);
}

TEST(Explanations, AnotherReflectionHasNothingOfTheOneBefore) {
  Hypothesis shaded = in_a_shadow_of({30.0, 0.0});
  const Sighting back = sighting_at({0.0, 5.0});
  int changes = 0;
  double spread = 0.0;
  for (std::uint32_t i = 0; i < 400; ++i) {
    RandomStream random(15, 1, i);
    Hypothesis h = shaded;
    explain(h, back, random);
    if (!h.in_shadow || h.shadow_law.size == shaded.shadow_law.size) continue;
    ++changes;
    spread += (h.mean.tail<2>() - Eigen::Vector2d(0.0, 5.0)).norm();
  }
  ASSERT_GT(changes, 5);
  EXPECT_LT(spread / changes, 3.0) << "near the new bias, drawn to none, not to the old one";
}

TEST(Explanations, AShadowTakesOnASmallerDeclaredSigmaAndNoLarger) {
  const Hypothesis shaded = in_a_shadow_of({8.0, 0.0});
  for (const double level : {0.02, 0.3, 5.0}) {
    Sighting z = sighting_at({8.0, 0.0});
    z.level = level;
    z.fix.covariance = level * level * Eigen::Matrix2d::Identity();
    RandomStream random(16, 1, 1);
    Hypothesis h = shaded;
    explain(h, z, random);
    ASSERT_TRUE(h.in_shadow);
    EXPECT_EQ(h.level, std::min(level, shaded.level));
  }
}

TEST(Explanations, StandingGainsNoCertainty) {
  Hypothesis h = in_a_shadow_of({6.0, 0.0});
  Sighting z = sighting_at({6.0, 0.0});
  z.standing = true;
  const double before = h.covariance(kX, kX);
  RandomStream random(13, 1, 1);
  for (int i = 0; i < 300; ++i) {
    Hypothesis next = h;
    if (!explain(next, z, random).event) h = next;
  }
  EXPECT_GT(h.covariance(kX, kX), 0.5 * before);
  EXPECT_LT(h.pose().position().norm(), 0.5);
}

TEST(Explanations, WheelsFailOnlyWhereTheyAreSuspected) {
  const auto failing = [](const Hypothesis& h, const Evidence&) { return h.wheel_fault.any(); };
  Sighting z = sighting_at({2.0, 0.0});
  EXPECT_EQ(share(settled(), z, failing), 0.0);
  z.fault_probability = 0.5;
  EXPECT_GT(share(settled(), z, failing), 0.3);
}

TEST(Explanations, AnythingGivesNumbers) {
  for (const double distance : {0.0, 1e3, 1e8}) {
    for (std::uint32_t i = 0; i < 100; ++i) {
      RandomStream random(14, 1, i);
      Hypothesis h = settled();
      Sighting z = sighting_at({distance, -distance});
      z.duration = i % 2 == 0 ? 1e-3 : 1e4;
      z.fault_probability = 0.5;
      const Evidence evidence = explain(h, z, random);
      EXPECT_TRUE(std::isfinite(evidence.log_likelihood));
      EXPECT_TRUE(h.mean.allFinite());
      EXPECT_TRUE(h.covariance.allFinite());
    }
  }
}

}  // namespace
}  // namespace multipath_localization::multipath
