#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "estimators/pseudorange_mixture/pseudorange_kalman_filter.hpp"
#include "models/pseudorange/ionospheric_slant.hpp"
#include "satellite_drive.hpp"

namespace multipath_localization {
namespace {

using State = PseudorangeBelief;

const RangeErrorParameters kErrors;

/// A filter that knows everything about a drive, to these standard deviations.
PseudorangeKalmanFilter knowing(const SatelliteDrive& drive, double position_sigma, double yaw_sigma) {
  PseudorangeKalmanFilter filter{PseudorangeBelief()};
  auto& x = filter.belief.mean;
  auto& P = filter.belief.covariance;
  x << drive.truth.x, drive.truth.y, drive.truth.yaw, drive.errors.speed_scale, drive.errors.gyro_bias,
      drive.up, drive.clock, drive.drift, 0.0, 0.0, 0.0;
  P.diagonal() << position_sigma * position_sigma, position_sigma * position_sigma, yaw_sigma * yaw_sigma,
      1e-6, 1e-8, 4.0, 4.0, 0.01, 1e-4, 1e-4, 1e-4;
  for (std::size_t i = 0; i <= drive.sky.size(); ++i) filter.append(0.01);
  x(State::state_of(0)) = drive.offset;
  return filter;
}

/// The drive's epoch; slot 0 is the offset, slot i + 1 satellite i.
SlottedEpoch slotted(const SatelliteDrive& drive, double speed) {
  PseudorangeEpoch epoch = drive.epoch();
  // Against strong signals of 48: the sky has 45, late ones 38.
  for (SatelliteObservation& observation : epoch.observations) observation.cn0 -= 48.0;
  SlottedEpoch result;
  result.antenna_in_base = epoch.antenna_in_base;
  result.duration = result.information = 1.0;
  result.speed = speed;
  for (std::size_t i = 0; i < epoch.observations.size(); ++i) {
    const SatelliteObservation& observation = epoch.observations[i];
    const bool gps = observation.constellation == Constellation::kGps;
    result.satellites.push_back({observation, static_cast<int>(i) + 1, gps ? -1 : 0,
                                 line_of_sight_prior(observation, kErrors.mixture),
                                 mean_nlos_delay(observation.elevation, kErrors.mixture),
                                 kErrors.range_sigma});
  }
  return result;
}

double position_error(const PseudorangeKalmanFilter& filter, const SatelliteDrive& drive) {
  return (filter.belief.pose().position() - drive.truth.position()).norm();
}

TEST(PseudorangeKalmanFilter, ComesToTheTruth) {
  SatelliteDrive drive(1);
  drive.range_sigma = 0.0;
  PseudorangeKalmanFilter filter = knowing(drive, 10.0, 0.01);
  filter.belief.mean(kX) += 8.0;
  filter.belief.mean(kY) -= 6.0;
  for (int i = 0; i < 5; ++i) filter.update(slotted(drive, 0.0), kErrors);
  EXPECT_LT(position_error(filter, drive), 0.3);
  EXPECT_GT(filter.line_of_sight_share, 0.9);
}

TEST(PseudorangeKalmanFilter, IsNotMovedByLateSignals) {
  SatelliteDrive drive(2);
  drive.range_sigma = 0.0;
  drive.delayed = {0, 1, 2, 3, 8};
  PseudorangeKalmanFilter filter = knowing(drive, 5.0, 0.01);
  for (int i = 0; i < 5; ++i) filter.update(slotted(drive, 0.0), kErrors);
  EXPECT_LT(position_error(filter, drive), 0.3);
  EXPECT_NEAR(filter.line_of_sight_share, 8.0 / 13.0, 0.05);
  EXPECT_LT(filter.chain[1], 0.1);
  EXPECT_GT(filter.chain[7], 0.8);
}

TEST(PseudorangeKalmanFilter, LearnsWhatTheIonosphereDelaysAtTheZenith) {
  constexpr double kZenithDelay = 5.0;
  SatelliteDrive drive(11);
  drive.range_sigma = 0.0;
  for (const SatelliteObservation& satellite : drive.sky) {
    drive.biases.push_back(kZenithDelay * ionospheric_slant(satellite.elevation));
  }
  PseudorangeKalmanFilter filter = knowing(drive, 5.0, 0.01);
  filter.belief.covariance(State::kZenithDelay, State::kZenithDelay) = 16.0;
  for (int i = 0; i < 20; ++i) filter.update(slotted(drive, 0.0), kErrors);
  EXPECT_NEAR(filter.belief.mean(State::kZenithDelay), kZenithDelay, 1.0);
  EXPECT_LT(position_error(filter, drive), 0.3);
  EXPECT_NEAR(filter.belief.mean(State::kUp), drive.up, 1.0);
}

TEST(PseudorangeKalmanFilter, EvidenceTellsRightFromWrong) {
  SatelliteDrive drive(3);
  PseudorangeKalmanFilter right = knowing(drive, 2.0, 0.01);
  PseudorangeKalmanFilter wrong = right;
  wrong.belief.mean(kX) += 30.0;
  const EpochEvidence of_right = right.update(slotted(drive, 0.0), kErrors);
  const EpochEvidence of_wrong = wrong.update(slotted(drive, 0.0), kErrors);
  EXPECT_GT(of_right.place, of_wrong.place + 0.5);
  EXPECT_GT(of_right.ranges, of_wrong.ranges + 5.0);
}

TEST(PseudorangeKalmanFilter, FollowsTheClockWhenItJumps) {
  for (const double jump : {-299792.458, -200.0, 200.0, 299792.458}) {
    SatelliteDrive drive(4);
    drive.delayed = {0, 8};
    PseudorangeKalmanFilter filter = knowing(drive, 2.0, 0.01);
    drive.clock += jump;
    for (int i = 0; i < 3; ++i) filter.update(slotted(drive, 0.0), kErrors);
    EXPECT_NEAR(filter.belief.mean(State::kClock), drive.clock, 3.0);
    EXPECT_LT(position_error(filter, drive), 3.0);
  }
}

TEST(PseudorangeKalmanFilter, CountsTheClockBackByTheAgeOfTheEpoch) {
  SatelliteDrive drive(5);
  drive.range_sigma = 0.0;
  PseudorangeKalmanFilter filter = knowing(drive, 2.0, 0.01);
  SlottedEpoch epoch = slotted(drive, 0.0);
  epoch.age = 0.5;
  filter.belief.mean(State::kClock) += 0.5 * drive.drift;
  const double before = filter.belief.mean(State::kClock);
  filter.update(epoch, kErrors);
  EXPECT_NEAR(filter.belief.mean(State::kClock), before, 0.01);
}

TEST(PseudorangeKalmanFilter, RangeRatesTellTheHeading) {
  SatelliteDrive drive(6);
  drive.doppler = true;
  for (int i = 0; i < 10; ++i) drive.drive();
  PseudorangeKalmanFilter filter = knowing(drive, 2.0, 0.3);
  filter.belief.mean(kYaw) += 0.3;
  SlottedEpoch epoch = slotted(drive, drive.speed);
  epoch.yaw_rate = 0.25 * std::sin(0.15 * drive.time);
  for (int i = 0; i < 5; ++i) filter.update(epoch, kErrors);
  EXPECT_NEAR(filter.belief.mean(kYaw), drive.truth.yaw, 0.05);
  EXPECT_LT(filter.belief.covariance(kYaw, kYaw), 0.05 * 0.05);
}

TEST(PseudorangeKalmanFilter, RangeRatesTellVelocityAndCourseWithoutWheels) {
  SatelliteDrive drive(8);
  drive.doppler = true;
  drive.antenna.setZero();
  for (int i = 0; i < 10; ++i) drive.drive();
  PseudorangeKalmanFilter filter = knowing(drive, 2.0, 1.8);
  filter.belief.mean(kYaw) += 2.0;
  filter.belief.covariance.diagonal().segment<2>(State::kVelocityEast).setConstant(100.0);
  SlottedEpoch epoch = slotted(drive, 0.0);
  epoch.wheels = false;
  EpochEvidence evidence;
  for (int i = 0; i < 5; ++i) evidence = filter.update(epoch, kErrors);
  EXPECT_NEAR(filter.belief.mean(State::kVelocityEast), drive.speed * std::cos(drive.truth.yaw), 0.2);
  EXPECT_NEAR(filter.belief.mean(State::kVelocityNorth), drive.speed * std::sin(drive.truth.yaw), 0.2);
  EXPECT_LT(std::abs(angle_difference(filter.belief.mean(kYaw), drive.truth.yaw)), 0.1);
  EXPECT_GT(evidence.rates, -13.0);
}

TEST(PseudorangeKalmanFilter, ASlowRobotMayReverse) {
  SatelliteDrive drive(9);
  PseudorangeKalmanFilter filter = knowing(drive, 2.0, 0.05);
  const double ahead = drive.truth.yaw;
  filter.belief.mean.segment<2>(State::kVelocityEast) << -2.0 * std::cos(ahead), -2.0 * std::sin(ahead);
  SlottedEpoch epoch = slotted(drive, 0.0);
  epoch.wheels = false;
  for (int i = 0; i < 5; ++i) filter.update(epoch, kErrors);
  EXPECT_NEAR(filter.belief.mean(kYaw), ahead, 0.1);
}

TEST(PseudorangeKalmanFilter, MixingKeepsTheMoments) {
  SatelliteDrive drive(10);
  PseudorangeKalmanFilter filter = knowing(drive, 2.0, 0.1);
  PseudorangeKalmanFilter other = filter;
  filter.belief.mean(kYaw) = kPi - 0.1;
  other.belief.mean(kYaw) = -kPi + 0.1;
  other.belief.mean(kX) += 10.0;
  other.chain[3] = 0.9;
  filter.mix(other, 0.25);
  EXPECT_NEAR(filter.belief.mean(kX), drive.truth.x + 2.5, 1e-9);
  EXPECT_NEAR(filter.belief.covariance(kX, kX), 4.0 + 0.25 * 0.75 * 100.0, 1e-9);
  EXPECT_NEAR(filter.belief.mean(kYaw), kPi - 0.05, 1e-9);
  EXPECT_NEAR(filter.chain[3], -0.75 + 0.225, 1e-9);
}

TEST(LineOfSightSigma, GrowsAsTheSignalWeakensAndIsBounded) {
  SatelliteObservation observation;
  observation.cn0 = -10.0;
  EXPECT_NEAR(line_of_sight_sigma(observation, kErrors), kErrors.range_sigma, 1e-12);
  observation.cn0 = -16.0;
  EXPECT_NEAR(line_of_sight_sigma(observation, kErrors), 2.0 * kErrors.range_sigma, 0.02);
  observation.cn0 = 40.0;
  EXPECT_NEAR(line_of_sight_sigma(observation, kErrors), 0.5 * kErrors.range_sigma, 1e-12);
  observation.cn0 = -40.0;
  EXPECT_NEAR(line_of_sight_sigma(observation, kErrors), 3.0 * kErrors.range_sigma, 1e-12);
  observation.cn0 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(line_of_sight_sigma(observation, kErrors), kErrors.range_sigma, 1e-12);
}

TEST(PseudorangeKalmanFilter, SlotsKeepTheirChains) {
  SatelliteDrive drive(7);
  drive.delayed = {12};
  PseudorangeKalmanFilter filter = knowing(drive, 2.0, 0.01);
  filter.update(slotted(drive, 0.0), kErrors);
  const double last = filter.chain[13];
  filter.remove(2);
  EXPECT_EQ(filter.chain[2], last);
  filter.append(16.0);
  EXPECT_LT(filter.chain[13], 0.0);
}

}  // namespace
}  // namespace multipath_localization
