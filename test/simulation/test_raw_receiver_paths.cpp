#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "exact_receiver.hpp"
#include "simulation/raw_receiver.hpp"

namespace multipath_localization {
namespace {

/// Walls without end along a street from west to east, 20 m to either side of the antenna.
std::vector<BuildingParameters> street() {
  const double y = kAtRest.position.y();
  return {{"north", {-5e3, y + 20, 5e3, y + 20, 5e3, y + 40, -5e3, y + 40}, 40.0},
          {"south", {-5e3, y - 40, 5e3, y - 40, 5e3, y - 20, -5e3, y - 20}, 30.0}};
}

/// Whatever way a signal takes, its range rate is the derivative of its pseudorange.
TEST(RawReceiver, RangeRatesAreThoseOfThePathsTracked) {
  RawReceiverParameters parameters = exact();
  parameters.correlator_spacing = 0.01;  // leaves little of the echoes
  parameters.clock.drift_walk = 0.0;
  RawReceiver raw = receiver(parameters, 4, street());
  AntennaState antenna = kAtRest;
  antenna.velocity << 9.0, -4.0, 0.0;
  const double duration = 0.02;
  auto before = by_satellite(raw.measure(antenna, 1.0));
  antenna.position += duration * antenna.velocity;
  std::map<SignalPath::Kind, int> seen;
  for (const auto& [satellite, signal] : by_satellite(raw.measure(antenna, 1.0 + duration))) {
    if (before.count(satellite) == 0) continue;
    const TrackedSignal& then = before.at(satellite);
    if (then.path.kind != signal.path.kind) continue;
    const double covered = signal.observation.pseudorange - signal.multipath + signal.path.delay -
                           (then.observation.pseudorange - then.multipath + then.path.delay);
    const bool bent = signal.path.kind == SignalPath::Kind::kDiffracted;  // nearly
    EXPECT_NEAR(covered / duration, signal.observation.range_rate, bent ? 0.3 : 0.02);
    ++seen[signal.path.kind];
  }
  EXPECT_GE(seen[SignalPath::Kind::kDirect], 3);
  EXPECT_GE(seen[SignalPath::Kind::kReflected], 3);
}

TEST(RawReceiver, InAStreetHiddenSatellitesAreHeardLateAndWeak) {
  RawReceiver raw = receiver(exact(), 1, street());
  const auto signals = raw.measure(kAtRest, 1.0);
  int hidden = 0;
  for (const TrackedSignal& signal : signals) {
    const SatelliteObservation& observation = signal.observation;
    const double in_the_open = 41.0 + 8.0 * std::sin(observation.elevation);
    EXPECT_NEAR(observation.cn0, in_the_open - signal.path.loss_db, 1e-9);
    if (signal.line_of_sight()) continue;
    ++hidden;
    EXPECT_LT(observation.cn0, in_the_open - 5.0);
    if (signal.path.kind == SignalPath::Kind::kReflected) {
      EXPECT_GT(signal.multipath, 5.0);
      EXPECT_NEAR(signal.multipath, signal.path.delay, 5.0);
    }
  }
  EXPECT_GE(hidden, 4);
  EXPECT_LT(signals.size(), receiver(exact()).measure(kAtRest, 1.0).size());
}

/// Echoes beside the line of sight: metres at rest, hardly anything in motion.
TEST(RawReceiver, MotionAveragesEchoesOut) {
  const auto worst = [](const Eigen::Vector3d& velocity) {
    double largest = 0.0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      RawReceiver raw = receiver(exact(), seed, street());
      AntennaState antenna = kAtRest;
      antenna.velocity = velocity;
      for (const TrackedSignal& signal : raw.measure(antenna, 1.0)) {
        if (signal.line_of_sight()) largest = std::max(largest, std::abs(signal.multipath));
      }
    }
    return largest;
  };
  EXPECT_GT(worst(Eigen::Vector3d::Zero()), 1.0);
  EXPECT_LT(worst(Eigen::Vector3d::Zero()), 8.0);
  EXPECT_LT(worst({0.0, 8.0, 0.0}), 0.25 * worst(Eigen::Vector3d::Zero()));
}

TEST(RawReceiver, AJumpToAnotherPathDiesOut) {
  RawReceiverParameters parameters = exact();
  parameters.correlator_spacing = 0.01;
  parameters.loop_bandwidth = 0.25;  // a time constant of 1 s
  RawReceiver raw = receiver(parameters, 1, street());
  const auto hidden = by_satellite(raw.measure(kAtRest, 1.0));
  AntennaState above = kAtRest;
  above.position.z() = 41.0;
  const auto after = by_satellite(raw.measure(above, 2.0));
  const auto later = by_satellite(raw.measure(above, 6.0));
  int jumped = 0;
  for (const auto& [satellite, signal] : hidden) {
    if (signal.path.kind != SignalPath::Kind::kReflected || after.count(satellite) == 0) continue;
    ++jumped;
    EXPECT_TRUE(after.at(satellite).line_of_sight());
    EXPECT_NEAR(after.at(satellite).multipath, std::exp(-1.0) * signal.path.delay, 1.0);
    EXPECT_NEAR(later.at(satellite).multipath, 0.0, 2.0);
  }
  EXPECT_GE(jumped, 3);
}

TEST(RawReceiver, TheCodeFollowsAPathThatGrowsWithTheCarrier) {
  RawReceiverParameters parameters = exact();
  parameters.correlator_spacing = 0.01;
  parameters.loop_bandwidth = 0.01;  // alone it would take 25 s
  RawReceiver raw = receiver(parameters, 1, street());
  AntennaState antenna = kAtRest;
  antenna.velocity << 0.0, 4.0, 0.0;
  std::map<int, TrackedSignal> last;
  int followed = 0;
  for (int i = 1; i <= 20; ++i) {
    antenna.position.y() = kAtRest.position.y() + 0.4 * (i - 1);
    const auto now = by_satellite(raw.measure(antenna, 0.1 * i));
    for (const auto& [satellite, signal] : now) {
      if (last.count(satellite) == 0 || signal.path.kind != SignalPath::Kind::kReflected) continue;
      const double grown = signal.path.delay - last.at(satellite).path.delay;
      if (std::abs(grown) < 0.1 || std::abs(grown) > 1.0) continue;  // at rest or another path
      EXPECT_NEAR(signal.multipath - last.at(satellite).multipath, grown, 0.3 * std::abs(grown));
      ++followed;
    }
    last = now;
  }
  EXPECT_GT(followed, 40);
}

TEST(RawReceiver, SameSeedSameBytes) {
  const auto run = [](std::uint64_t seed) {
    std::vector<double> all;
    RawReceiver raw = receiver({}, seed, street());
    for (int i = 1; i <= 20; ++i) {
      for (const TrackedSignal& signal : raw.measure(kAtRest, 0.1 * i)) {
        all.insert(all.end(), {signal.observation.pseudorange, signal.observation.range_rate,
                               signal.observation.cn0, signal.observation.sigma});
      }
    }
    return all;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

}  // namespace
}  // namespace multipath_localization
