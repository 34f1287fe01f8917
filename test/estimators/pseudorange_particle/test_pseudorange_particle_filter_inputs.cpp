#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <vector>

#include "estimators/pseudorange_particle/pseudorange_particle_filter.hpp"
#include "pseudorange_drive.hpp"
#include "pseudorange_localizer.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

PosePrior prior_at(const Pose2& pose) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = Eigen::Vector3d(1.0, 1.0, 0.01).asDiagonal();
  return prior;
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
