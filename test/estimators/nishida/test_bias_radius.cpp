#include <gtest/gtest.h>

#include <cmath>

#include "estimators/nishida/bias_radius.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector2d kPredicted(100.0, 50.0);

/// r_hat after 200 fixes of a bias that is `bias_at(t)`, noise 0.3 m, 5 Hz.
template <class BiasAt>
double radius_after(const GnssBiasParameters& parameters, BiasAt bias_at) {
  BiasRadius filter(parameters);
  double radius = 0.0;
  for (std::uint32_t k = 0; k < 200; ++k) {
    RandomStream random(1, k, 0);
    const Eigen::Vector2d noise(0.3 * random.normal(), 0.3 * random.normal());
    radius = filter.update(kPredicted + bias_at(0.2 * k) + noise, kPredicted, 0.3, 0.2);
  }
  return radius;
}

Eigen::Vector2d constant(double) { return {3.0, -4.0}; }
Eigen::Vector2d sudden(double t) { return t < 30.0 ? Eigen::Vector2d::Zero() : Eigen::Vector2d(3.0, -4.0); }

TEST(BiasRadius, IsTheLengthOfAConstantBias) {
  GnssBiasParameters parameters;
  for (BiasInput input : {BiasInput::kRelative, BiasInput::kSmoothed}) {
    parameters.bias_input = input;
    EXPECT_NEAR(radius_after(parameters, constant), 5.0, 0.5) << static_cast<int>(input);
  }
}

TEST(BiasRadius, AsPrintedIsTheDistanceFromTheOriginOfTheMap) {
  GnssBiasParameters parameters;
  parameters.bias_input = BiasInput::kAbsolute;
  EXPECT_NEAR(radius_after(parameters, constant), std::hypot(103.0, 46.0), 0.5);
}

TEST(BiasRadius, WithoutProcessNoiseItStopsListening) {
  GnssBiasParameters parameters;
  EXPECT_NEAR(radius_after(parameters, sudden), 5.0, 0.6);
  parameters.bias_process_noise = 0.0;
  EXPECT_GT(std::abs(radius_after(parameters, sudden) - 5.0), 0.8);
}

TEST(BiasRadius, ForgettingStartsAtTheNextFix) {
  BiasRadius filter{GnssBiasParameters{}};
  filter.update(kPredicted, kPredicted, 0.3, 0.2);
  filter.forget();
  EXPECT_NEAR(filter.update(kPredicted + Eigen::Vector2d(0.0, 7.0), kPredicted, 0.3, 0.2), 7.0, 1e-12);
  EXPECT_NEAR(filter.covariance()(0, 0), 0.09, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
