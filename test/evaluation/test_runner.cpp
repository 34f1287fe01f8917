#include <gtest/gtest.h>

#include <limits>

#include "dead_reckoning.hpp"
#include "evaluation/runner.hpp"

namespace multipath_localization {
namespace {

/// East along y = 0 at 1 m/s, odometry and truth each second, from t = 0 on.
Drive straight_drive(int seconds) {
  Drive drive;
  for (int i = 0; i <= seconds; ++i) {
    const double t = i;
    if (i > 0) drive.odometry.push_back({t, 1.0, 1.0, 0.0});
    drive.truth.push_back({t, {t, 0.0, 0.0}, true, std::nullopt});
  }
  return drive;
}

RecordedMeasurement fix(double stamp, double arrival) {
  GnssFix fix;
  fix.stamp = stamp;
  fix.position = {stamp, 0.0};
  return {fix, arrival};
}

EstimatorFactory dead_reckoning(DeadReckoning::Log* log = nullptr) {
  return [log] { return std::make_unique<DeadReckoning>(log); };
}

TEST(RunDrive, GivesOneEpochPerTruthSample) {
  RunSettings settings;
  settings.known_start = true;
  const std::vector<Epoch> epochs = run_drive(straight_drive(5), dead_reckoning(), settings);
  ASSERT_EQ(epochs.size(), 6u);
  EXPECT_FALSE(epochs[0].valid) << "no odometry had come in";
  for (std::size_t i = 1; i < epochs.size(); ++i) {
    EXPECT_TRUE(epochs[i].valid);
    EXPECT_NEAR(epochs[i].estimate.x, static_cast<double>(i), 1e-12);
  }
}

TEST(RunDrive, WithoutKnownStartTheFirstFixIsNeeded) {
  Drive drive = straight_drive(4);
  drive.measurements = {fix(2.0, 2.0)};
  const std::vector<Epoch> epochs = run_drive(drive, dead_reckoning(), {});
  EXPECT_FALSE(epochs[1].valid);
  EXPECT_TRUE(epochs[2].valid);
  EXPECT_NEAR(epochs[4].estimate.x, 4.0, 1e-12);
}

TEST(RunDrive, WithoutTruthItAsksAlongTheOdometry) {
  Drive drive = straight_drive(4);
  drive.truth.clear();
  drive.measurements = {fix(2.0, 2.0)};
  const std::vector<Epoch> epochs = run_drive(drive, dead_reckoning(), {});
  ASSERT_EQ(epochs.size(), 4u);
  EXPECT_FALSE(epochs[0].valid);
  EXPECT_NEAR(epochs[3].estimate.x, 4.0, 1e-12);
  EXPECT_EQ(epochs[3].truth.stamp, 4.0);
}

TEST(RunDrive, FixesCountInTheOrderOfTheirArrival) {
  Drive drive = straight_drive(5);
  drive.measurements = {fix(2.0, 2.0), fix(3.0, 3.0), fix(1.5, 3.5)};
  DeadReckoning::Log log;
  run_drive(drive, dead_reckoning(&log), {});
  EXPECT_EQ(log.updated, (std::vector<double>{2.0, 3.0, 1.5}));
}

TEST(RunDrive, StartsAfreshWhereTheDriveRestarts) {
  Drive drive = straight_drive(5);
  drive.measurements = {fix(1.0, 1.0), fix(4.0, 4.0)};
  drive.restarts = {3.0};
  const std::vector<Epoch> epochs = run_drive(drive, dead_reckoning(), {});
  EXPECT_TRUE(epochs[2].valid);
  EXPECT_FALSE(epochs[3].valid);
  EXPECT_TRUE(epochs[5].valid);
}

TEST(RunDrive, AnEpochKnowsNothingThatArrivesLater) {
  Drive drive = straight_drive(4);
  drive.measurements = {fix(1.0, 2.5)};
  const std::vector<Epoch> epochs = run_drive(drive, dead_reckoning(), {});
  EXPECT_FALSE(epochs[2].valid);
  EXPECT_TRUE(epochs[3].valid);
}

TEST(RunDrive, CarriesTheEstimateToTruthBetweenOdometry) {
  Drive drive = straight_drive(3);
  drive.truth = {{2.25, {2.25, 0.0, 0.0}, true, std::nullopt}, {9.0, {9.0, 0.0, 0.0}, true, std::nullopt}};
  drive.measurements = {fix(1.0, 1.0)};
  const std::vector<Epoch> epochs = run_drive(drive, dead_reckoning(), {});
  EXPECT_NEAR(epochs[0].estimate.x, 2.25, 1e-12);
  EXPECT_FALSE(epochs[1].valid) << "six seconds after the last odometry";
}

TEST(RunDrive, AKnownStartWithoutHeadingIsTheDirectionOfTravel) {
  Drive drive = straight_drive(3);
  for (TruthSample& sample : drive.truth) {
    sample.has_yaw = false;
    sample.base_in_map = {0.0, sample.base_in_map.x, 0.0};
  }
  RunSettings settings;
  settings.known_start = true;
  const std::vector<Epoch> epochs = run_drive(drive, dead_reckoning(), settings);
  EXPECT_NEAR(epochs.back().estimate.y, 3.0, 1e-12);
  EXPECT_NEAR(epochs.back().estimate.yaw, 0.5 * kPi, 1e-12);
}

TEST(RunDrive, RefusesAKnownStartThatTruthDoesNotTell) {
  RunSettings settings;
  settings.known_start = true;
  Drive standing = straight_drive(3);
  for (TruthSample& sample : standing.truth) sample = {sample.stamp, {}, false, std::nullopt};
  EXPECT_THROW(run_drive(standing, dead_reckoning(), settings), RunError);
  Drive without_truth = straight_drive(3);
  without_truth.truth.clear();
  EXPECT_THROW(run_drive(without_truth, dead_reckoning(), settings), RunError);
}

TEST(EpochOf, RefusesAnEstimateThatIsNotFinite) {
  PoseEstimate estimate;
  estimate.valid = true;
  estimate.pose.x = std::numeric_limits<double>::quiet_NaN();
  const OdometryIncrement last{1.0, 1.0, 0.0, 0.0};
  EXPECT_THROW(epoch_of(estimate, {1.0, {}, false, std::nullopt}, last), RunError);
  estimate.valid = false;
  EXPECT_FALSE(epoch_of(estimate, {1.0, {}, false, std::nullopt}, last).valid);
}

}  // namespace
}  // namespace multipath_localization
