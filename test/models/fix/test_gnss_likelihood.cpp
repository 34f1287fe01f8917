#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "models/fix/gnss_likelihood.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {
namespace {

struct Value {
  double log_likelihood;
  double shadow_share;
};

/// The likelihood at one pose of a block of copies of it.
template <class Setting>
Value weighed(InstructionSet set, const Setting& setting, const GnssFix& fix, const Pose2& pose,
              const std::optional<double>& heading) {
  BlockValues x;
  BlockValues y;
  BlockValues yaw;
  BlockValues log_weight{};
  BlockValues factor{};
  std::array<float, kBlockSize> share{};
  x.fill(pose.x);
  y.fill(pose.y);
  yaw.fill(pose.yaw);
  const GnssLikelihood likelihood(setting.parameters, fix, setting.shadow_weight, setting.ring, heading);
  likelihood.add_to(set, {x.data(), y.data(), yaw.data(), kBlockSize}, log_weight.data(), factor.data(),
                    share.data());
  return {log_weight[7] + std::log(factor[7]), share[7]};
}

/// By the errors of Eqs. (28)-(30), the same on each instruction set.
struct Likelihood {
  GnssLikelihoodParameters parameters;
  double shadow_weight;
  ShadowRing ring;

  Value operator()(const Eigen::Vector2d& error, const std::optional<double>& heading_error) const {
    GnssFix fix;
    fix.covariance.setZero();
    const Pose2 pose{error.x(), error.y(), heading_error.value_or(0.0)};
    const auto heading = heading_error ? std::optional<double>(0.0) : std::nullopt;
    const Value plain = weighed(InstructionSet::kPlain, *this, fix, pose, heading);
    const Value best = weighed(best_instruction_set(), *this, fix, pose, heading);
    EXPECT_NEAR(plain.log_likelihood, best.log_likelihood,
                1e-9 * std::max(1.0, std::abs(plain.log_likelihood)));
    EXPECT_NEAR(plain.shadow_share, best.shadow_share, 1e-6);
    return best;
  }
};

ShadowRing round_the_fix(double radius) { return {Eigen::Vector2d::Zero(), radius}; }

GnssLikelihoodParameters printed() {
  GnssLikelihoodParameters parameters;
  parameters.use_declared_covariance = false;
  parameters.likelihood_kernel = LikelihoodKernel::kCross;
  return parameters;
}

/// Eqs. (27) and (31) typed from the page.
double printed_direct(double dx, double dy, double dtheta) {
  const double sb2 = 0.0025;
  const double sp2 = 0.01;
  return 2.0 / 3.0 / (2.0 * kPi * sb2) *
             (std::exp(-dx * dx / (2.0 * sb2)) + std::exp(-dy * dy / (2.0 * sb2))) +
         1.0 / 3.0 / (2.0 * kPi * sp2) * std::exp(-dtheta * dtheta / (2.0 * sp2));
}

double printed_shadow(double dxy, double dtheta) {
  const double ss2 = 0.1;
  const double sp2 = 0.01;
  return 2.0 / 3.0 / (2.0 * kPi * ss2) * std::exp(-dxy * dxy / (2.0 * ss2)) +
         1.0 / 3.0 / (2.0 * kPi * sp2) * std::exp(-dtheta * dtheta / (2.0 * sp2));
}

TEST(GnssLikelihood, IsEquation33AsPrinted) {
  const Likelihood likelihood{printed(), 0.5, round_the_fix(1.5)};
  for (const Eigen::Vector2d& error : {Eigen::Vector2d(0.01, -0.08), Eigen::Vector2d(1.1, 1.2)}) {
    for (const double dtheta : {0.0, 0.15}) {
      const double direct = 0.5 * printed_direct(error.x(), error.y(), dtheta);
      const double shadow = 0.5 * printed_shadow(error.norm() - 1.5, dtheta);
      const auto value = likelihood(error, dtheta);
      EXPECT_NEAR(std::exp(value.log_likelihood) / (direct + shadow), 1.0, 1e-9);
      EXPECT_NEAR(value.shadow_share, shadow / (direct + shadow), 1e-6);
    }
  }
}

TEST(GnssLikelihood, WithoutShadowIsEquation47) {
  const Likelihood likelihood{printed(), 0.0, round_the_fix(1.5)};
  const auto value = likelihood({0.02, 0.03}, 0.05);
  EXPECT_NEAR(std::exp(value.log_likelihood) / printed_direct(0.02, 0.03, 0.05), 1.0, 1e-9);
  EXPECT_EQ(value.shadow_share, 0.0);
}

TEST(GnssLikelihood, ProductKernelDependsOnTheDistanceAlone) {
  GnssLikelihoodParameters parameters = printed();
  parameters.likelihood_kernel = LikelihoodKernel::kProduct;
  const Likelihood product{parameters, 0.0, {}};
  EXPECT_NEAR(product({0.1, 0.0}, {}).log_likelihood, product({0.06, 0.08}, {}).log_likelihood, 1e-12);
  const Likelihood cross{printed(), 0.0, {}};
  EXPECT_GT(cross({0.1, 0.0}, {}).log_likelihood, cross({0.06, 0.08}, {}).log_likelihood + 0.3);
}

TEST(GnssLikelihood, TellsDistancesApartWhereItsValueUnderflows) {
  GnssLikelihoodParameters parameters = printed();
  parameters.likelihood_kernel = LikelihoodKernel::kProduct;
  const Likelihood likelihood{parameters, 0.5, {}};
  const double near = likelihood({200.0, 0.0}, {}).log_likelihood;
  const double far = likelihood({201.0, 0.0}, {}).log_likelihood;
  EXPECT_LT(near, -1000.0);
  EXPECT_GT(near, far + 100.0);
  EXPECT_TRUE(std::isfinite(likelihood({1e9, 1e9}, 3.0).log_likelihood));
}

TEST(GnssLikelihood, RingIsWhereTheFixIsBiasedByItsRadius) {
  const Likelihood likelihood{printed(), 0.5, round_the_fix(3.0)};
  const Eigen::Vector2d on_ring(1.8, 2.4);
  EXPECT_GT(likelihood(on_ring, {}).log_likelihood, likelihood(0.8 * on_ring, {}).log_likelihood);
  EXPECT_GT(likelihood(on_ring, {}).log_likelihood, likelihood(1.2 * on_ring, {}).log_likelihood);
  EXPECT_GT(likelihood(on_ring, {}).shadow_share, 0.99);
  EXPECT_LT(likelihood(Eigen::Vector2d::Zero(), {}).shadow_share, 0.01);
}

TEST(GnssLikelihood, RingWithoutRadiusIsWhereTheBiasComesFrom) {
  const Likelihood likelihood{printed(), 0.5, {{3.0, -4.0}, 0.0}};
  const double there = likelihood({-3.0, 4.0}, {}).log_likelihood;
  for (const Eigen::Vector2d& elsewhere : {Eigen::Vector2d(3.0, -4.0), Eigen::Vector2d(-4.0, -3.0)}) {
    EXPECT_GT(there, likelihood(elsewhere, {}).log_likelihood + 100.0);
  }
}

TEST(GnssLikelihood, LeverArmIsTurnedWithTheRobot) {
  GnssFix fix;
  fix.antenna_in_base = {2.0, 0.5};
  const Likelihood likelihood{printed(), 0.5, round_the_fix(1.5)};
  for (const InstructionSet set : {InstructionSet::kPlain, best_instruction_set()}) {
    const Pose2 pose{0.3, -0.2, 2.2};
    const auto value = weighed(set, likelihood, fix, pose, {});
    const auto expected = likelihood(pose * fix.antenna_in_base, {});
    EXPECT_NEAR(value.log_likelihood, expected.log_likelihood, 1e-8 * std::abs(expected.log_likelihood));
  }
}

TEST(GnssLikelihood, WorksOnTheParticlesOfTheBlockAloneAndAdds) {
  std::array<double, 3> x = {0.0, 1.0, 2.0};
  std::array<double, 3> y = x;
  std::array<double, 3> yaw{};
  std::array<double, 3> log_weight = {-5.0, -6.0, -7.0};
  std::array<double, 3> factor = {8.0, 8.0, 8.0};
  std::array<float, 3> share = {9.0F, 9.0F, 9.0F};
  const GnssLikelihood likelihood(printed(), GnssFix(), 0.5, {}, std::nullopt);
  likelihood.add_to(best_instruction_set(), {x.data(), y.data(), yaw.data(), 2}, log_weight.data(),
                    factor.data(), share.data());
  const Likelihood alone{printed(), 0.5, {}};
  EXPECT_NEAR(log_weight[0] + std::log(factor[0]), -5.0 + alone({0.0, 0.0}, {}).log_likelihood, 1e-9);
  EXPECT_NEAR(log_weight[1] + std::log(factor[1]), -6.0 + alone({1.0, 1.0}, {}).log_likelihood, 1e-9);
  EXPECT_EQ(log_weight[2], -7.0);
  EXPECT_EQ(factor[2], 8.0);
  EXPECT_EQ(share[2], 9.0F);
}

TEST(FixSigmas, DeclaredCovarianceRaisesThemButNeverLowersThem) {
  GnssLikelihoodParameters parameters;
  GnssFix fix;
  fix.covariance = 4.0 * Eigen::Matrix2d::Identity();
  EXPECT_NEAR(fix_sigmas(parameters, fix).direct, 2.0, 1e-12);
  EXPECT_NEAR(fix_sigmas(parameters, fix).shadow, 2.0, 1e-12);
  parameters.use_declared_covariance = false;
  EXPECT_EQ(fix_sigmas(parameters, fix).direct, parameters.sigma_b);
  parameters.use_declared_covariance = true;
  fix.covariance.setZero();
  EXPECT_EQ(fix_sigmas(parameters, fix).direct, parameters.sigma_b);
  EXPECT_EQ(fix_sigmas(parameters, fix).shadow, parameters.sigma_s);
}

}  // namespace
}  // namespace multipath_localization
