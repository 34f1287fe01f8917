#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <limits>
#include <numeric>

#include "multipath_localization/estimators/multipath_particle_filter.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;
constexpr int kStepsPerFix = 10;

/// A robot on a winding way whose odometer is 1 % and 0.2 deg/s off; fixes of 0.3 m, moved by `bias`.
class Drive {
 public:
  Pose2 truth{20.0, -5.0, 2.5};
  Eigen::Vector2d antenna = Eigen::Vector2d(0.4, 0.1);
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();
  double speed = 1.5;
  double time = 100.0;
  double squared_error = 0.0;  ///< summed over the fixes
  double squared_fix_error = 0.0;
  int fixes = 0;

  void run(Estimator& filter, double duration) {
    squared_error = squared_fix_error = 0.0;
    fixes = 0;
    for (long i = 1; i <= std::lround(duration / kStep); ++i) {
      time += kStep;
      const OdometryIncrement moved{time, kStep, speed, speed == 0.0 ? 0.0 : 0.4 * std::sin(0.2 * time)};
      truth = truth * displacement(moved);
      OdometryIncrement measured = moved;
      measured.speed *= 1.01;
      if (speed != 0.0) measured.yaw_rate += 0.0035;
      filter.predict(measured);
      if (i % kStepsPerFix == 0) give_fix(filter);
    }
  }

  [[nodiscard]] double rmse() const { return std::sqrt(squared_error / fixes); }
  [[nodiscard]] double fix_rmse() const { return std::sqrt(squared_fix_error / fixes); }

  GnssFix fix() {
    RandomStream random(7, step_++, 0);
    GnssFix fix;
    fix.stamp = time;
    fix.antenna_in_base = antenna;
    fix.position = truth * antenna + bias + 0.3 * Eigen::Vector2d(random.normal(), random.normal());
    fix.covariance = 0.09 * Eigen::Matrix2d::Identity();
    return fix;
  }

 private:
  void give_fix(Estimator& filter) {
    const GnssFix measured = fix();
    filter.update(measured);
    squared_error += (filter.estimate().pose.position() - truth.position()).squaredNorm();
    squared_fix_error += (measured.position - truth * antenna).squaredNorm();
    ++fixes;
  }

  std::uint32_t step_ = 0;
};

TEST(MultipathParticleFilter, FindsPositionAndHeadingUnderOpenSky) {
  MultipathParticleFilter filter(MultipathParticleFilterParameters{}, 1);
  filter.start(std::nullopt);
  EXPECT_FALSE(filter.estimate().valid);
  Drive drive;
  drive.run(filter, 60.0);
  drive.run(filter, 60.0);
  EXPECT_LT(drive.rmse(), 0.4);
  EXPECT_NEAR(angle_difference(filter.estimate().pose.yaw, drive.truth.yaw), 0.0, 0.1);
  EXPECT_TRUE(filter.estimate().valid);
  EXPECT_TRUE(filter.estimate().aligned);
  EXPECT_LT(filter.estimate().canyon_probability, 0.5);
}

TEST(MultipathParticleFilter, HoldsThePositionWhenTheFixIsBiased) {
  MultipathParticleFilter filter(MultipathParticleFilterParameters{}, 1);
  filter.start(std::nullopt);
  Drive drive;
  drive.run(filter, 90.0);
  drive.bias = {4.0, -4.0};
  drive.run(filter, 30.0);
  EXPECT_GT(drive.fix_rmse(), 5.0);
  EXPECT_LT(drive.rmse(), 0.3 * drive.fix_rmse());
  EXPECT_GT(filter.estimate().shadow_probability, 0.5);
  EXPECT_LT((filter.estimate().bias - drive.bias).norm(), 2.0);
  drive.bias.setZero();
  drive.run(filter, 30.0);
  drive.run(filter, 10.0);
  EXPECT_LT(drive.rmse(), 0.5);
}

TEST(MultipathParticleFilter, SameSeedGivesTheSameBytesAndAnotherDoesNot) {
  const auto end = [](std::uint64_t seed) {
    MultipathParticleFilter filter(MultipathParticleFilterParameters{}, seed);
    filter.start(std::nullopt);
    Drive drive;
    drive.run(filter, 15.0);
    return filter.estimate().pose;
  };
  EXPECT_EQ(end(3).x, end(3).x);
  EXPECT_EQ(end(3).yaw, end(3).yaw);
  EXPECT_NE(end(3).x, end(4).x);
}

TEST(MultipathParticleFilter, StartsAgainFromNothing) {
  MultipathParticleFilter filter(MultipathParticleFilterParameters{}, 1);
  filter.start(std::nullopt);
  Drive first;
  first.run(filter, 15.0);
  const double once = filter.estimate().pose.x;
  filter.start(std::nullopt);
  EXPECT_FALSE(filter.estimate().valid);
  EXPECT_TRUE(filter.hypotheses().empty());
  Drive second;
  second.run(filter, 15.0);
  EXPECT_EQ(filter.estimate().pose.x, once);
}

TEST(MultipathParticleFilter, APriorIsBelieved) {
  MultipathParticleFilter filter(MultipathParticleFilterParameters{}, 1);
  Drive drive;
  PosePrior prior;
  prior.stamp = drive.time;
  prior.pose = drive.truth;
  prior.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  filter.start(prior);
  EXPECT_TRUE(filter.estimate().valid);
  drive.run(filter, 5.0);
  EXPECT_LT(drive.rmse(), 0.3);
}

TEST(MultipathParticleFilter, HypothesesAreThePartsOfTheEstimate) {
  MultipathParticleFilter filter(MultipathParticleFilterParameters{}, 1);
  filter.start(std::nullopt);
  Drive drive;
  drive.run(filter, 20.0);
  const std::vector<Hypothesis> all = filter.hypotheses();
  EXPECT_EQ(all.size(), static_cast<std::size_t>(MultipathParticleFilterParameters{}.particles));
  double sum = 0.0;
  for (const Hypothesis& hypothesis : all) {
    EXPECT_TRUE(hypothesis.pose.finite());
    sum += hypothesis.weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(MultipathParticleFilter, BadFixesAreRefusedAndChangeNothing) {
  MultipathParticleFilter filter(MultipathParticleFilterParameters{}, 1);
  filter.start(std::nullopt);
  Drive drive;
  drive.run(filter, 10.0);
  const PoseEstimate before = filter.estimate();
  GnssFix not_a_number = drive.fix();
  not_a_number.position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(filter.update(not_a_number).reason, Reason::kNotFinite);
  GnssFix huge = drive.fix();
  huge.position.y() = 1e308;
  EXPECT_EQ(filter.update(huge).reason, Reason::kInvalidPosition);
  GnssFix negative = drive.fix();
  negative.covariance(0, 0) = -1.0;
  EXPECT_EQ(filter.update(negative).reason, Reason::kInvalidCovariance);
  EXPECT_EQ(filter.estimate().pose.x, before.pose.x);
  EXPECT_EQ(filter.estimate().covariance, before.covariance);
}

TEST(MultipathParticleFilter, ParkedUnderABiasItNeitherWandersNorGrowsSurer) {
  MultipathParticleFilter filter(MultipathParticleFilterParameters{}, 1);
  filter.start(std::nullopt);
  Drive drive;
  drive.run(filter, 90.0);
  drive.bias = {3.0, 0.0};
  drive.run(filter, 5.0);
  drive.speed = 0.0;
  drive.run(filter, 1.0);
  const Pose2 parked = filter.estimate().pose;
  drive.run(filter, 300.0);
  EXPECT_LT((filter.estimate().pose.position() - parked.position()).norm(), 1.5);
  EXPECT_NEAR(angle_difference(filter.estimate().pose.yaw, parked.yaw), 0.0, 0.1);
}

TEST(MultipathParticleFilter, CovarianceStaysPositiveAndEverythingFiniteThroughAnOutage) {
  MultipathParticleFilter filter(MultipathParticleFilterParameters{}, 1);
  filter.start(std::nullopt);
  Drive drive;
  drive.run(filter, 60.0);
  const double sigma = std::sqrt(filter.estimate().covariance.trace());
  for (int i = 0; i < 3000; ++i) filter.predict({drive.time + 0.02 * (i + 1), 0.02, 1.5, 0.1});
  const PoseEstimate estimate = filter.estimate();
  EXPECT_TRUE(estimate.pose.finite());
  EXPECT_EQ(estimate.covariance.llt().info(), Eigen::Success);
  EXPECT_GT(std::sqrt(estimate.covariance.trace()), sigma);
}

TEST(MultipathParticleFilter, DescriptionOfItsParametersLoads) {
  MultipathParticleFilterParameters parameters;
  EXPECT_NO_THROW(load(YAML::Load(describe(parameters)), parameters));
}

}  // namespace
}  // namespace multipath_localization
