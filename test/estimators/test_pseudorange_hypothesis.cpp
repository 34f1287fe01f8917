#include <gtest/gtest.h>

#include "multipath_localization/estimators/pseudorange_hypothesis.hpp"
#include "satellite_drive.hpp"

namespace multipath_localization {
namespace {

using State = PseudorangeBelief;

const RangeErrorParameters kErrors;

/// A hypothesis that knows everything about a drive, to these standard deviations.
PseudorangeHypothesis knowing(const SatelliteDrive& drive, double position_sigma, double yaw_sigma) {
  PseudorangeHypothesis hypothesis;
  auto& x = hypothesis.belief.mean;
  auto& P = hypothesis.belief.covariance;
  x << drive.truth.x, drive.truth.y, drive.truth.yaw, drive.errors.speed_scale, drive.errors.gyro_bias,
      drive.up, drive.clock, drive.drift;
  P.diagonal() << position_sigma * position_sigma, position_sigma * position_sigma, yaw_sigma * yaw_sigma,
      1e-6, 1e-8, 4.0, 4.0, 0.01;
  for (std::size_t i = 0; i <= drive.sky.size(); ++i) hypothesis.append(0.01);
  x(State::state_of(0)) = drive.offset;
  return hypothesis;
}

/// The drive's epoch; slot 0 is the offset, slot i + 1 satellite i.
SlottedEpoch slotted(const SatelliteDrive& drive, double speed) {
  const PseudorangeEpoch epoch = drive.epoch();
  SlottedEpoch result;
  result.antenna_in_base = epoch.antenna_in_base;
  result.duration = result.information = 1.0;
  result.speed = speed;
  for (std::size_t i = 0; i < epoch.observations.size(); ++i) {
    const SatelliteObservation& observation = epoch.observations[i];
    const bool gps = observation.constellation == Constellation::kGps;
    result.satellites.push_back({observation, static_cast<int>(i) + 1, gps ? -1 : 0,
                                 line_of_sight_prior(observation, kErrors.mixture),
                                 mean_nlos_delay(observation.elevation, kErrors.mixture)});
  }
  return result;
}

double position_error(const PseudorangeHypothesis& hypothesis, const SatelliteDrive& drive) {
  return (hypothesis.belief.pose().position() - drive.truth.position()).norm();
}

TEST(PseudorangeHypothesis, ComesToTheTruth) {
  SatelliteDrive drive(1);
  drive.range_sigma = 0.0;
  PseudorangeHypothesis hypothesis = knowing(drive, 10.0, 0.01);
  hypothesis.belief.mean(kX) += 8.0;
  hypothesis.belief.mean(kY) -= 6.0;
  for (int i = 0; i < 5; ++i) hypothesis.update(slotted(drive, 0.0), kErrors);
  EXPECT_LT(position_error(hypothesis, drive), 0.3);
  EXPECT_GT(hypothesis.line_of_sight_share, 0.9);
}

TEST(PseudorangeHypothesis, IsNotMovedByLateSignals) {
  SatelliteDrive drive(2);
  drive.range_sigma = 0.0;
  drive.delayed = {0, 1, 2, 3, 8};
  PseudorangeHypothesis hypothesis = knowing(drive, 5.0, 0.01);
  for (int i = 0; i < 5; ++i) hypothesis.update(slotted(drive, 0.0), kErrors);
  EXPECT_LT(position_error(hypothesis, drive), 0.3);
  EXPECT_NEAR(hypothesis.line_of_sight_share, 8.0 / 13.0, 0.05);
  EXPECT_LT(hypothesis.chain[1], 0.1);
  EXPECT_GT(hypothesis.chain[7], 0.8);
}

TEST(PseudorangeHypothesis, EvidenceTellsRightFromWrong) {
  SatelliteDrive drive(3);
  PseudorangeHypothesis right = knowing(drive, 2.0, 0.01);
  PseudorangeHypothesis wrong = right;
  wrong.belief.mean(kX) += 30.0;
  right.update(slotted(drive, 0.0), kErrors);
  wrong.update(slotted(drive, 0.0), kErrors);
  EXPECT_GT(right.log_weight, wrong.log_weight + 0.5);
}

TEST(PseudorangeHypothesis, FollowsTheClockWhenItJumps) {
  for (const double jump : {-299792.458, -200.0, 200.0, 299792.458}) {
    SatelliteDrive drive(4);
    drive.delayed = {0, 8};
    PseudorangeHypothesis hypothesis = knowing(drive, 2.0, 0.01);
    drive.clock += jump;
    for (int i = 0; i < 3; ++i) hypothesis.update(slotted(drive, 0.0), kErrors);
    EXPECT_NEAR(hypothesis.belief.mean(State::kClock), drive.clock, 3.0);
    EXPECT_LT(position_error(hypothesis, drive), 3.0);
  }
}

TEST(PseudorangeHypothesis, CountsTheClockBackByTheAgeOfTheEpoch) {
  SatelliteDrive drive(5);
  drive.range_sigma = 0.0;
  PseudorangeHypothesis hypothesis = knowing(drive, 2.0, 0.01);
  SlottedEpoch epoch = slotted(drive, 0.0);
  epoch.age = 0.5;
  hypothesis.belief.mean(State::kClock) += 0.5 * drive.drift;
  const double before = hypothesis.belief.mean(State::kClock);
  hypothesis.update(epoch, kErrors);
  EXPECT_NEAR(hypothesis.belief.mean(State::kClock), before, 0.01);
}

TEST(PseudorangeHypothesis, RangeRatesTellTheHeading) {
  SatelliteDrive drive(6);
  drive.doppler = true;
  for (int i = 0; i < 10; ++i) drive.drive();
  PseudorangeHypothesis hypothesis = knowing(drive, 2.0, 0.3);
  hypothesis.belief.mean(kYaw) += 0.3;
  SlottedEpoch epoch = slotted(drive, drive.speed);
  epoch.yaw_rate = 0.25 * std::sin(0.15 * drive.time);
  for (int i = 0; i < 5; ++i) hypothesis.update(epoch, kErrors);
  EXPECT_NEAR(hypothesis.belief.mean(kYaw), drive.truth.yaw, 0.05);
  EXPECT_LT(hypothesis.belief.covariance(kYaw, kYaw), 0.05 * 0.05);
}

TEST(PseudorangeHypothesis, SlotsKeepTheirChains) {
  SatelliteDrive drive(7);
  drive.delayed = {12};
  PseudorangeHypothesis hypothesis = knowing(drive, 2.0, 0.01);
  hypothesis.update(slotted(drive, 0.0), kErrors);
  const double last = hypothesis.chain[13];
  hypothesis.remove(2);
  EXPECT_EQ(hypothesis.chain[2], last);
  hypothesis.append(16.0);
  EXPECT_LT(hypothesis.chain[13], 0.0);
}

}  // namespace
}  // namespace multipath_localization
