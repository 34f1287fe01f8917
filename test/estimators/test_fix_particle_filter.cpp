#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "multipath_localization/estimators/conventional_particle_filter.hpp"
#include "multipath_localization/estimators/fix_particle_filter.hpp"
#include "multipath_localization/estimators/nishida_particle_filter.hpp"
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

PosePrior prior_at(const Pose2& pose) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = Eigen::Vector3d(0.04, 0.04, 0.0025).asDiagonal();
  return prior;
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
  for (const char* kernel : {"product", "cross"}) {
    for (const char* heading : {"off", "chord", "printed"}) {
      for (const char* source : {"particles", "estimate"}) {
        TypeParam parameters;
        parameters.sampling.min_particles = parameters.sampling.max_particles = 60;
        parameters.likelihood.likelihood_kernel = kernel;
        parameters.heading.fix_heading = heading;
        parameters.heading.fix_heading_distance = 0.0;
        parameters.propagate_from = source;
        parameters.point_estimate = "mean";
        parameters.ring.ring_weight = "printed";
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

TEST(FixParticleFilter, WithoutRingAndShadowTheMethodIsTheConventionalFilter) {
  const ConventionalParticleFilterParameters plain;
  NishidaParticleFilterParameters nishida;
  nishida.likelihood = plain.likelihood;
  nishida.motion = plain.motion;
  nishida.ring.ring_fraction = 0.0;
  nishida.ring.shadow_weight = 0.0;
  FixParticleFilter stripped(nishida, 15);
  FixParticleFilter conventional(plain, 15);
  for (FixParticleFilter* filter : {&stripped, &conventional}) {
    WindingDrive drive(15);
    filter->start(std::nullopt);
    drive.run(*filter, 4.0);
  }
  EXPECT_EQ(stripped.estimate().pose.x, conventional.estimate().pose.x);
  EXPECT_EQ(stripped.estimate().pose.yaw, conventional.estimate().pose.yaw);
  EXPECT_EQ(stripped.estimate().covariance, conventional.estimate().covariance);
}

TEST(FixParticleFilter, ShadowProbabilityAndBiasTellABiasedFix) {
  WindingDrive drive(16);
  FixParticleFilter filter(NishidaParticleFilterParameters{}, 16);
  filter.start(prior_at(drive.truth));
  drive.run(filter, 10.0);
  drive.run(filter, 0.2, {2.8, -2.8});  // off the arms of the cross
  const PoseEstimate estimate = filter.estimate();
  EXPECT_GT(estimate.shadow_probability, 0.5);
  EXPECT_GT(estimate.bias.x(), 0.5);
  EXPECT_LT(estimate.bias.y(), -0.5);
  EXPECT_LT(estimate.bias.norm(), 5.0);
  EXPECT_LT(drive.error(filter), 2.5);  // of 4 m
}

TEST(FixParticleFilter, RingPutsParticlesAtTheRadiusOfTheBias) {
  NishidaParticleFilterParameters parameters;
  parameters.ring.ring_fraction = 0.5;
  parameters.ess_threshold = 0.0;
  WindingDrive drive(17);
  FixParticleFilter filter(parameters, 17);
  filter.start(prior_at(drive.truth));
  GnssFix fix = drive.fix();
  fix.position = drive.truth * fix.antenna_in_base + Eigen::Vector2d(4.0, 0.0);
  ASSERT_TRUE(filter.update(fix).accepted());
  int on_ring = 0;
  for (const Hypothesis& particle : filter.hypotheses()) {
    const double radius = (particle.pose.position() - drive.truth.position()).norm();
    if (std::abs(radius - 4.0) < 1.5) ++on_ring;
  }
  EXPECT_NEAR(on_ring, 500, 60);
}

TEST(FixParticleFilter, InnovationIsThatOfTheAntenna) {
  WindingDrive drive(18);
  FixParticleFilter filter(ConventionalParticleFilterParameters{}, 18);
  filter.start(prior_at(drive.truth));
  GnssFix fix = drive.fix();
  fix.antenna_in_base = {-8.0, 0.0};
  fix.position = drive.truth * fix.antenna_in_base + Eigen::Vector2d(0.5, 0.0);
  const Innovation result = filter.update(fix);
  EXPECT_NEAR(result.innovation.x(), 0.5, 0.1);
  EXPECT_NEAR(result.innovation.y(), 0.0, 0.1);
  EXPECT_GT(result.nis, 0.0);
  EXPECT_LT(result.nis, 9.0);
}

TEST(FixParticleFilter, ThreadsDoNotChangeTheResult) {
  std::vector<PoseEstimate> ends;
  for (const int threads : {1, 2}) {
    NishidaParticleFilterParameters parameters;
    parameters.sampling.min_particles = parameters.sampling.max_particles = 31000;
    parameters.threads = threads;
    parameters.ess_threshold = 31000.0;
    WindingDrive drive(19);
    FixParticleFilter filter(parameters, 19);
    filter.start(prior_at(drive.truth));
    drive.run(filter, 2.0);
    ends.push_back(filter.estimate());
  }
  EXPECT_EQ(ends[0].pose.x, ends[1].pose.x);
  EXPECT_EQ(ends[0].pose.yaw, ends[1].pose.yaw);
  EXPECT_EQ(ends[0].covariance, ends[1].covariance);
  EXPECT_EQ(ends[0].effective_sample_size, ends[1].effective_sample_size);
}

TEST(FixParticleFilter, PlainInstructionsGiveTheSameWithinRounding) {
  std::vector<Pose2> ends;
  for (const InstructionSet set : {InstructionSet::kPlain, best_instruction_set()}) {
    WindingDrive drive(20);
    FixParticleFilter filter(NishidaParticleFilterParameters{}, 20, set);
    filter.start(prior_at(drive.truth));
    drive.run(filter, 1.0);
    ends.push_back(filter.estimate().pose);
  }
  EXPECT_NEAR(ends[0].x, ends[1].x, 0.05);
  EXPECT_NEAR(ends[0].y, ends[1].y, 0.05);
  EXPECT_NEAR(ends[0].yaw, ends[1].yaw, 0.02);
}

TEST(FixParticleFilter, CountOfParticlesFollowsTheSpreadOfTheBelief) {
  ConventionalParticleFilterParameters parameters;
  parameters.sampling.min_particles = 100;
  parameters.sampling.max_particles = 1500;
  parameters.ess_threshold = 2000.0;
  WindingDrive drive(21);
  FixParticleFilter filter(parameters, 21);
  filter.start(std::nullopt);
  drive.run(filter, 0.2);
  EXPECT_GT(filter.hypotheses().size(), 1000U);  // headings all round the circle
  drive.run(filter, 30.0);
  EXPECT_LT(filter.hypotheses().size(), 900U);
  EXPECT_GE(filter.hypotheses().size(), 100U);
  EXPECT_LT(drive.error(filter), 1.0);
}

}  // namespace
}  // namespace multipath_localization
