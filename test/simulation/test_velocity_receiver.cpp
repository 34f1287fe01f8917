#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulation/velocity_receiver.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector2d kTrue(1.0, 0.5);

/// What is told within 400 s at kTrue, in a shadow or not.
std::vector<GnssVelocity> told(const VelocityReceiverParameters& parameters, bool in_shadow) {
  VelocityReceiver receiver(parameters, {}, 3);
  std::vector<GnssVelocity> all;
  for (int i = 1; i <= 40000; ++i) {
    for (const GnssVelocity& velocity : receiver.step(kTrue, in_shadow, 0.01 * i, 0.01))
      all.push_back(velocity);
  }
  return all;
}

double share_off(const std::vector<GnssVelocity>& all, double by) {
  double off = 0.0;
  for (const GnssVelocity& velocity : all) off += (velocity.velocity - kTrue).norm() > by ? 1.0 : 0.0;
  return off / static_cast<double>(all.size());
}

VelocityReceiverParameters at_5_hz() {
  VelocityReceiverParameters parameters;
  parameters.rate = 5.0;
  return parameters;
}

TEST(VelocityReceiver, TellsNothingWithoutARate) { EXPECT_TRUE(told({}, false).empty()); }

TEST(VelocityReceiver, IsReflectedInShadowsMoreOften) {
  EXPECT_EQ(told(at_5_hz(), false).size(), 2000u);
  EXPECT_NEAR(share_off(told(at_5_hz(), false), 0.3), 0.01, 0.01);
  EXPECT_NEAR(share_off(told(at_5_hz(), true), 0.3), 0.1, 0.03);
}

TEST(VelocityReceiver, HasErrorsThatAreAlikeForAWhile) {
  VelocityReceiverParameters parameters = at_5_hz();
  parameters.white_sigma = parameters.outlier_share = 0.0;
  const std::vector<GnssVelocity> all = told(parameters, false);
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    products += (all[i].velocity - kTrue).dot(all[i - 1].velocity - kTrue);
    squares += (all[i].velocity - kTrue).squaredNorm();
  }
  EXPECT_NEAR(products / squares, std::exp(-0.2 / parameters.slow_time), 0.05);
}

TEST(VelocityReceiver, IsLateByItsLagAndItsLatency) {
  VelocityReceiverParameters parameters = at_5_hz();
  parameters.white_sigma = parameters.slow_sigma = parameters.outlier_share = 0.0;
  parameters.lag = 0.2;
  parameters.latency = 0.1;
  VelocityReceiver receiver(parameters, {}, 3);
  for (int i = 1; i <= 1000; ++i) {
    const double time = 0.01 * i;
    for (const GnssVelocity& velocity : receiver.step({time, 0.0}, false, time, 0.01)) {
      EXPECT_NEAR(time - velocity.stamp, 0.1, 1e-6);
      if (time > 1.0) {
        EXPECT_NEAR(velocity.velocity.x(), velocity.stamp - 0.2, 0.011);
      }
    }
  }
}

TEST(VelocityReceiver, IsSpoiltByItsFaults) {
  SensorFault late;
  late.kind = "late";
  late.size = 0.5;
  VelocityReceiver receiver(at_5_hz(), {late}, 3);
  int delivered = 0;
  for (int i = 1; i <= 1000; ++i) {
    for (const GnssVelocity& velocity : receiver.step(kTrue, false, 0.01 * i, 0.01)) {
      EXPECT_NEAR(0.01 * i - velocity.stamp, 0.5, 1e-6);
      ++delivered;
    }
  }
  EXPECT_EQ(delivered, 47) << "the last three of fifty are on their way";
}

}  // namespace
}  // namespace multipath_localization
