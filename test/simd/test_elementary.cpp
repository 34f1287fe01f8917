#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simd/elementary.hpp"

namespace multipath_localization {
namespace {

/// The largest of error(t) over 200 001 points of -1 .. 1.
template <class Error>
double largest(const Error& error) {
  double most = 0.0;
  for (int i = -100000; i <= 100000; ++i) most = std::max(most, std::abs(error(i * 1e-5)));
  return most;
}

TEST(Elementary, SineAndCosineAreTrueTo1e9) {
  for (const double turns : {1.0, 100.0}) {
    EXPECT_LT(
        largest([&](double t) { return elementary::sincos_pi(turns * t).sin - std::sin(kPi * turns * t); }),
        1e-9);
    EXPECT_LT(
        largest([&](double t) { return elementary::sincos_pi(turns * t).cos - std::cos(kPi * turns * t); }),
        1e-9);
  }
}

TEST(Elementary, SineAndCosineOfAQuarterTurnNeedNoReduction) {
  EXPECT_LT(largest([](double t) {
              return elementary::sincos_quarter(0.5 * kPi * t).sin - std::sin(0.5 * kPi * t);
            }),
            1e-9);
  EXPECT_LT(largest([](double t) {
              return elementary::sincos_quarter(0.5 * kPi * t).cos - std::cos(0.5 * kPi * t);
            }),
            1e-9);
}

TEST(Elementary, SincAndTangentAreTrueTo1e9) {
  EXPECT_LT(largest([](double t) {
              return t == 0.0 ? elementary::sinc(0.0) - 1.0
                              : elementary::sinc(kPi * t) - std::sin(kPi * t) / (kPi * t);
            }),
            1e-9);
  EXPECT_LT(largest([](double t) {
              const double x = 1.5707 * t;
              return t == 0.0 ? elementary::tan(x) : elementary::tan(x) / std::tan(x) - 1.0;
            }),
            1e-9);
}

TEST(Elementary, ExponentialAndLogarithmAreTrueTo1e9) {
  EXPECT_LT(largest([](double t) { return elementary::exp(699.0 * t) / std::exp(699.0 * t) - 1.0; }), 1e-9);
  EXPECT_LT(largest([](double t) {
              const double x = std::exp(690.0 * t);
              return (elementary::log(x) - std::log(x)) / std::max(1.0, std::abs(std::log(x)));
            }),
            1e-9);
  EXPECT_EQ(elementary::exp(0.0), 1.0);
  EXPECT_EQ(elementary::log(1.0), 0.0);
}

TEST(Elementary, ExponentialOfWhatIsFarBelowOrNoNumberIsZero) {
  EXPECT_EQ(elementary::exp(-1e20), 0.0);
  EXPECT_EQ(elementary::exp(-std::numeric_limits<double>::infinity()), 0.0);
  EXPECT_EQ(elementary::exp(std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(Elementary, WrapsToHalfATurn) {
  EXPECT_LT(largest([](double t) { return std::sin(elementary::wrap(50.0 * t)) - std::sin(50.0 * t); }),
            1e-12);
  EXPECT_LE(largest([](double t) { return elementary::wrap(50.0 * t); }), kPi);
}

TEST(Elementary, SinglePrecisionIsTrueTo3e7) {
  using elementary::single::sincos_pi;
  EXPECT_LT(largest([](double t) {
              const auto x = static_cast<float>(t);
              return static_cast<double>(sincos_pi(x).sin) - std::sin(kPi * static_cast<double>(x));
            }),
            3e-7);
  EXPECT_LT(largest([](double t) {
              const auto x = static_cast<float>(t);
              return static_cast<double>(sincos_pi(x).cos) - std::cos(kPi * static_cast<double>(x));
            }),
            3e-7);
  EXPECT_LT(largest([](double t) {
              const auto x = static_cast<float>(std::exp2(-16.0 * (t + 1.0)));
              const double expected = std::log(static_cast<double>(x));
              return expected == 0.0 ? 0.0 : static_cast<double>(elementary::single::log(x)) / expected - 1.0;
            }),
            2e-7);
}

}  // namespace
}  // namespace multipath_localization
