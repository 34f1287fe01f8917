#include <gtest/gtest.h>

#include "multipath_localization/core/measurements.hpp"
#include "pose_near.hpp"

namespace multipath_localization {
namespace {

const std::vector<std::pair<double, double>> kSpeedsAndYawRates = {
    {1.5, 0.0}, {1.5, 0.4}, {-0.7, 0.4}, {10.0, -2.0}, {0.0, 1.0}, {2.0, 1e-9}, {2.0, -4e-4}};

Pose2 by_euler(const OdometryIncrement& u, int steps) {
  Pose2 pose;
  const double dt = u.duration / steps;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d step = rotation(pose.yaw) * Eigen::Vector2d(u.speed * dt, u.lateral_speed * dt);
    pose.x += step.x();
    pose.y += step.y();
    pose.yaw += u.yaw_rate * dt;
  }
  return pose;
}

TEST(Displacement, IsWhatFineEulerIntegrationTendsTo) {
  for (const auto& [speed, yaw_rate] : kSpeedsAndYawRates) {
    const OdometryIncrement u{0.0, 1.3, speed, yaw_rate};
    EXPECT_TRUE(PoseNear(displacement(u), by_euler(u, 100000), 3e-4)) << speed << " " << yaw_rate;
  }
}

TEST(Displacement, GoesSidewaysWithTheLateralSpeed) {
  EXPECT_TRUE(PoseNear(displacement({0.0, 2.0, 0.0, 0.0, 0.5}), Pose2{0.0, 1.0, 0.0}, 1e-12));
  const OdometryIncrement u{0.0, 1.3, 0.4, 0.7, -0.9};
  EXPECT_TRUE(PoseNear(displacement(u), by_euler(u, 100000), 3e-4));
}

TEST(GroundSpeed, IsThatOfAllDirections) { EXPECT_DOUBLE_EQ(ground_speed({0.0, 1.0, -3.0, 0.2, 4.0}), 5.0); }

TEST(Displacement, IsEquation3OfNishidaWhereThatIsDefined) {
  for (const auto& [v, w] : kSpeedsAndYawRates) {
    if (std::abs(w) < 1e-3) continue;
    const double dt = 0.8;
    const Pose2 expected{v / w * std::sin(w * dt), v / w * (1.0 - std::cos(w * dt)), wrap_angle(w * dt)};
    EXPECT_TRUE(PoseNear(displacement({0.0, dt, v, w}), expected, 1e-12)) << v << " " << w;
  }
}

TEST(Displacement, HasNoStepAtZeroYawRateNorWhereItsSeriesEnds) {
  const double dt = 0.1;
  Pose2 last = displacement({0.0, dt, 20.0, -0.01});
  for (double yaw_rate = -0.01; yaw_rate < 0.01; yaw_rate += 1e-6) {
    const Pose2 next = displacement({0.0, dt, 20.0, yaw_rate});
    ASSERT_TRUE(PoseNear(next, last, 2e-7)) << yaw_rate;
    last = next;
  }
}

TEST(Displacement, OfPartsComposesToThatOfTheWhole) {
  for (const auto& [speed, yaw_rate] : kSpeedsAndYawRates) {
    const Pose2 whole = displacement({0.0, 1.0, speed, yaw_rate});
    const Pose2 parts = displacement({0.0, 0.3, speed, yaw_rate}) * displacement({0.0, 0.7, speed, yaw_rate});
    EXPECT_TRUE(PoseNear(parts, whole, 1e-12));
  }
}

TEST(Displacement, OfAFullTurnEndsWhereItBegan) {
  EXPECT_TRUE(PoseNear(displacement({0.0, 2.0 * kPi, 3.0, 1.0}), Pose2{}, 1e-12));
}

TEST(Joined, KeepsTheWayTheTurnAndTheTime) {
  const OdometryIncrement first{1.2, 0.2, 1.5, -0.4, 0.3};
  const OdometryIncrement second{1.3, 0.1, -0.6, 0.5, -0.9};
  const OdometryIncrement both = joined(first, second);
  EXPECT_EQ(both.stamp, 1.3);
  EXPECT_NEAR(both.duration, 0.3, 1e-15);
  EXPECT_NEAR(both.speed * both.duration, 0.3 - 0.06, 1e-15);
  EXPECT_NEAR(both.yaw_rate * both.duration, -0.08 + 0.05, 1e-15);
  EXPECT_NEAR(both.lateral_speed * both.duration, 0.06 - 0.09, 1e-15);
}

TEST(Joined, OfMillisecondsEndsWhereTheyEnd) {
  Pose2 apart;
  std::optional<OdometryIncrement> together;
  for (int i = 1; i <= 100; ++i) {
    const OdometryIncrement u{1e-3 * i, 1e-3, 1.0 + 1e-3 * i, 0.5 + 2e-3 * i};
    apart = apart * displacement(u);
    together = together ? joined(*together, u) : u;
  }
  EXPECT_TRUE(PoseNear(displacement(*together), apart, 3e-4));
}

TEST(Measurement, KnowsItsStamp) {
  GnssFix fix;
  fix.stamp = 12.5;
  EXPECT_EQ(stamp_of(fix), 12.5);
  DualAntennaFix fixes;
  fixes.stamp = 13.5;
  EXPECT_EQ(stamp_of(fixes), 13.5);
  PseudorangeEpoch epoch;
  epoch.stamp = 14.5;
  EXPECT_EQ(stamp_of(epoch), 14.5);
}

TEST(Measurement, CarriedBackHasItsAntennasWhereTheyWere) {
  const Pose2 then{-2.0, 0.5, -kPi / 2.0};
  const Eigen::Vector2d ahead(0.3, 0.0);
  const Eigen::Vector2d carried(-2.0, 0.2);
  const BaseThen base_then = [&](double) { return then; };
  GnssFix fix;
  fix.antenna_in_base = ahead;
  const auto carried_fix = std::get<GnssFix>(carried_back(fix, base_then).value());
  EXPECT_LT((carried_fix.antenna_in_base - carried).norm(), 1e-12);
  PseudorangeEpoch epoch;
  epoch.antenna_in_base = ahead;
  const auto carried_epoch = std::get<PseudorangeEpoch>(carried_back(epoch, base_then).value());
  EXPECT_LT((carried_epoch.antenna_in_base - carried).norm(), 1e-12);
}

TEST(Measurement, CarriedBackKnowsHowFarAHeadingHasTurned) {
  const BaseThen base_then = [](double) { return Pose2{-2.0, 0.5, -0.4}; };
  const auto carried = std::get<Heading>(carried_back(Heading{1.0, 3.0, 0.01}, base_then).value());
  EXPECT_EQ(carried.yaw, 3.0);
  EXPECT_NEAR(carried.turn, 0.4, 1e-12);
}

TEST(Measurement, CarriedBackEachAntennaOfAPairByItsOwnStamp) {
  DualAntennaFix fixes;
  fixes.left.stamp = 3.0;
  fixes.left.antenna_in_base = {0.0, 0.15};
  fixes.stamp = fixes.right.stamp = 3.04;
  fixes.right.antenna_in_base = {0.0, -0.15};
  const BaseThen driving = [](double stamp) { return Pose2{stamp - 3.1, 0.0, 0.0}; };  // 1 m/s, now 3.1 s
  const auto back = std::get<DualAntennaFix>(carried_back(fixes, driving).value());
  EXPECT_LT((back.left.antenna_in_base - Eigen::Vector2d(-0.10, 0.15)).norm(), 1e-12);
  EXPECT_LT((back.right.antenna_in_base - Eigen::Vector2d(-0.06, -0.15)).norm(), 1e-12);
  const BaseThen forgetful = [](double stamp) {
    return stamp < 3.02 ? std::nullopt : std::optional<Pose2>(Pose2{});
  };
  EXPECT_FALSE(carried_back(fixes, forgetful));
}

TEST(SatelliteObservation, HasDopplerOnlyWithRangeRateAndVelocity) {
  SatelliteObservation observation;
  EXPECT_FALSE(observation.has_doppler());
  observation.range_rate = 10.0;
  EXPECT_FALSE(observation.has_doppler());
  observation.velocity = {1.0, 2.0, 3.0};
  EXPECT_TRUE(observation.has_doppler());
}

}  // namespace
}  // namespace multipath_localization
