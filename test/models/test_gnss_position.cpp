#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/gnss_position.hpp"

namespace multipath_localization {
namespace {

const Eigen::Matrix2d kUndeclared = Eigen::Matrix2d::Zero();

GnssLikelihoodParameters printed() {
  GnssLikelihoodParameters parameters;
  parameters.use_declared_covariance = false;
  parameters.likelihood_kernel = "cross";
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
  const GnssLikelihood likelihood(printed(), kUndeclared, 0.5, 1.5);
  for (const Eigen::Vector2d& error : {Eigen::Vector2d(0.01, -0.08), Eigen::Vector2d(1.1, 1.2)}) {
    for (const double dtheta : {0.0, 0.15}) {
      const double direct = 0.5 * printed_direct(error.x(), error.y(), dtheta);
      const double shadow = 0.5 * printed_shadow(error.norm() - 1.5, dtheta);
      const auto value = likelihood(error, dtheta);
      EXPECT_NEAR(std::exp(value.log_likelihood) / (direct + shadow), 1.0, 1e-9);
      EXPECT_NEAR(value.shadow_share, shadow / (direct + shadow), 1e-9);
    }
  }
}

TEST(GnssLikelihood, WithoutShadowIsEquation47) {
  const GnssLikelihood likelihood(printed(), kUndeclared, 0.0, 1.5);
  const auto value = likelihood({0.02, 0.03}, 0.05);
  EXPECT_NEAR(std::exp(value.log_likelihood), printed_direct(0.02, 0.03, 0.05), 1e-9);
  EXPECT_EQ(value.shadow_share, 0.0);
}

TEST(GnssLikelihood, ProductKernelDependsOnTheDistanceAlone) {
  GnssLikelihoodParameters parameters = printed();
  parameters.likelihood_kernel = "product";
  const GnssLikelihood product(parameters, kUndeclared, 0.0, 0.0);
  EXPECT_NEAR(product({0.1, 0.0}, {}).log_likelihood, product({0.06, 0.08}, {}).log_likelihood, 1e-12);
  const GnssLikelihood cross(printed(), kUndeclared, 0.0, 0.0);
  EXPECT_GT(cross({0.1, 0.0}, {}).log_likelihood, cross({0.06, 0.08}, {}).log_likelihood + 0.3);
}

TEST(GnssLikelihood, TellsDistancesApartWhereItsValueUnderflows) {
  GnssLikelihoodParameters parameters = printed();
  parameters.likelihood_kernel = "product";
  const GnssLikelihood likelihood(parameters, kUndeclared, 0.5, 0.0);
  const double near = likelihood({200.0, 0.0}, {}).log_likelihood;
  const double far = likelihood({201.0, 0.0}, {}).log_likelihood;
  EXPECT_LT(near, -1000.0);
  EXPECT_GT(near, far + 100.0);
  EXPECT_TRUE(std::isfinite(likelihood({1e9, 1e9}, 3.0).log_likelihood));
}

TEST(GnssLikelihood, RingIsWhereTheFixIsBiasedByItsRadius) {
  const GnssLikelihood likelihood(printed(), kUndeclared, 0.5, 3.0);
  const Eigen::Vector2d on_ring(1.8, 2.4);
  EXPECT_GT(likelihood(on_ring, {}).log_likelihood, likelihood(0.8 * on_ring, {}).log_likelihood);
  EXPECT_GT(likelihood(on_ring, {}).log_likelihood, likelihood(1.2 * on_ring, {}).log_likelihood);
  EXPECT_GT(likelihood(on_ring, {}).shadow_share, 0.99);
  EXPECT_LT(likelihood(Eigen::Vector2d::Zero(), {}).shadow_share, 0.01);
}

TEST(GnssLikelihood, DeclaredCovarianceRaisesSigmaButNeverLowersIt) {
  GnssLikelihoodParameters parameters;
  EXPECT_NEAR(GnssLikelihood(parameters, 4.0 * Eigen::Matrix2d::Identity(), 0.5, 0.0).sigma_b(), 2.0, 1e-12);
  EXPECT_NEAR(GnssLikelihood(parameters, 4.0 * Eigen::Matrix2d::Identity(), 0.5, 0.0).sigma_s(), 2.0, 1e-12);
  EXPECT_EQ(GnssLikelihood(parameters, kUndeclared, 0.5, 0.0).sigma_b(), parameters.sigma_b);
  parameters.use_declared_covariance = false;
  EXPECT_EQ(GnssLikelihood(parameters, 4.0 * Eigen::Matrix2d::Identity(), 0.5, 0.0).sigma_b(),
            parameters.sigma_b);
}

TEST(BelievedCovariance, HoldsPrincipalAxesBetweenFloorAndCap) {
  DeclaredCovarianceParameters parameters;
  parameters.fix_sigma_floor = 0.5;
  parameters.fix_sigma_cap = 10.0;
  const Eigen::Matrix2d turn = rotation(0.7);
  const Eigen::Matrix2d declared = turn * Eigen::Vector2d(1e-4, 1e6).asDiagonal() * turn.transpose();
  const Eigen::Matrix2d expected = turn * Eigen::Vector2d(0.25, 100.0).asDiagonal() * turn.transpose();
  EXPECT_TRUE(believed_covariance(declared, parameters).isApprox(expected, 1e-6));
  const Eigen::Matrix2d sound = turn * Eigen::Vector2d(1.0, 9.0).asDiagonal() * turn.transpose();
  EXPECT_TRUE(believed_covariance(sound, parameters).isApprox(sound, 1e-12));
}

TEST(BelievedCovariance, ZeroMeansUnknown) {
  const DeclaredCovarianceParameters parameters;
  EXPECT_TRUE(believed_covariance(kUndeclared, parameters).isApprox(9.0 * Eigen::Matrix2d::Identity()));
}

TEST(AntennaJacobian, EqualsCentralDifferences) {
  const Eigen::Vector2d antenna(-1.2, 0.4);
  const Pose2 pose{3.0, 4.0, 2.0};
  constexpr double kStep = 1e-6;
  const auto H = antenna_jacobian(pose, antenna);
  const Eigen::Vector2d by_yaw = (Pose2{pose.x, pose.y, pose.yaw + kStep} * antenna -
                                  Pose2{pose.x, pose.y, pose.yaw - kStep} * antenna) /
                                 (2.0 * kStep);
  EXPECT_TRUE(H.col(2).isApprox(by_yaw, 1e-8));
  EXPECT_TRUE((H.leftCols<2>() == Eigen::Matrix2d::Identity()));
}

}  // namespace
}  // namespace multipath_localization
