#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "estimators/nishida/conventional_particle_filter.hpp"
#include "estimators/nishida/fix_particle_filter.hpp"
#include "estimators/nishida/nishida_particle_filter.hpp"
#include "simd/instruction_set.hpp"
#include "winding_drive.hpp"

namespace multipath_localization {
namespace {

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

TEST(FixParticleFilter, RingSupposesOpenSky) {
  NishidaParticleFilterParameters parameters;
  parameters.bias.sky = Sky::kScatter;
  parameters.bias.bias_motion = BiasMotion::kWalk;
  parameters.ring.ring_fraction = 0.5;
  parameters.ess_threshold = 0.0;
  parameters.likelihood.sigma_s = 2.0;
  WindingDrive drive(17);
  FixParticleFilter filter(parameters, 17);
  filter.start(prior_at(drive.truth));
  drive.run(filter, 2.0);
  EXPECT_LT(filter.estimate().shadow_probability, 0.01);
  drive.run(filter, 1.0, {5.0, 5.0});
  EXPECT_GT(filter.estimate().shadow_probability, 0.99);
  EXPECT_GT(filter.estimate().bias.norm(), 2.5);
  const auto particles = filter.hypotheses();
  EXPECT_EQ(std::count_if(particles.begin(), particles.end(),
                          [&](const Hypothesis& p) {
                            return (p.pose.position() - drive.truth.position()).norm() > 2.0;
                          }),
            0);
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
