#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pseudorange_mixture/pseudorange_hypothesis.hpp"
#include "satellite_drive.hpp"

namespace multipath_localization {
namespace {

using State = PseudorangeBelief;

const RangeErrorParameters kErrors;
const OdometryNoise kOdometry;
const ReceiverStateNoise kNoise;

/// A hypothesis that knows where it is, and drives along by odometry that may slip.
class KnownDrive {
 public:
  explicit KnownDrive(std::uint64_t seed) : drive_(seed), hypothesis_(known()) {
    drive_.doppler = true;
    for (const SatelliteObservation& satellite : drive_.sky) {
      if (satellite.constellation != Constellation::kGps) add({satellite.constellation, std::nullopt}, 225.0);
    }
    for (const SatelliteObservation& satellite : drive_.sky) {
      add({satellite.constellation, satellite.satellite}, 4.0);
    }
  }

  /// For `seconds`, the odometry saying `scale` of the true speed.
  void run(int seconds, double scale) {
    for (int i = 0; i < seconds; ++i) {
      PreintegratedOdometry odometry(kOdometry);
      odometry.restart(hypothesis_.likeliest().mean(kScale), hypothesis_.likeliest().mean(kGyroBias));
      for (int k = 0; k < 10; ++k) {
        OdometryIncrement u = drive_.drive();
        u.speed *= scale;
        odometry.add(u);
      }
      hypothesis_.propagate(odometry, laws_of_wheels(), kOdometry, kNoise, slots_);
      hypothesis_.update(epoch(scale), laws_of_wheels(), kErrors);
    }
  }

  [[nodiscard]] double error() const {
    return (hypothesis_.planar().pose().position() - drive_.truth.position()).norm();
  }
  [[nodiscard]] const PseudorangeHypothesis& hypothesis() const { return hypothesis_; }

 private:
  [[nodiscard]] PseudorangeHypothesis known() const {
    PseudorangeBelief belief;
    belief.mean << drive_.truth.x, drive_.truth.y, drive_.truth.yaw, drive_.errors.speed_scale,
        drive_.errors.gyro_bias, drive_.up, drive_.clock, drive_.drift, 0.0, 0.0, 0.0;
    belief.covariance.diagonal() << 4.0, 4.0, 1e-4, 1e-6, 1e-8, 4.0, 4.0, 0.01, 1e-4, 1e-4, 1e-4;
    return {belief, laws_of_wheels()};
  }

  void add(const SlotOwner& owner, double variance) {
    for (const auto& change : slots_.admit({owner}, 0.0)) {
      if (change.appended == owner) hypothesis_.append(variance);
    }
  }

  [[nodiscard]] SlottedEpoch epoch(double scale) const {
    SlottedEpoch result;
    const PseudorangeEpoch measured = drive_.epoch();
    result.antenna_in_base = measured.antenna_in_base;
    result.duration = result.information = 1.0;
    result.has_rates = true;
    result.speed = scale * drive_.speed;
    result.yaw_rate = 0.25 * std::sin(0.15 * drive_.time);
    for (const SatelliteObservation& observation : measured.observations) {
      SlottedObservation satellite;
      satellite.observation = observation;
      satellite.prior = 0.9;
      satellite.bias_slot = *slots_.find({observation.constellation, observation.satellite});
      if (observation.constellation != Constellation::kGps) {
        satellite.offset_slot = *slots_.find({observation.constellation, std::nullopt});
      }
      result.satellites.push_back(satellite);
    }
    return result;
  }

  SatelliteDrive drive_;
  SatelliteSlots slots_;
  PseudorangeHypothesis hypothesis_;
};

TEST(PseudorangeHypothesis, BelievesOdometryThatHolds) {
  KnownDrive run(1);
  run.run(60, 1.0);
  EXPECT_LT(run.error(), 2.0);
  EXPECT_LT(run.hypothesis().probabilities()[3], 0.05);
  EXPECT_GT(run.hypothesis().line_of_sight_share(), 0.8);
}

TEST(PseudorangeHypothesis, GivesUpOdometryThatDiesAndTakesItBack) {
  KnownDrive run(2);
  run.run(30, 1.0);
  run.run(15, 0.0);
  EXPECT_GT(run.hypothesis().probabilities()[2] + run.hypothesis().probabilities()[3], 0.5);
  EXPECT_LT(run.error(), 6.0);
  run.run(40, 1.0);
  EXPECT_LT(run.hypothesis().probabilities()[3], 0.2);
  EXPECT_LT(run.error(), 3.0);
}

TEST(PseudorangeHypothesis, PlanarPartHasTheMomentsOfAllLaws) {
  KnownDrive run(3);
  run.run(10, 1.0);
  double sum = 0.0;
  for (const double probability : run.hypothesis().probabilities()) sum += probability;
  EXPECT_NEAR(sum, 1.0, 1e-4);
  EXPECT_GT(run.hypothesis().planar().covariance(kX, kX), 0.0);
}

}  // namespace
}  // namespace multipath_localization
