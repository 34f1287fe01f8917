#include <gtest/gtest.h>

#include <algorithm>

#include "default_localizer.hpp"
#include "multipath_localization/core/numbers.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

/// Squared error of position over the covariance of all hypotheses: 2 degrees of freedom.
double nees_overall(const PoseEstimate& estimate, const Pose2& truth) {
  const Eigen::Vector2d error = position_error(estimate, truth);
  return error.dot(estimate.position_covariance_overall.inverse() * error);
}

TEST(MultipathParticleFilter, AParkedRobotDoesNotSlideAwayWithABiasThatWalksIn) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.speed = 0.0;
    robot.run(localizer, 60.0);
    const double start = robot.time;
    robot.bias = [&](double time) {
      return Eigen::Vector2d(std::min(1.0, (time - start) / 6.0) * Eigen::Vector2d(-7.0, -7.0));
    };
    robot.run(localizer, 60.0);
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 1.0) << seed;
    EXPECT_EQ(localizer.state(), Trust::kMultipath) << seed;
  }
}

TEST(MultipathParticleFilter, DrivesOnWithTheFixesForAsLongAsTheEncodersStandStill) {
  for (const double speed : {1.0, 2.0}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SimulatedDrive robot(seed);
      robot.speed = speed;
      Localizer localizer = default_localizer(seed);
      robot.run(localizer, 60.0);
      robot.spoilt = [](const OdometryIncrement& u) { return OdometryIncrement{u.stamp, u.duration}; };
      double beyond = 0.0;
      robot.run(localizer, 30.0, [&] {
        if (nees_overall(localizer.estimate(), robot.truth) > 9.0) beyond += 0.2;
      });
      EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 1.5) << speed << " m/s, " << seed;
      EXPECT_LT(beyond, 5.0) << speed << " m/s, " << seed;
    }
  }
}

TEST(MultipathParticleFilter, ABiasThatNeverChangesIsAnErrorOfThePose) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    // What the filter can never know: the robot was carried 6 m to the side.
    robot.truth.x += 3.6;
    robot.truth.y -= 4.8;
    bool biased = false, doubted = false;
    double last_beyond = robot.time;
    const double start = robot.time;
    robot.run(localizer, 400.0, [&] {
      biased = biased || localizer.state() == Trust::kMultipath;
      doubted = doubted || localizer.state() == Trust::kAligning;
      if (nees_overall(localizer.estimate(), robot.truth) > 9.0) last_beyond = robot.time;
    });
    EXPECT_TRUE(biased) << seed;
    EXPECT_TRUE(doubted) << seed;
    const SteadyBiasParameters steady;
    EXPECT_LT(last_beyond - start, steady.time) << seed;
    EXPECT_EQ(localizer.state(), Trust::kGood) << seed;
    EXPECT_LT(position_error(localizer.estimate(), robot.truth).norm(), 1.0) << seed;
  }
}

TEST(MultipathParticleFilter, AnEncoderThatFailsDuringAnOutageMakesThePoseUnsure) {
  const auto overall_after_an_outage = [](bool failing) {
    SimulatedDrive robot(3);
    Localizer localizer = default_localizer(3);
    robot.run(localizer, 60.0);
    robot.receiving = false;
    robot.run(localizer, 10.0);
    if (failing) {
      robot.spoilt = [](const OdometryIncrement& u) {
        return OdometryIncrement{u.stamp, u.duration, 0.5 * u.speed, 0.5 * u.speed / 0.3};
      };
    }
    robot.run(localizer, 3.0);
    robot.spoilt = [](const OdometryIncrement& u) { return u; };
    robot.run(localizer, 30.0);
    if (failing) {
      EXPECT_GT(position_error(localizer.estimate(), robot.truth).norm(), 10.0);
      EXPECT_LT(nees_overall(localizer.estimate(), robot.truth), 9.0);
      EXPECT_EQ(localizer.state(), Trust::kLost);
    }
    return localizer.estimate().position_covariance_overall.trace();
  };
  const double sound = overall_after_an_outage(false);
  EXPECT_LT(sound, 9.0);
  EXPECT_GT(overall_after_an_outage(true), 20.0 * sound);
}

TEST(MultipathParticleFilter, APoseThatMayBeAnywhereIsToBeConfirmedAnew) {
  const auto aligned_after_an_outage = [](double doubtful_sigma) {
    MultipathParticleFilterParameters parameters;
    parameters.doubtful_sigma = doubtful_sigma;
    SimulatedDrive robot(1);
    Localizer localizer(std::make_unique<MultipathParticleFilter>(parameters, 1), LocalizerParameters{});
    localizer.start(std::nullopt);
    robot.run(localizer, 60.0);
    robot.receiving = false;
    robot.spoilt = [](const OdometryIncrement& u) {
      return OdometryIncrement{u.stamp, u.duration, 5.0 * u.speed, u.yaw_rate};
    };
    robot.run(localizer, 0.15);
    robot.spoilt = [](const OdometryIncrement& u) { return u; };
    robot.run(localizer, 60.0);
    EXPECT_TRUE(localizer.estimate().aligned);
    EXPECT_GT(localizer.estimate().position_covariance_overall.trace(), square(15.0));
    robot.receiving = true;
    robot.run(localizer, 0.4);
    return localizer.estimate().aligned;
  };
  EXPECT_TRUE(aligned_after_an_outage(1e6));
  EXPECT_FALSE(aligned_after_an_outage(10.0));
}

TEST(MultipathParticleFilter, AnOutageLeavesRoomForASlipThatNothingShows) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SimulatedDrive robot(seed);
    robot.bend = 0.02;
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.receiving = false;
    robot.run(localizer, 30.0);
    robot.spoilt = [](const OdometryIncrement& u) {
      return OdometryIncrement{u.stamp, u.duration, 1.5 * u.speed, u.yaw_rate};
    };
    robot.run(localizer, 1.5);
    robot.spoilt = [](const OdometryIncrement& u) { return u; };
    robot.run(localizer, 30.0);
    EXPECT_LT(nees_overall(localizer.estimate(), robot.truth), 9.0) << seed;
  }
}

}  // namespace
}  // namespace multipath_localization
