#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <string>
#include <vector>

#include "estimators/pseudorange_particle/pseudorange_particle_filter.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "pseudorange_drive.hpp"
#include "pseudorange_localizer.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

/// The overrides that make the filter the printed one.
std::string as_printed() {
  return YAML::Dump(YAML::LoadFile(std::string(CONFIG_DIR) + "/printed/pseudorange_particle_filter.yaml"));
}

/// Four signals of thirteen come by way of a wall, late by 60 m and weak.
void reflect_four(std::vector<SatelliteObservation>& sky) {
  for (const std::size_t late : {0U, 1U, 9U, 3U}) {
    sky[late].pseudorange += 60.0;
    sky[late].range_rate += 4.0;
    sky[late].cn0 = 36.0;
  }
}

double plain_error(const PseudorangeDrive& drive) {
  const PseudorangeEpoch epoch = drive.epoch();
  const auto plain =
      solve_position(epoch.observations, declared_weights(epoch.observations), Eigen::Vector3d::Zero());
  return (plain->position.head<2>() - drive.truth * drive.antenna).norm();
}

TEST(PseudorangeParticleFilter, FindsPositionAndHeadingUnderAnOpenSky) {
  for (const bool doppler : {false, true}) {
    PseudorangeDrive drive(3);
    drive.doppler = doppler;
    Localizer localizer = localizer_with();
    drive.run(localizer, 0.3);
    EXPECT_EQ(localizer.estimate().aligned, doppler);
    drive.run(localizer, 30.0);
    EXPECT_TRUE(localizer.estimate().aligned);
    EXPECT_LT(root_mean_square(drive, localizer, 10.0), 1.0);
    EXPECT_LT(std::abs(angle_difference(localizer.estimate().pose.yaw, drive.truth.yaw)), 0.1);
  }
}

TEST(PseudorangeParticleFilter, ExcludesAMinorityOfReflectedSignals) {
  for (const bool doppler : {false, true}) {
    PseudorangeDrive drive(4);
    drive.doppler = doppler;
    drive.disturb = reflect_four;
    EXPECT_GT(plain_error(drive), 15.0);
    Localizer localizer = localizer_with();
    drive.run(localizer, 30.0);
    EXPECT_LT(root_mean_square(drive, localizer, 10.0), 2.0);
    EXPECT_NEAR(localizer.estimate().shadow_probability, 4.0 / 13.0, 1e-9);
  }
}

TEST(PseudorangeParticleFilter, AReflectedReferenceMisleadsOnlyThePrintedFilter) {
  const auto reflected_reference = [](std::vector<SatelliteObservation>& sky) {
    sky[2].cn0 = 52.0;
    sky[2].elevation = 1.4;
    sky[2].pseudorange += 40.0;
  };
  PseudorangeDrive sound(5);
  PseudorangeDrive first(5);
  PseudorangeDrive second(5);
  first.doppler = second.doppler = sound.doppler = true;
  first.disturb = second.disturb = reflected_reference;
  Localizer undisturbed = localizer_with(as_printed());
  Localizer printed = localizer_with(as_printed());
  Localizer repaired = localizer_with();
  sound.run(undisturbed, 20.0);
  first.run(printed, 20.0);
  second.run(repaired, 20.0);
  EXPECT_LT(root_mean_square(sound, undisturbed, 5.0), 2.0);
  EXPECT_GT(root_mean_square(first, printed, 5.0), 4.0);
  EXPECT_LT(root_mean_square(second, repaired, 5.0), 2.0);
}

/// Root of the trace of the position covariance after 40 s, epochs coming at a rate.
double spread(const std::string& parameters, int steps_per_epoch) {
  PseudorangeDrive drive(6);
  drive.steps_per_epoch = steps_per_epoch;
  drive.noise = 0.0;
  Localizer localizer = localizer_with(parameters);
  drive.run(localizer, 30.0);
  double sum = 0.0;
  drive.run(localizer, 10.0,
            [&] { sum += std::sqrt(localizer.estimate().covariance.topLeftCorner<2, 2>().trace()); });
  return sum / 100.0;
}

TEST(PseudorangeParticleFilter, TemperingMakesEveryRateTellAlike) {
  EXPECT_NEAR(spread("{}", 10) / spread("{}", 1), 1.0, 0.15);
  EXPECT_GT(spread("{tempering: none}", 10) / spread("{tempering: none}", 1), 1.5);
}

TEST(PseudorangeParticleFilter, AParkedRobotGrowsNoCertainty) {
  PseudorangeDrive drive(7);
  drive.speed = 0.0;
  Localizer localizer = localizer_with();
  drive.run(localizer, 60.0);
  const PoseEstimate estimate = localizer.estimate();
  EXPECT_FALSE(estimate.aligned);
  EXPECT_GT(std::sqrt(estimate.covariance(0, 0)), 1.0);
  EXPECT_LT(drive.error(localizer), 3.0);
}

TEST(PseudorangeParticleFilter, DopplerMovesARobotWithoutWheels) {
  PseudorangeDrive drive(10);
  drive.doppler = true;
  drive.wheels = false;
  Localizer localizer = localizer_with("{yaw_walk: 0.2}");  // nor does anything measure the turning
  drive.run(localizer, 20.0);
  EXPECT_LT(root_mean_square(drive, localizer, 20.0), 1.5);
  EXPECT_LT(std::abs(angle_difference(localizer.estimate().pose.yaw, drive.truth.yaw)), 0.1);
  PseudorangeDrive same(10);
  same.doppler = true;
  same.wheels = false;
  Localizer by_odometry = localizer_with("{motion: odometry}");
  same.run(by_odometry, 20.0);
  EXPECT_GT(root_mean_square(same, by_odometry, 20.0), 5.0);
}

TEST(PseudorangeParticleFilter, LateEpochsAndALeverArmCostNothing) {
  for (const bool doppler : {false, true}) {
    PseudorangeDrive drive(11);
    drive.doppler = doppler;
    drive.antenna = {-4.0, 1.0};
    drive.latency = 0.4;
    Localizer localizer = localizer_with();
    drive.run(localizer, 30.0);
    EXPECT_LT(root_mean_square(drive, localizer, 15.0), 1.5);  // uncorrected: 2 m of delay, 4 m of lever
  }
}

TEST(PseudorangeParticleFilter, GoesOnByOdometryInAnOutage) {
  PseudorangeDrive drive(12);
  drive.doppler = true;
  Localizer localizer = localizer_with();
  drive.run(localizer, 30.0);
  drive.disturb = [](auto& sky) { sky.clear(); };
  drive.run(localizer, 20.0);
  EXPECT_LT(drive.error(localizer), 5.0);
  EXPECT_EQ(localizer.state(), Trust::kDeadReckoning);

  // The first epoch after it brings no leap to a position of its own.
  const double before = drive.error(localizer);
  drive.disturb = [](auto& sky) {
    for (std::size_t i = 0; i < sky.size(); i += 3) sky[i].pseudorange += 60.0;
  };
  drive.run(localizer, 0.2);
  EXPECT_LT(drive.error(localizer), before + 1.0);
}

TEST(PseudorangeParticleFilter, StatedCovarianceHoldsForErrorsThatLast) {
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    std::vector<double> errors(13, 0.0);
    RandomStream random(seed, 0, 77);
    PseudorangeDrive drive(seed);
    drive.steps_per_epoch = 5;
    drive.disturb = [&](std::vector<SatelliteObservation>& sky) {
      const double kept = std::exp(-0.5 / 10.0);
      for (std::size_t i = 0; i < sky.size(); ++i) {
        errors[i] = kept * errors[i] + 5.0 * std::sqrt(1.0 - kept * kept) * random.normal();
        sky[i].pseudorange += errors[i];
      }
    };
    Localizer localizer = localizer_with("{}", seed);
    drive.run(localizer, 30.0);
    drive.run(localizer, 30.0, [&] { sum += nees(localizer.estimate(), drive.truth), ++count; });
  }
  EXPECT_LT(sum / count, 3.0);
  EXPECT_GT(sum / count, 0.2);
}

TEST(PseudorangeParticleFilter, SameSeedSameBytes) {
  std::vector<std::vector<double>> runs;
  for (const std::uint64_t seed : {1U, 1U, 2U}) {
    PseudorangeDrive drive(13);
    drive.doppler = true;
    drive.disturb = reflect_four;
    Localizer localizer = localizer_with("{}", seed);
    drive.run(localizer, 5.0);
    runs.push_back(numbers_of(localizer.estimate()));
  }
  EXPECT_EQ(runs[0], runs[1]);
  EXPECT_NE(runs[0], runs[2]);
}

TEST(PseudorangeParticleFilter, HypothesesAreAWeightedCloudRoundTheEstimate) {
  PseudorangeDrive drive(16);
  Localizer localizer = localizer_with("{particles: 4500}");
  EXPECT_TRUE(localizer.hypotheses().empty());
  drive.run(localizer, 2.0);
  const auto all = localizer.hypotheses();
  EXPECT_EQ(all.size(), 1500U);
  double sum = 0.0;
  for (const Hypothesis& hypothesis : all) sum += hypothesis.weight;
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

}  // namespace
}  // namespace multipath_localization
