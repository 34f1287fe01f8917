#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

#include "estimators/nishida/conventional_particle_filter.hpp"
#include "estimators/nishida/fix_particle_filter.hpp"
#include "estimators/nishida/nishida_particle_filter.hpp"
#include "winding_drive.hpp"

namespace multipath_localization {
namespace {

/// Fewer particles, for the tests in which the number does not matter.
template <class Parameters>
Parameters small() {
  Parameters parameters;
  parameters.sampling.min_particles = parameters.sampling.max_particles = 200;
  return parameters;
}

template <class Parameters>
class ParticleFilters : public ::testing::Test {};
using Both = ::testing::Types<NishidaParticleFilterParameters, ConventionalParticleFilterParameters>;
TYPED_TEST_SUITE(ParticleFilters, Both);

TYPED_TEST(ParticleFilters, FindPoseAndHeadingUnderOpenSkyFromNothing) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    WindingDrive drive(seed);
    FixParticleFilter filter(TypeParam{}, seed);
    filter.start(std::nullopt);
    drive.run(filter, 30.0);
    const PoseEstimate estimate = filter.estimate();
    EXPECT_TRUE(estimate.aligned);
    EXPECT_LT(drive.error(filter), 1.0);
    EXPECT_LT(std::abs(angle_difference(estimate.pose.yaw, drive.truth.yaw)), 0.3);
  }
}

TYPED_TEST(ParticleFilters, FindTheirHeadingInReverse) {
  WindingDrive drive(4);
  drive.speed = -2.0;
  FixParticleFilter filter(TypeParam{}, 4);
  filter.start(std::nullopt);
  drive.run(filter, 30.0);
  EXPECT_LT(std::abs(angle_difference(filter.estimate().pose.yaw, drive.truth.yaw)), 0.3);
  EXPECT_LT(drive.error(filter), 1.0);
}

TYPED_TEST(ParticleFilters, StartUnknownAndSayNothingBeforeTheFirstFix) {
  WindingDrive drive(5);
  FixParticleFilter filter(TypeParam{}, 5);
  filter.start(std::nullopt);
  filter.predict(drive.next());
  EXPECT_FALSE(filter.estimate().valid);
  EXPECT_TRUE(filter.hypotheses().empty());
  EXPECT_EQ(filter.update(drive.fix()).reason, Reason::kAccepted);
  const PoseEstimate estimate = filter.estimate();
  EXPECT_TRUE(estimate.valid);
  EXPECT_FALSE(estimate.aligned);
  EXPECT_LT(estimate.dominance, 0.5);
}

TYPED_TEST(ParticleFilters, StartAtThePrior) {
  FixParticleFilter filter(TypeParam{}, 6);
  filter.start(prior_at({10.0, 20.0, -3.1}));
  const PoseEstimate estimate = filter.estimate();
  EXPECT_TRUE(estimate.valid);
  EXPECT_TRUE(estimate.aligned);
  EXPECT_NEAR(estimate.pose.x, 10.0, 0.05);
  EXPECT_NEAR(angle_difference(estimate.pose.yaw, -3.1), 0.0, 0.02);
  EXPECT_NEAR(estimate.covariance(0, 0), 0.04 + 0.01, 0.01);
}

TYPED_TEST(ParticleFilters, SameSeedSameBytes) {
  std::vector<Hypothesis> first;
  for (const std::uint64_t seed : {7U, 7U, 8U}) {
    WindingDrive drive(1);
    FixParticleFilter filter(small<TypeParam>(), seed);
    filter.start(std::nullopt);
    drive.run(filter, 4.0);
    const auto particles = filter.hypotheses();
    if (first.empty()) first = particles;
    const bool equal =
        std::equal(first.begin(), first.end(), particles.begin(), [](const auto& a, const auto& b) {
          return a.pose.x == b.pose.x && a.pose.y == b.pose.y && a.pose.yaw == b.pose.yaw &&
                 a.weight == b.weight;
        });
    EXPECT_EQ(equal, seed == 7U);
  }
}

TYPED_TEST(ParticleFilters, RestartRepeatsTheFirstRun) {
  FixParticleFilter filter(small<TypeParam>(), 9);
  std::vector<double> ends;
  for (int run = 0; run < 2; ++run) {
    WindingDrive drive(2);
    filter.start(std::nullopt);
    drive.run(filter, 4.0);
    ends.push_back(filter.estimate().pose.x);
  }
  EXPECT_EQ(ends[0], ends[1]);
}

TYPED_TEST(ParticleFilters, DefectiveFixesAreRefusedAndChangeNothing) {
  WindingDrive drive(10);
  FixParticleFilter filter(small<TypeParam>(), 10);
  filter.start(std::nullopt);
  drive.run(filter, 5.0);
  const GnssFix sound = drive.fix();
  ASSERT_TRUE(filter.update(sound).accepted());
  const PoseEstimate before = filter.estimate();
  const auto expect_refused = [&](Reason reason, const std::function<void(GnssFix&)>& spoil) {
    GnssFix fix = sound;
    fix.position.x() += 1.0;
    spoil(fix);
    EXPECT_EQ(filter.update(fix).reason, reason);
    EXPECT_EQ(filter.estimate().pose.x, before.pose.x);
    EXPECT_EQ(filter.estimate().pose.yaw, before.pose.yaw);
    EXPECT_EQ(filter.estimate().covariance, before.covariance);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(Reason::kNotFinite, [&](GnssFix& f) { f.position.y() = nan; });
  expect_refused(Reason::kInvalidPosition, [](GnssFix& f) { f.position.y() = 1e308; });
  expect_refused(Reason::kInvalidCovariance, [](GnssFix& f) { f.covariance(0, 0) = -1.0; });
  expect_refused(Reason::kFrozen, [&](GnssFix& f) { f = sound; });
}

TYPED_TEST(ParticleFilters, ParkedRobotsDoNotDiffuse) {
  WindingDrive drive(11);
  FixParticleFilter filter(small<TypeParam>(), 11);
  filter.start(std::nullopt);
  drive.run(filter, 10.0);
  const PoseEstimate before = filter.estimate();
  for (int i = 1; i <= 500; ++i) filter.predict({drive.time + kStep * i, kStep, 0.0, 0.0});
  EXPECT_EQ(filter.estimate().covariance, before.covariance);
  EXPECT_EQ(filter.estimate().pose.yaw, before.pose.yaw);
}

TYPED_TEST(ParticleFilters, OffsetThatPersistsIsAcceptedAndLeavesASoundEstimate) {
  WindingDrive drive(12);
  FixParticleFilter filter(small<TypeParam>(), 12);
  filter.start(std::nullopt);
  drive.run(filter, 20.0);
  const Eigen::Vector2d offset(0.0, 20.0);
  drive.run(filter, 20.0, offset);
  EXPECT_TRUE(drive.last.accepted());
  EXPECT_TRUE(filter.estimate().pose.finite());
  EXPECT_GT(filter.estimate().covariance.llt().matrixL().determinant(), 0.0);
}

TYPED_TEST(ParticleFilters, HypothesesSumToOneAndAreCapped) {
  TypeParam parameters;
  parameters.sampling.min_particles = parameters.sampling.max_particles = 4500;
  WindingDrive drive(13);
  FixParticleFilter filter(parameters, 13);
  filter.start(std::nullopt);
  drive.run(filter, 1.0);
  const auto all = filter.hypotheses();
  EXPECT_LE(all.size(), 2000U);
  EXPECT_GT(all.size(), 1000U);
  EXPECT_NEAR(
      std::accumulate(all.begin(), all.end(), 0.0, [](double s, const auto& h) { return s + h.weight; }), 1.0,
      1e-9);
}

TYPED_TEST(ParticleFilters, EveryOptionStaysFiniteThroughABiasedDrive) {
  for (LikelihoodKernel kernel : {LikelihoodKernel::kProduct, LikelihoodKernel::kCross}) {
    for (FixHeadingSource heading :
         {FixHeadingSource::kOff, FixHeadingSource::kChord, FixHeadingSource::kPrinted}) {
      for (PropagateFrom source : {PropagateFrom::kParticles, PropagateFrom::kEstimate}) {
        TypeParam parameters;
        parameters.sampling.min_particles = parameters.sampling.max_particles = 60;
        parameters.likelihood.likelihood_kernel = kernel;
        parameters.heading.fix_heading = heading;
        parameters.heading.fix_heading_distance = 0.0;
        parameters.propagate_from = source;
        parameters.point_estimate = PointEstimate::kMean;
        parameters.ring.ring_weight = RingWeight::kPrinted;
        parameters.motion.noise_scale = 1.0;
        WindingDrive drive(14);
        FixParticleFilter filter(parameters, 14);
        filter.start(prior_at(drive.truth));
        drive.run(filter, 5.0);
        drive.run(filter, 5.0, {5000.0, 0.0});
        EXPECT_TRUE(filter.estimate().pose.finite());
        EXPECT_TRUE(filter.estimate().covariance.allFinite());
      }
    }
  }
}

}  // namespace
}  // namespace multipath_localization
