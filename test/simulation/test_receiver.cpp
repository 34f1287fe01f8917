#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulation/receiver.hpp"

namespace multipath_localization {
namespace {

struct Delivered {
  double time;
  GnssFix fix;
};

/// What a receiver delivers over `duration` [s] of steps of 0.01 s with the base at one pose.
std::vector<Delivered> watch(Receiver receiver, double duration, const Pose2& base = {},
                             const Reception& reception = {}) {
  std::vector<Delivered> all;
  const auto steps = std::lround(duration / 0.01);
  for (long i = 1; i <= steps; ++i) {
    const double time = static_cast<double>(i) * 0.01;
    for (const GnssFix& fix : receiver.step(base * receiver.antenna_in_base(), reception, time, 0.01))
      all.push_back({time, fix});
  }
  return all;
}

double sigma(const std::vector<Delivered>& all, const Eigen::Vector2d& mean) {
  double squares = 0.0;
  for (const Delivered& d : all) squares += 0.5 * (d.fix.position - mean).squaredNorm();
  return std::sqrt(squares / static_cast<double>(all.size()));
}

TEST(Receiver, DeliversAtItsRate) {
  ReceiverParameters parameters;
  parameters.rate = 5.0;
  const auto all = watch(Receiver(parameters, {}, 1), 10.0);
  ASSERT_EQ(all.size(), 50U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].fix.stamp, 0.2 * static_cast<double>(i + 1), 1e-9);
    EXPECT_EQ(all[i].time, all[i].fix.stamp);
  }
}

TEST(Receiver, DeliversLateByItsLatency) {
  ReceiverParameters parameters;
  parameters.latency = 0.33;
  const auto all = watch(Receiver(parameters, {}, 1), 10.0);
  ASSERT_EQ(all.size(), 48U);
  for (const Delivered& d : all) EXPECT_NEAR(d.time - d.fix.stamp, 0.33, 1e-6);
}

TEST(Receiver, JitterKeepsTheOrderOfStamps) {
  ReceiverParameters parameters;
  parameters.latency = 0.1;
  parameters.latency_jitter = 0.8;
  const auto all = watch(Receiver(parameters, {}, 1), 60.0);
  double shortest = 10.0, longest = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    shortest = std::min(shortest, all[i].time - all[i].fix.stamp);
    longest = std::max(longest, all[i].time - all[i].fix.stamp);
    if (i > 0) {
      EXPECT_GT(all[i].fix.stamp, all[i - 1].fix.stamp);
    }
  }
  EXPECT_GE(shortest, 0.1 - 1e-9);
  EXPECT_LE(longest, 0.91);
  EXPECT_GT(longest - shortest, 0.4);
}

TEST(Receiver, StandsAtTheAntenna) {
  ReceiverParameters parameters;
  parameters.antenna_x = 0.5;
  parameters.antenna_y = 0.2;
  parameters.sigma_open = 0.0;
  const auto all = watch(Receiver(parameters, {}, 1), 1.0, {10.0, 20.0, 0.5 * kPi});
  EXPECT_NEAR((all.front().fix.position - Eigen::Vector2d(9.8, 20.5)).norm(), 0.0, 1e-12);
  EXPECT_EQ(all.front().fix.antenna_in_base, Eigen::Vector2d(0.5, 0.2));
}

TEST(Receiver, HasWhiteNoiseAndBiasByReception) {
  ReceiverParameters parameters;
  parameters.rate = 100.0;
  parameters.sigma_open = 0.3;
  parameters.sigma_shadow = 1.2;
  EXPECT_NEAR(sigma(watch(Receiver(parameters, {}, 1), 20.0), {0.0, 0.0}), 0.3, 0.015);  // 4.5 sigma
  const auto shadow = watch(Receiver(parameters, {}, 1), 20.0, {}, {{3.0, -4.0}, true});
  EXPECT_NEAR(sigma(shadow, {3.0, -4.0}), 1.2, 0.06);
}

TEST(Receiver, ClaimsWhatItIsToldToClaim) {
  ReceiverParameters parameters;
  parameters.declared_sigma_open = 0.1;
  parameters.declared_sigma_shadow = 0.2;
  const Eigen::Matrix2d unit = Eigen::Matrix2d::Identity();
  EXPECT_TRUE(watch(Receiver(parameters, {}, 1), 1.0).front().fix.covariance.isApprox(0.01 * unit));
  const Reception shadow{{5.0, 0.0}, true};
  EXPECT_TRUE(
      watch(Receiver(parameters, {}, 1), 1.0, {}, shadow).front().fix.covariance.isApprox(0.04 * unit));
}

TEST(Receiver, ColouredNoiseHasItsSigmaAndTimeConstant) {
  ReceiverParameters parameters;
  parameters.sigma_open = 0.0;
  parameters.coloured_sigma = 2.0;
  parameters.coloured_time_constant = 4.0;
  const int seeds = 400;
  double variance = 0.0, covariance = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    const auto all = watch(Receiver(parameters, {}, static_cast<std::uint64_t>(seed)), 5.0);
    const Eigen::Vector2d early = all[4].fix.position;  // at 1 s
    const Eigen::Vector2d late = all[24].fix.position;  // at 5 s, one time constant later
    variance += 0.5 * early.squaredNorm() / seeds;
    covariance += 0.5 * early.dot(late) / seeds;
  }
  EXPECT_NEAR(variance, 4.0, 0.9);  // over 800 draws, 4.5 sigma
  EXPECT_NEAR(covariance / 4.0, std::exp(-1.0), 0.17);
}

TEST(Receiver, IsSilentInAnOutage) {
  const auto all = watch(Receiver(ReceiverParameters{}, {{2.0, 3.0}, {8.0, 0.5}}, 1), 10.0);
  for (const Delivered& d : all) {
    EXPECT_FALSE(d.fix.stamp > 1.99 && d.fix.stamp < 4.99) << d.fix.stamp;
    EXPECT_FALSE(d.fix.stamp > 7.99 && d.fix.stamp < 8.49) << d.fix.stamp;
  }
  EXPECT_EQ(all.size(), 50U - 15U - 3U);
}

}  // namespace
}  // namespace multipath_localization
