#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <map>
#include <vector>

#include "exact_receiver.hpp"
#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "simulation/raw_receiver.hpp"

namespace multipath_localization {
namespace {

std::vector<SatelliteObservation> observations(const std::vector<TrackedSignal>& signals) {
  std::vector<SatelliteObservation> all;
  for (const TrackedSignal& signal : signals) all.push_back(signal.observation);
  return all;
}

TEST(RawReceiver, WithoutErrorsThePseudorangesTellWhereItIs) {
  RawReceiver raw = receiver(exact());
  const auto sky = observations(raw.measure(kAtRest, 10.0));
  EXPECT_GE(sky.size(), 25U);
  const auto solution = solve_position(sky, declared_weights(sky), Eigen::Vector3d::Zero());
  ASSERT_TRUE(solution);
  EXPECT_LT((solution->position - kAtRest.position).norm(), 1e-3);
  EXPECT_NEAR(solution->clock[1], solution->clock[0], 1e-3);
  EXPECT_GT(std::abs(solution->clock[0]), 1.0);
}

TEST(RawReceiver, OffsetsBetweenSystemsAreConstantAndDrawnBySeed) {
  RawReceiverParameters parameters = exact();
  parameters.inter_system_sigma = 20.0;
  const int seeds = 100;
  double variance = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    RawReceiver raw = receiver(parameters, static_cast<std::uint64_t>(seed));
    const auto offset = [&](double time) {
      const auto sky = observations(raw.measure(kAtRest, time));
      const auto solution = solve_position(sky, declared_weights(sky), kAtRest.position);
      return solution->clock[1] - solution->clock[0];
    };
    const double first = offset(1.0);
    variance += first * first / seeds;
    EXPECT_NEAR(offset(50.0), first, 1e-2);
  }
  EXPECT_NEAR(std::sqrt(variance), 20.0, 6.0);
}

TEST(RawReceiver, InTheOpenTheErrorOfItsPositionIsThatOfItsNoise) {
  RawReceiverParameters parameters;
  parameters.atmosphere_sigma = 0.0;
  parameters.declared_floor = 0.1;
  parameters.declared_ratio = 1.0;
  double nees = 0.0;
  const int seeds = 200;
  for (int seed = 0; seed < seeds; ++seed) {
    RawReceiver raw = receiver(parameters, static_cast<std::uint64_t>(seed));
    const auto sky = observations(raw.measure(kAtRest, 1.0));
    const auto solution = solve_position(sky, declared_weights(sky), kAtRest.position);
    const Eigen::Vector3d error = solution->position - kAtRest.position;
    nees += error.dot(solution->covariance.ldlt().solve(error)) / seeds;
  }
  EXPECT_NEAR(nees, 3.0, 0.8);  // 4.5 sigma, and a little less for the floor
}

TEST(RawReceiver, NoiseAndItsDeclarationGrowAsSignalsWeaken) {
  RawReceiverParameters parameters = exact();
  parameters.code_noise = 1.0;
  parameters.doppler_noise = 0.1;
  parameters.cn0_zenith = parameters.cn0_horizon = 25.0;
  parameters.declared_floor = 3.0;
  parameters.declared_ratio = 2.0;
  RawReceiver noisy = receiver(parameters);
  parameters.code_noise = parameters.doppler_noise = 0.0;
  RawReceiver silent = receiver(parameters);
  double code = 0.0;
  double doppler = 0.0;
  double count = 0.0;
  for (int i = 1; i <= 40; ++i) {
    const auto with = observations(noisy.measure(kAtRest, i));
    const auto without = observations(silent.measure(kAtRest, i));
    ASSERT_EQ(with.size(), without.size());
    for (std::size_t k = 0; k < with.size(); ++k) {
      code += std::pow(with[k].pseudorange - without[k].pseudorange, 2);
      doppler += std::pow(with[k].range_rate - without[k].range_rate, 2);
      count += 1.0;
      EXPECT_NEAR(with[k].sigma, std::hypot(3.0, 20.0), 1e-9);
    }
  }
  EXPECT_NEAR(std::sqrt(code / count), 10.0, 1.0);
  EXPECT_NEAR(std::sqrt(doppler / count), 1.0, 0.1);
}

TEST(RawReceiver, WhatTheAtmosphereLeavesHasItsSizeAndTimeConstant) {
  RawReceiverParameters parameters = exact();
  parameters.atmosphere_sigma = 2.0;
  parameters.atmosphere_time_constant = 50.0;
  parameters.elevation_mask_deg = 60.0;  // close to the zenith
  double variance = 0.0;
  double covariance = 0.0;
  double count = 0.0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    RawReceiver with = receiver(parameters, seed);
    RawReceiverParameters none = parameters;
    none.atmosphere_sigma = 0.0;
    RawReceiver without = receiver(none, seed);
    std::map<int, double> early;
    for (const double time : {1.0, 51.0}) {
      auto clean = by_satellite(without.measure(kAtRest, time));
      for (const auto& [satellite, signal] : by_satellite(with.measure(kAtRest, time))) {
        const double delay = signal.observation.pseudorange - clean.at(satellite).observation.pseudorange;
        if (time < 2.0) {
          early[satellite] = delay;
        } else if (early.count(satellite) > 0) {
          variance += early[satellite] * early[satellite];
          covariance += early[satellite] * delay;
          count += 1.0;
        }
      }
    }
  }
  EXPECT_NEAR(std::sqrt(variance / count), 2.1, 0.25);
  EXPECT_NEAR(covariance / variance, std::exp(-1.0), 0.12);
}

TEST(RawReceiver, LowSatellitesAreSeenThroughMoreOfTheAtmosphere) {
  RawReceiverParameters parameters = exact();
  std::map<bool, double> squares;
  std::map<bool, double> count;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    parameters.atmosphere_sigma = 0.0;
    auto clean = by_satellite(receiver(parameters, seed).measure(kAtRest, 1.0));
    parameters.atmosphere_sigma = 2.0;
    for (const auto& [satellite, signal] : by_satellite(receiver(parameters, seed).measure(kAtRest, 1.0))) {
      const double elevation_deg = signal.observation.elevation * 180.0 / kPi;
      if (elevation_deg > 15.0 && elevation_deg < 60.0) continue;
      const double delay = signal.observation.pseudorange - clean.at(satellite).observation.pseudorange;
      squares[elevation_deg < 30.0] += delay * delay;
      count[elevation_deg < 30.0] += 1.0;
    }
  }
  EXPECT_NEAR(std::sqrt(squares[false] / count[false]), 2.1, 0.25);
  EXPECT_NEAR(std::sqrt(squares[true] / count[true]), 5.2, 0.8);  // 2.7 times as much at 12 degrees
}

TEST(RawReceiver, LeavesOutWhatIsLowOrWeakOrNotYetLocked) {
  RawReceiverParameters parameters = exact();
  parameters.elevation_mask_deg = 30.0;
  RawReceiver masked = receiver(parameters);
  const auto high = masked.measure(kAtRest, 1.0);
  EXPECT_GE(high.size(), 10U);
  for (const TrackedSignal& signal : high) {
    EXPECT_GE(signal.observation.elevation, 30.0 * kPi / 180.0);
  }
  parameters = exact();
  parameters.tracking_threshold = 45.0;
  RawReceiver deaf = receiver(parameters);
  const auto heard = deaf.measure(kAtRest, 1.0);
  EXPECT_FALSE(heard.empty());
  for (const TrackedSignal& signal : heard) EXPECT_GE(signal.observation.cn0, 45.0);

  parameters = exact();
  parameters.lock_delay = 2.0;
  const std::vector<BuildingParameters> hall = {{"hall", {-10, -10, 10, -10, 10, 10, -10, 10}, 20.0}};
  RawReceiver raw = receiver(parameters, 1, hall);
  EXPECT_FALSE(raw.measure(kAtRest, 1.0).empty());  // has been on for long
  EXPECT_TRUE(raw.measure({{0.0, 0.0, 2.0}, Eigen::Vector3d::Zero()}, 2.0).empty());
  EXPECT_TRUE(raw.measure(kAtRest, 3.0).empty());
  EXPECT_TRUE(raw.measure(kAtRest, 4.9).empty());
  EXPECT_FALSE(raw.measure(kAtRest, 5.0).empty());
}

}  // namespace
}  // namespace multipath_localization
