#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <memory>

#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/estimators/pseudorange_particle_filter.hpp"
#include "pseudorange_drive.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

/// The overrides that make the filter the printed one.
std::string as_printed() {
  return YAML::Dump(YAML::LoadFile(std::string(CONFIG_DIR) + "/printed/pseudorange_particle_filter.yaml"));
}

Localizer localizer_with(const std::string& parameters = "{}", std::uint64_t seed = 1,
                         const std::optional<PosePrior>& prior = std::nullopt) {
  Localizer localizer(make_estimator("pseudorange_particle_filter", YAML::Load(parameters), seed), {});
  localizer.start(prior);
  return localizer;
}

PosePrior prior_at(const Pose2& pose) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = Eigen::Vector3d(1.0, 1.0, 0.01).asDiagonal();
  return prior;
}

double root_mean_square(PseudorangeDrive& drive, Localizer& localizer, double duration) {
  RootMeanSquare rms;
  drive.run(localizer, duration,
            [&] { rms.add(localizer.estimate().pose.position() - drive.truth.position()); });
  return rms.value();
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

TEST(PseudorangeParticleFilter, ComesBackFromADisplacedCloud) {
  for (const double displacement : {40.0, 400.0, 4e4}) {
    PseudorangeDrive drive(8);
    PseudorangeDrive same(8);
    Pose2 astray = drive.truth;
    astray.x += displacement;
    Localizer localizer = localizer_with("{}", 1, prior_at(astray));
    Localizer without = localizer_with("{reset: never}", 1, prior_at(astray));
    drive.run(localizer, 30.0);
    same.run(without, 30.0);
    EXPECT_LT(drive.error(localizer), 3.0);
    EXPECT_GT(same.error(without), 20.0);
  }
}

TEST(PseudorangeParticleFilter, StartsFromAPrior) {
  PseudorangeDrive drive(9);
  Localizer localizer = localizer_with("{}", 1, prior_at(drive.truth));
  EXPECT_TRUE(localizer.estimate().valid);
  EXPECT_LT(root_mean_square(drive, localizer, 20.0), 1.5);
  EXPECT_TRUE(localizer.estimate().aligned);
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

TEST(PseudorangeParticleFilter, RestartForgetsEverything) {
  PseudorangeParticleFilter used({}, 1);
  PseudorangeParticleFilter fresh({}, 1);
  used.start(prior_at({500.0, 0.0, 1.0}));
  used.update(PseudorangeDrive(2).epoch());
  used.predict({0.1, 0.1, 3.0, 0.1});
  used.start(std::nullopt);
  EXPECT_FALSE(used.estimate().valid);
  EXPECT_TRUE(used.hypotheses().empty());
  fresh.start(std::nullopt);
  for (PseudorangeParticleFilter* filter : {&used, &fresh}) {
    filter->predict({0.1, 0.1, 3.0, 0.1});
    filter->update(PseudorangeDrive(2).epoch());
  }
  EXPECT_EQ(numbers_of(used.estimate()), numbers_of(fresh.estimate()));
}

TEST(PseudorangeParticleFilter, RefusesWhatItCannotUseAndStaysAsItIs) {
  PseudorangeDrive drive(14);
  PseudorangeParticleFilter filter({}, 1);
  filter.start(std::nullopt);
  PseudorangeEpoch three = drive.epoch();
  three.observations.resize(3);
  EXPECT_EQ(filter.update(three).reason, Reason::kTooFewSatellites);
  EXPECT_FALSE(filter.estimate().valid);
  ASSERT_TRUE(filter.update(drive.epoch()).accepted());
  filter.predict({0.1, 0.1, 5.0, 0.0});
  const std::vector<double> before = numbers_of(filter.estimate());
  PseudorangeEpoch not_finite = drive.epoch();
  not_finite.antenna_in_base.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(filter.update(GnssFix{}).reason, Reason::kUnused);
  EXPECT_EQ(filter.update(PseudorangeEpoch{}).reason, Reason::kTooFewSatellites);
  EXPECT_EQ(filter.update(not_finite).reason, Reason::kNotFinite);
  filter.predict({0.2, -1.0, 5.0, 0.0});
  filter.predict({0.2, 0.1, std::numeric_limits<double>::quiet_NaN(), 0.0});
  EXPECT_EQ(numbers_of(filter.estimate()), before);
  EXPECT_EQ(filter.update(three).reason, Reason::kTooFewSatellites);
  EXPECT_EQ(numbers_of(filter.estimate()), before);
}

TEST(PseudorangeParticleFilter, BrokenSatellitesHarmNothing) {
  PseudorangeDrive drive(15);
  drive.doppler = true;
  drive.disturb = [](std::vector<SatelliteObservation>& sky) {
    sky[0].pseudorange = std::numeric_limits<double>::quiet_NaN();
    sky[3].pseudorange = 1e300;
    sky[5].range_rate = std::numeric_limits<double>::infinity();
    sky[6].cn0 = SatelliteObservation::kUnknown;
    sky[7].range_rate = 1e200;
    sky[8].sigma = 1e-3;
    sky.push_back(sky[2]);
  };
  Localizer localizer = localizer_with();
  drive.run(localizer, 20.0, [&] { ASSERT_TRUE(all_finite(localizer.estimate())); });
  EXPECT_LT(drive.error(localizer), 2.5);
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

TEST(PseudorangeParticleFilter, InnovationIsThePositionOfTheMeansSubset) {
  PseudorangeDrive drive(17);
  drive.noise = 0.0;
  PseudorangeParticleFilter filter({}, 1);
  filter.start(prior_at({drive.truth.x + 6.0, drive.truth.y - 4.0, drive.truth.yaw}));
  const Innovation result = filter.update(drive.epoch());
  ASSERT_TRUE(result.accepted());
  EXPECT_LT((result.innovation - Eigen::Vector2d(-6.0, 4.0)).norm(), 0.5);
  EXPECT_NEAR(result.nis, result.innovation.dot(result.covariance.inverse() * result.innovation), 1e-9);
}

}  // namespace
}  // namespace multipath_localization
