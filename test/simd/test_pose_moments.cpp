#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <vector>

#include "filters/particle_set.hpp"
#include "multipath_localization/core/random.hpp"
#include "simd/pose_moments.hpp"

namespace multipath_localization {
namespace {

/// The sums of a set of poses, all of them members, on each instruction set in turn.
PoseSums sums_of(InstructionSet set, ParticleSet particles, const std::vector<double>& weights,
                 const Pose2& reference) {
  PoseSums sums;
  const std::vector<float> member(kBlockSize, 1.0F);
  for (std::size_t first = 0; first < particles.size(); first += kBlockSize) {
    const PoseBlock block{&particles.x[first], &particles.y[first], &particles.yaw[first],
                          std::min(kBlockSize, particles.size() - first)};
    sums.add(1.0, pose_sums(set, block, &weights[first], member.data(), reference));
  }
  return sums;
}

TEST(PoseMoments, AreThoseOfThePlainReferenceAndDoNotDependOnTheCutOfTheCircle) {
  for (const InstructionSet set : {InstructionSet::kPlain, best_instruction_set()}) {
    for (const double yaw : {0.0, 1.0, kPi, -3.0}) {
      ParticleSet particles(700);
      std::vector<double> weights(700);
      for (std::uint32_t i = 0; i < 700; ++i) {
        RandomStream random(1, 0, i);
        particles.set_pose(
            i, {100.0 + random.normal(), random.normal(), wrap_angle(yaw + 0.3 * random.normal())});
        weights[i] = random.uniform() / 350.0;
      }
      const PoseMoments expected = moments(particles, weights);
      const Pose2 reference{99.0, 0.5, wrap_angle(yaw - 0.2)};
      const PoseSums sums = sums_of(set, particles, weights, reference);
      const PoseMoments result = member_moments(sums, reference);
      EXPECT_NEAR(result.mean.x, expected.mean.x, 1e-9);
      EXPECT_NEAR(result.mean.y, expected.mean.y, 1e-9);
      EXPECT_NEAR(angle_difference(result.mean.yaw, expected.mean.yaw), 0.0, 1e-9);
      EXPECT_TRUE(result.covariance.isApprox(expected.covariance, 1e-8));
      const Eigen::Vector2d centre(101.0, 1.0);
      const Eigen::Vector2d off = expected.mean.position() - centre;
      const Eigen::Matrix2d about = expected.covariance.topLeftCorner<2, 2>() + off * off.transpose();
      EXPECT_TRUE(position_spread(sums, reference, centre).isApprox(about, 1e-8));
    }
  }
}

TEST(PoseMoments, MembersLieWithinDistanceAndTurnAcrossTheCut) {
  std::vector<double> x = {0.0, 1.9, 2.1, 0.0, 0.0};
  std::vector<double> y(5, 0.0);
  std::vector<double> yaw = {3.1, 3.1, 3.1, -3.1, -2.0};
  const std::vector<float> expected = {1.0F, 1.0F, 0.0F, 1.0F, 0.0F};
  for (const InstructionSet set : {InstructionSet::kPlain, best_instruction_set()}) {
    std::vector<float> member(5, 7.0F);
    mark_members(set, {x.data(), y.data(), yaw.data(), 5}, {{0.0, 0.0, 3.1}, 2.0, 0.6}, member.data());
    EXPECT_EQ(member, expected);
  }
}

}  // namespace
}  // namespace multipath_localization
