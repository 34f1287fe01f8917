#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "default_localizer.hpp"
#include "estimators/gated_ekf/gated_ekf.hpp"
#include "estimators/multipath/multipath_particle_filter.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

TEST(MultipathParticleFilter, AgreesWithTheGatedEkfUnderAnOpenSky) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SimulatedDrive robot(seed);
    SimulatedDrive twin(seed);
    Localizer ours = default_localizer(seed);
    Localizer ekf(std::make_unique<GatedEkf>(GatedEkfParameters{}), LocalizerParameters{});
    ekf.start(std::nullopt);
    robot.run(ours, 40.0);
    twin.run(ekf, 40.0);
    RootMeanSquare difference;
    for (int i = 0; i < 300; ++i) {
      robot.run(ours, 0.2);
      twin.run(ekf, 0.2);
      difference.add(ours.estimate().pose.position() - ekf.estimate().pose.position());
    }
    EXPECT_TRUE(ours.estimate().aligned);
    EXPECT_LT(difference.value(), 0.15) << seed;
  }
}

TEST(MultipathParticleFilter, IsNotOverConfidentUnderAnOpenSky) {
  constexpr int kSeeds = 12;
  double mean = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedDrive robot(seed);
    robot.status = FixStatus::kGroundBased;
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 40.0);
    for (int i = 0; i < 10; ++i) {
      robot.run(localizer, 4.0);
      mean += nees(localizer.estimate(), robot.truth) / (10.0 * kSeeds);
    }
  }
  // Mean of a chi-square of 2 dof plus 3.3 standard deviations, as if each run told one thing only.
  EXPECT_LT(mean, 2.0 + 3.3 * std::sqrt(4.0 / kSeeds));
  EXPECT_GT(mean, 0.1);
}

double declared(const PoseEstimate& estimate) {
  return std::sqrt(0.5 * estimate.covariance.topLeftCorner<2, 2>().trace());
}

TEST(MultipathParticleFilter, WithoutCorrectionsKnowsThatAllFixesMayBeOffAlike) {
  SimulatedDrive robot(1);
  Localizer localizer = default_localizer(1);
  robot.run(localizer, 40.0);
  EXPECT_GT(declared(localizer.estimate()), 1.5);
  robot.status = FixStatus::kGroundBased;
  robot.run(localizer, 5.0);
  EXPECT_LT(declared(localizer.estimate()), 0.7);
  robot.status = FixStatus::kSingle;
  robot.run(localizer, 5.0);
  EXPECT_LT(declared(localizer.estimate()), 1.0) << "odometry keeps what corrections gave";
  robot.run(localizer, 60.0);
  EXPECT_GT(declared(localizer.estimate()), 1.5);
}

TEST(MultipathParticleFilter, FollowsTheFixesWhereOdometryTellsOfNoTurn) {
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SimulatedDrive robot(seed);
    robot.spoilt = [](OdometryIncrement u) {
      u.yaw_rate = 0.0;
      return u;
    };
    Localizer localizer = default_localizer(seed);
    RootMeanSquare error;
    robot.run(localizer, 40.0);
    robot.run(localizer, 60.0,
              [&] { error.add(localizer.estimate().pose.position() - robot.truth.position()); });
    worst += error.value() / 6.0;
  }
  EXPECT_LT(worst, 1.0) << "m in the mean of the seeds";
}

TEST(MultipathParticleFilter, KeepsUpWithARobotWhoseEncoderTellsOfOneTickAtATime) {
  constexpr double kTick = 0.03;  // [m], three increments of a robot at 0.2 m/s
  RootMeanSquare error;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SimulatedDrive robot(seed);
    robot.speed = 0.2;
    robot.bend = 0.05;
    double way = 0.0;
    robot.spoilt = [&](OdometryIncrement u) {
      way += u.speed * u.duration;
      const double told = way >= kTick ? kTick : 0.0;
      way -= told;
      u.yaw_rate *= told / (u.speed * u.duration);
      u.speed = told / u.duration;
      return u;
    };
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.run(localizer, 120.0,
              [&] { error.add(localizer.estimate().pose.position() - robot.truth.position()); });
  }
  EXPECT_LT(error.value(), 0.4) << "and not metres behind, held by fixes that are taken for biased at rest";
}

double open_sky_error(double latency, const Eigen::Vector2d& antenna, double speed) {
  RootMeanSquare error;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SimulatedDrive robot(seed);
    robot.latency = latency;
    robot.antenna = antenna;
    robot.speed = speed;
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 40.0);
    EXPECT_TRUE(localizer.estimate().aligned) << seed;
    robot.run(localizer, 40.0, [&] { error.add(position_error(localizer.estimate(), robot.truth)); });
    EXPECT_LT(std::abs(angle_difference(localizer.estimate().pose.yaw, robot.truth.yaw)), 0.1) << seed;
  }
  return error.value();
}

TEST(MultipathParticleFilter, LateFixesAreAsGoodAsPromptOnes) {
  const double prompt = open_sky_error(0.0, {0.0, 0.0}, 2.0);
  const double late = open_sky_error(0.3, {0.0, 0.0}, 2.0);
  EXPECT_LT(prompt, 0.4);
  EXPECT_NEAR(late, prompt, 0.05);  // 0.6 m of driving, were the age not counted
}

TEST(MultipathParticleFilter, ALeverArmCostsNothingThoughTheHeadingIsUnknownAtFirst) {
  EXPECT_LT(open_sky_error(0.0, {1.0, 0.0}, 2.0), 0.4);
  EXPECT_LT(open_sky_error(0.0, {-0.6, 0.8}, 2.0), 0.4);
}

TEST(MultipathParticleFilter, FindsAndKeepsTheHeadingInReverse) {
  EXPECT_LT(open_sky_error(0.0, {0.5, 0.0}, -1.5), 0.4);
  SimulatedDrive robot(4);
  Localizer localizer = default_localizer(1);
  robot.run(localizer, 60.0);
  for (const double speed : {-2.0, 2.0, -1.0}) {
    robot.speed = speed;
    robot.run(localizer, 20.0, [&] {
      EXPECT_LT(std::abs(angle_difference(localizer.estimate().pose.yaw, robot.truth.yaw)), 0.15);
    });
  }
}

TEST(MultipathParticleFilter, ReckonsWithTheNoiseOfTheReceiverAsItIs) {
  SimulatedDrive robot(3);
  robot.fix_sigma = 1.0;
  Localizer localizer(std::make_unique<MultipathParticleFilter>(MultipathParticleFilterParameters{}, 3),
                      LocalizerParameters{});
  localizer.start(std::nullopt);
  robot.run(localizer, 60.0);
  localizer.take_reports();
  robot.run(localizer, 120.0);
  double nis = 0.0;
  const std::vector<MeasurementReport> reports = localizer.take_reports();
  for (const MeasurementReport& report : reports) nis += report.innovation.nis;
  nis /= static_cast<double>(reports.size());
  EXPECT_GT(nis, 1.0);
  EXPECT_LT(nis, 4.0);
  ASSERT_TRUE(reports.back().observed_sigma && reports.back().used_sigma);
  EXPECT_NEAR(*reports.back().observed_sigma, 1.0, 0.4);
  EXPECT_NEAR(*reports.back().used_sigma, 1.0, 0.4);
}

}  // namespace
}  // namespace multipath_localization
