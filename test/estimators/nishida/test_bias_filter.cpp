#include <gtest/gtest.h>

#include <cmath>

#include "estimators/nishida/bias_filter.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector2d kPredicted(100.0, 50.0);

/// r_hat after 200 fixes of a bias that is `bias_at(t)`, noise 0.3 m, 5 Hz.
template <class BiasAt>
double radius_after(const GnssBiasParameters& parameters, BiasAt bias_at) {
  BiasFilter filter(parameters);
  double radius = 0.0;
  for (std::uint32_t k = 0; k < 200; ++k) {
    RandomStream random(1, k, 0);
    const Eigen::Vector2d noise(0.3 * random.normal(), 0.3 * random.normal());
    radius = filter.update(kPredicted + bias_at(0.2 * k) + noise, kPredicted, {0.3, 0.3}, 0.2).norm();
  }
  return radius;
}

Eigen::Vector2d constant(double) { return {3.0, -4.0}; }
Eigen::Vector2d sudden(double t) { return t < 30.0 ? Eigen::Vector2d::Zero() : Eigen::Vector2d(3.0, -4.0); }

TEST(BiasFilter, IsTheLengthOfAConstantBias) {
  GnssBiasParameters parameters;
  for (BiasInput input : {BiasInput::kRelative, BiasInput::kSmoothed}) {
    parameters.bias_input = input;
    EXPECT_NEAR(radius_after(parameters, constant), 5.0, 0.5) << static_cast<int>(input);
  }
}

TEST(BiasFilter, AsPrintedIsTheDistanceFromTheOriginOfTheMap) {
  GnssBiasParameters parameters;
  parameters.bias_input = BiasInput::kAbsolute;
  EXPECT_NEAR(radius_after(parameters, constant), std::hypot(103.0, 46.0), 0.5);
}

TEST(BiasFilter, WithoutProcessNoiseItStopsListening) {
  GnssBiasParameters parameters;
  EXPECT_NEAR(radius_after(parameters, sudden), 5.0, 0.6);
  parameters.bias_process_noise = 0.0;
  EXPECT_GT(std::abs(radius_after(parameters, sudden) - 5.0), 0.8);
}

/// Takes `count` fixes of this bias and noise [m], 10 Hz; the sky is told by sigma_b 0.1 m and sigma_s 0.5 m.
Eigen::Vector2d taken(BiasFilter& filter, std::uint32_t count, const Eigen::Vector2d& bias, double noise) {
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
  for (std::uint32_t k = 0; k < count; ++k) {
    RandomStream random(2, k, 0);
    const Eigen::Vector2d error(noise * random.normal(), noise * random.normal());
    offset = filter.update(kPredicted + bias + error, kPredicted, {0.1, 0.5}, 0.1);
  }
  return offset;
}

GnssBiasParameters told_by_scatter() {
  GnssBiasParameters parameters;
  parameters.bias_motion = BiasMotion::kWalk;
  parameters.bias_process_noise = 0.01;
  parameters.sky = Sky::kScatter;
  return parameters;
}

TEST(BiasFilter, OpenSkyIsToldByTheScatterOfTheFixesWhereverTheyAre) {
  GnssBiasParameters parameters = told_by_scatter();
  parameters.bias_input = BiasInput::kSmoothed;
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(3.0, -4.0)}) {
    BiasFilter filter{parameters};
    taken(filter, 30, place, 0.1);
    EXPECT_GT(filter.open_probability(), 0.999);
    taken(filter, 100, place, 0.5);
    EXPECT_LT(filter.open_probability(), 0.001);
    taken(filter, 50, place, 0.1);
    EXPECT_GT(filter.open_probability(), 0.999);
  }
}

TEST(BiasFilter, AsPrintedTheSkyIsHalfOpenWhateverTheFixes) {
  BiasFilter filter{GnssBiasParameters{}};
  taken(filter, 30, {0.0, 0.0}, 0.0);
  EXPECT_EQ(filter.open_probability(), 0.5);
  EXPECT_EQ(filter.moved_unseen(), Eigen::Matrix2d::Zero().eval());
}

TEST(BiasFilter, ThereIsNoBiasUnderOpenSkyAndItsVectorInShadow) {
  BiasFilter filter{told_by_scatter()};
  EXPECT_LT(taken(filter, 30, {0.0, 0.0}, 0.1).norm(), 1e-3);
  EXPECT_LT((taken(filter, 300, {3.0, -4.0}, 0.5) - Eigen::Vector2d(3.0, -4.0)).norm(), 0.5);
}

TEST(BiasFilter, WhatItMayHaveMovedUnseenGrowsInShadowAndEndsUnderOpenSky) {
  BiasFilter filter{told_by_scatter()};
  taken(filter, 30, {0.0, 0.0}, 0.1);
  EXPECT_LT(filter.moved_unseen()(0, 0), 1e-4);
  taken(filter, 100, {3.0, -4.0}, 0.5);
  EXPECT_NEAR(filter.moved_unseen()(0, 0), 0.01 * 10.0, 0.01);  // q t
  taken(filter, 150, {0.0, 0.0}, 0.1);
  EXPECT_LT(filter.moved_unseen()(0, 0), 1e-4);
}

TEST(BiasFilter, ForgettingStartsAtTheNextFix) {
  BiasFilter filter{GnssBiasParameters{}};
  filter.update(kPredicted, kPredicted, {0.3, 0.3}, 0.2);
  filter.forget();
  EXPECT_NEAR(filter.update(kPredicted + Eigen::Vector2d(0.0, 7.0), kPredicted, {0.3, 0.3}, 0.2).norm(), 7.0,
              1e-12);
  EXPECT_NEAR(filter.covariance()(0, 0), 0.09, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
