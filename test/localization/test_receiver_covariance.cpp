#include <gtest/gtest.h>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/localization/receiver_covariance.hpp"

namespace multipath_localization {
namespace {

const Eigen::Matrix2d kDeclared = (Eigen::Matrix2d() << 0.01, 0.002, 0.002, 0.03).finished();

ReceiverCovariance of_source(CovarianceSource source, double scale = 1.0) {
  ReceiverCovarianceParameters parameters;
  parameters.source = source;
  parameters.scale = scale;
  parameters.fixed_sigma = 2.0;
  return ReceiverCovariance(parameters);
}

/// Fixes half a metre apart with white noise; gives the way driven at their end.
double drive(ReceiverCovariance& covariance, int fixes, double sigma, double from = 0.0) {
  RandomStream random(1, 2, static_cast<std::uint32_t>(fixes));
  for (int i = 0; i < fixes; ++i) {
    from += 0.5;
    covariance.observe(from, sigma * Eigen::Vector2d(random.normal(), random.normal()));
  }
  return from;
}

TEST(ReceiverCovariance, OfTheMessageIsWhatItDeclaresTimesTheScale) {
  ReceiverCovariance covariance = of_source(CovarianceSource::kMessage);
  drive(covariance, 50, 5.0);
  EXPECT_EQ(covariance.of(kDeclared), kDeclared) << "to the bit";
  EXPECT_TRUE(of_source(CovarianceSource::kMessage, 3.0).of(kDeclared).isApprox(9.0 * kDeclared));
}

TEST(ReceiverCovariance, FixedIsFixed) {
  EXPECT_TRUE(of_source(CovarianceSource::kFixed).of(kDeclared).isApprox(4.0 * Eigen::Matrix2d::Identity()));
}

TEST(ReceiverCovariance, ObservesTheScatterAboutThePose) {
  ReceiverCovarianceParameters wide;
  wide.window = 1e4;
  ReceiverCovariance covariance(wide);
  EXPECT_FALSE(covariance.observed_sigma());
  drive(covariance, 2000, 4.2);
  ASSERT_TRUE(covariance.observed_sigma());
  EXPECT_NEAR(*covariance.observed_sigma(), 4.2, 0.2);
}

TEST(ReceiverCovariance, LoneOutliersDoNotCount) {
  ReceiverCovariance covariance = of_source(CovarianceSource::kAdaptive);
  double driven = drive(covariance, 20, 0.3);
  for (int i = 0; i < 5; ++i) {
    covariance.observe(driven += 0.5, {50.0, 0.0});
    driven = drive(covariance, 2, 0.3, driven);
  }
  EXPECT_LT(*covariance.observed_sigma(), 1.0);
}

TEST(ReceiverCovariance, AdaptsToFixesThatAreFurtherOffThanDeclaredInTheirShape) {
  ReceiverCovariance covariance = of_source(CovarianceSource::kAdaptive);
  EXPECT_EQ(covariance.of(kDeclared), kDeclared) << "nothing seen yet";
  const double driven = drive(covariance, 50, 3.0);
  const Eigen::Matrix2d adapted = covariance.of(kDeclared);
  EXPECT_NEAR(std::sqrt(0.5 * adapted.trace()), *covariance.observed_sigma(), 1e-9);
  EXPECT_TRUE(adapted.isApprox(adapted(0, 0) / kDeclared(0, 0) * kDeclared));
  EXPECT_TRUE(
      covariance.of(Eigen::Matrix2d::Zero()).isApprox(0.5 * adapted.trace() * Eigen::Matrix2d::Identity()));
  drive(covariance, 40, 0.01, driven);
  EXPECT_EQ(covariance.of(kDeclared), kDeclared) << "never believed for more than it declares";
}

TEST(ReceiverCovariance, ARobotThatStandsShowsNothing) {
  ReceiverCovariance covariance = of_source(CovarianceSource::kAdaptive);
  const double driven = drive(covariance, 30, 3.0);
  const double before = *covariance.observed_sigma();
  for (int i = 0; i < 1000; ++i) covariance.observe(driven, {0.1, 0.0});
  EXPECT_EQ(*covariance.observed_sigma(), before);
}

TEST(ReceiverCovariance, ForgetsWhenCleared) {
  ReceiverCovariance covariance = of_source(CovarianceSource::kAdaptive);
  drive(covariance, 30, 3.0);
  covariance.clear();
  EXPECT_FALSE(covariance.observed_sigma());
}

}  // namespace
}  // namespace multipath_localization
