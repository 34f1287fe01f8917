#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "default_localizer.hpp"
#include "shares.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

TEST(MultipathParticleFilter, ABiasOfFiveMetresForHalfAMinuteIsTracked) {
  const double tracked = share_of_seeds(24, [](std::uint64_t seed) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    EXPECT_TRUE(localizer.estimate().aligned);
    const auto direction = static_cast<double>(seed);
    robot.bias = [&](double) {
      return Eigen::Vector2d(5.0 * std::cos(direction), 5.0 * std::sin(direction));
    };
    double largest = 0.0;
    robot.run(localizer, 30.0,
              [&] { largest = std::max(largest, position_error(localizer.estimate(), robot.truth).norm()); });
    return largest < 2.0 && localizer.state() == Trust::kMultipath &&
           (localizer.estimate().bias - robot.bias(0.0)).norm() < 2.0;
  });
  EXPECT_GE(tracked, 0.75);
}

TEST(MultipathParticleFilter, AParkedRobotDoesNotFollowABias) {
  const double stayed = share_of_seeds(6, [](std::uint64_t seed) {
    SimulatedDrive robot(seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 60.0);
    robot.speed = 0.0;
    robot.run(localizer, 5.0);
    const Eigen::Vector2d parked = localizer.estimate().pose.position();
    robot.bias = [](double) { return Eigen::Vector2d(4.0, -3.0); };
    robot.run(localizer, 300.0);
    return (localizer.estimate().pose.position() - parked).norm() < 1.0;
  });
  EXPECT_GE(stayed, 0.8);
}

TEST(MultipathParticleFilter, AParkedRobotDoesNotSlideAwayWithABiasThatWalksIn) {
  const double stayed = share_of_seeds(6, [](std::uint64_t seed) {
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
    return position_error(localizer.estimate(), robot.truth).norm() < 1.0;
  });
  EXPECT_GE(stayed, 0.8);
}

TEST(MultipathParticleFilter, KnowsHowLittleItKnowsInADeepCanyon) {
  double mean = 0.0;
  constexpr int kSeeds = 5;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedDrive robot(seed);
    robot.speed = 5.0;
    robot.bias = WanderingBias(25.0, 15.0, seed);
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 150.0);
    for (int i = 0; i < 6; ++i) {
      robot.run(localizer, 15.0);
      mean += nees(localizer.estimate(), robot.truth) / (6.0 * kSeeds);
    }
  }
  EXPECT_LT(mean, 6.0);
}

TEST(MultipathParticleFilter, TakesTheSigmaAReceiverDeclaresForEvidenceNotForTruth) {
  const double right = share_of_seeds(6, [](std::uint64_t seed) {
    SimulatedDrive robot(seed);
    Localizer localizer(std::make_unique<MultipathParticleFilter>(MultipathParticleFilterParameters{}, seed),
                        LocalizerParameters{});
    load_fields(
        YAML::Load("{fix_covariance: {scale: 0.1}}"), [&](ParameterVisitor& field) { localizer.tune(field); },
        "");
    localizer.start(std::nullopt);
    robot.run(localizer, 60.0);
    return nees(localizer.estimate(), robot.truth) < 9.0 &&
           position_error(localizer.estimate(), robot.truth).norm() < 0.5;
  });
  EXPECT_GE(right, 0.8);
}

/// Whether the filter is within a metre half a minute after an outage of a minute, of which it has to tell.
bool recovers_from_an_outage(std::uint64_t drive_seed, std::uint64_t filter_seed) {
  SimulatedDrive robot(drive_seed);
  Localizer localizer = default_localizer(filter_seed);
  robot.run(localizer, 60.0);
  const double before = localizer.estimate().covariance.trace();
  robot.receiving = false;
  robot.run(localizer, 60.0);
  const PoseEstimate blind = localizer.estimate();
  EXPECT_EQ(localizer.state(), Trust::kDeadReckoning);
  EXPECT_GT(blind.covariance.trace(), 2.0 * before);
  EXPECT_EQ(blind.covariance.llt().info(), Eigen::Success);
  EXPECT_LT(nees(blind, robot.truth), 13.8) << drive_seed;  // exceeded by one in a thousand
  robot.receiving = true;
  robot.run(localizer, 30.0);
  return position_error(localizer.estimate(), robot.truth).norm() < 1.0;
}

TEST(MultipathParticleFilter, DoesNotTakeForGrantedWhatFixesSayAfterAnOutage) {
  constexpr int kSeeds = 12;
  int captured = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedDrive robot(seed);
    robot.speed = 8.0;
    robot.bend = 0.1;
    robot.status = FixStatus::kGroundBased;
    robot.bias = [](double t) { return t > 90.0 ? Eigen::Vector2d(5.66, 5.66) : Eigen::Vector2d(0.0, 0.0); };
    Localizer localizer = default_localizer(seed);
    robot.run_through_outage(localizer, 60.0, 40.0, 50.0);
    captured += nees(localizer.estimate(), robot.truth) > 12.0 ? 1 : 0;
  }
  EXPECT_LE(captured, kSeeds / 3);
}

/// A receiver that fixes its ambiguities wrong after an outage agrees with the odometry to the centimetre.
TEST(MultipathParticleFilter, IsNotSureToTheCentimetreOfTheFixesAfterAnOutage) {
  const double sure_and_wrong = share_of_seeds(12, [](std::uint64_t seed) {
    SimulatedDrive robot(seed);
    robot.fix_sigma = 0.01;
    robot.status = FixStatus::kGroundBased;
    robot.bias = [](double t) -> Eigen::Vector2d {
      if (t < 90.0) return Eigen::Vector2d::Zero();
      return Eigen::Vector2d(0.8, -0.8) *
             std::min(1.0, 0.5 + 0.1 * (t - 100.0));  // as its own filter settles
    };
    Localizer localizer = default_localizer(seed);
    robot.run_through_outage(localizer, 60.0, 40.0, 40.0);
    return nees(localizer.estimate(), robot.truth) > 100.0;
  });
  EXPECT_LE(sure_and_wrong, 0.2);
}

/// Some fixes of a second wait for the others when an outage begins.
TEST(MultipathParticleFilter, GoesByTheFixesAfterAnOutageNotByThoseBeforeIt) {
  constexpr int kSeeds = 16;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedDrive robot(seed);
    robot.speed = 15.0;
    robot.bend = 0.1;
    robot.fix_sigma = 0.02;
    robot.status = FixStatus::kGroundBased;
    Localizer localizer = default_localizer(seed);
    robot.run_through_outage(localizer, 60.4, 60.0, 3.0);
    found += position_error(localizer.estimate(), robot.truth).norm() < 0.5 ? 1 : 0;
  }
  EXPECT_GE(found, kSeeds / 2);
}

TEST(MultipathParticleFilter, DoesNotTakeAWrongAmbiguityAfterAFloatForTheTruth) {
  constexpr int kSeeds = 8;
  int captured = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedDrive robot(seed);
    robot.speed = 0.7;
    robot.status = FixStatus::kGroundBased;
    robot.fix_sigma = 0.02;
    robot.bias = [](double t) { return Eigen::Vector2d(t < 80.0 ? 0.0 : t < 90.0 ? 6.5 : 5.5, 0.0); };
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 80.0);
    robot.fix_sigma = 0.7;
    robot.run(localizer, 10.0);
    robot.fix_sigma = 0.02;
    robot.run(localizer, 15.0);
    captured += nees(localizer.estimate(), robot.truth) > 12.0 ? 1 : 0;
  }
  EXPECT_LE(captured, kSeeds / 4);
}

/// A bias that does not move agrees with the odometry as well as the truth does.
TEST(MultipathParticleFilter, IsNotWonOverByAConstantBiasOfAnRtkReceiver) {
  constexpr int kSeeds = 8;
  int captured = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedDrive robot(seed);
    robot.speed = 0.6;
    robot.fix_sigma = 0.015;
    robot.status = FixStatus::kGroundBased;
    robot.bias = [](double t) { return Eigen::Vector2d(t < 90.0 ? 0.0 : 12.0, 0.0); };
    Localizer localizer = default_localizer(seed);
    robot.run(localizer, 150.0);
    captured += nees(localizer.estimate(), robot.truth) > 12.0 ? 1 : 0;
  }
  EXPECT_LE(captured, kSeeds / 4);
}

TEST(MultipathParticleFilter, GrowsUnsureThroughAnOutageAndRecovers) {
  EXPECT_TRUE(recovers_from_an_outage(7, 1));
  EXPECT_GE(share_of_seeds(6, [](std::uint64_t seed) { return recovers_from_an_outage(seed, seed); }), 0.8);
}

}  // namespace
}  // namespace multipath_localization
