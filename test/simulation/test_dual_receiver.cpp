#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulation/dual_receiver.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.01;

Eigen::Vector2d unbiased(const Eigen::Vector2d&) { return Eigen::Vector2d::Zero(); }

DualReceiverParameters at_5_hz() {
  DualReceiverParameters parameters;
  parameters.rate = 5.0;
  return parameters;
}

DualReceiverParameters free_of_error() {
  DualReceiverParameters parameters = at_5_hz();
  parameters.pose_error.mean = {0.0, 0.0, 0.0};
  parameters.pose_error.covariance = std::vector<double>(9, 0.0);
  parameters.baseline_sigma = 0.0;
  return parameters;
}

struct Delivered {
  double time;
  DualAntennaFix fixes;
};

/// What is delivered over `duration` [s] with the base at one pose.
std::vector<Delivered> watch(DualReceiver receiver, double duration, const Pose2& base = {}) {
  std::vector<Delivered> all;
  const auto steps = std::lround(duration / kStep);
  for (long i = 1; i <= steps; ++i) {
    const double time = static_cast<double>(i) * kStep;
    for (const DualAntennaFix& fixes : receiver.step(base, unbiased, time)) all.push_back({time, fixes});
  }
  return all;
}

TEST(DualReceiver, IsOffUnlessAskedFor) {
  EXPECT_TRUE(watch(DualReceiver(DualReceiverParameters{}, {}, 1), 10.0).empty());
}

TEST(DualReceiver, DeliversAtItsRateAndLateByItsLatency) {
  DualReceiverParameters parameters = at_5_hz();
  parameters.latency = 0.13;
  const auto all = watch(DualReceiver(parameters, {}, 1), 10.0);
  ASSERT_EQ(all.size(), 49U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].fixes.stamp, 0.2 * static_cast<double>(i + 1), 1e-9);
    EXPECT_NEAR(all[i].time - all[i].fixes.stamp, 0.13, 1e-6);
    EXPECT_EQ(all[i].fixes.left.stamp, all[i].fixes.stamp);
  }
}

TEST(DualReceiver, IsSilentInAnOutage) {
  const auto all = watch(DualReceiver(at_5_hz(), {{2.0, 3.0}}, 1), 10.0);
  EXPECT_EQ(all.size(), 35U);
  for (const Delivered& d : all) {
    EXPECT_TRUE(d.fixes.stamp < 2.0 - 1e-9 || d.fixes.stamp > 5.0 - 1e-9) << d.fixes.stamp;
  }
}

TEST(DualReceiver, WithoutErrorsSeesTheAntennasWhereTheyAre) {
  DualReceiverParameters parameters = free_of_error();
  parameters.antenna_x = 0.2;
  parameters.baseline = 0.4;
  const Pose2 base{3.0, -4.0, 2.5};
  const auto all = watch(DualReceiver(parameters, {}, 1), 1.0, base);
  ASSERT_EQ(all.size(), 5U);
  for (const Delivered& d : all) {
    EXPECT_EQ(d.fixes.left.antenna_in_base, Eigen::Vector2d(0.2, 0.2));
    EXPECT_EQ(d.fixes.right.antenna_in_base, Eigen::Vector2d(0.2, -0.2));
    EXPECT_LT((d.fixes.left.position - base * d.fixes.left.antenna_in_base).norm(), 1e-12);
    EXPECT_LT((d.fixes.right.position - base * d.fixes.right.antenna_in_base).norm(), 1e-12);
  }
}

/// Of the poses told from a base at `truth`.
struct Spread {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double baseline_sigma = 0.0;
};

Spread spread_at(const Pose2& truth, double count) {
  std::vector<Eigen::Vector3d> errors;
  Spread spread;
  for (const Delivered& d : watch(DualReceiver(at_5_hz(), {}, 1), count / 5.0, truth)) {
    const auto told = dual_antenna_pose(d.fixes, 0.0);
    errors.emplace_back(told->pose.x() - truth.x, told->pose.y() - truth.y,
                        angle_difference(told->pose.z(), truth.yaw));
    spread.mean += errors.back() / count;
    spread.baseline_sigma += told->baseline_error * told->baseline_error / count;
  }
  for (const Eigen::Vector3d& e : errors) {
    spread.covariance += (e - spread.mean) * (e - spread.mean).transpose() / (count - 1.0);
  }
  spread.baseline_sigma = std::sqrt(spread.baseline_sigma);
  return spread;
}

TEST(DualReceiver, HasTheMeanAndTheCovarianceOfThePaper) {  // Eqs. (11), (12) of [KAM]
  constexpr double kCount = 20000.0;
  const PoseError printed{PoseErrorParameters{}};
  for (const double heading : {0.3, kPi}) {
    const Spread spread = spread_at({100.0, -50.0, heading}, kCount);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(spread.mean(i), printed.mean(i), 4.0 * std::sqrt(printed.covariance(i, i) / kCount));
      for (int j = 0; j < 3; ++j) {
        const double scale = std::sqrt(printed.covariance(i, i) * printed.covariance(j, j));
        EXPECT_NEAR(spread.covariance(i, j), printed.covariance(i, j), 4.0 * scale * std::sqrt(2.0 / kCount));
      }
    }
    EXPECT_NEAR(spread.baseline_sigma, at_5_hz().baseline_sigma, 0.02 * at_5_hz().baseline_sigma);
  }
}

TEST(DualReceiver, EachAntennaHasTheBiasOfItsPlace) {
  DualReceiver receiver(free_of_error(), {}, 1);
  const Pose2 base{0.0, 0.0, 0.0};
  const auto reflected_in_the_north = [](const Eigen::Vector2d& point) {
    return Eigen::Vector2d(point.y() > 0.0 ? 1.5 : 0.0, 0.0);
  };
  const auto all = receiver.step(base, reflected_in_the_north, 0.2);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all[0].left.position.x(), 1.5, 1e-12);
  EXPECT_NEAR(all[0].right.position.x(), 0.0, 1e-12);
}

TEST(DualReceiver, RefusesAnErrorThatIsNone) {
  DualReceiverParameters parameters = at_5_hz();
  parameters.pose_error.covariance = {1.0};
  EXPECT_THROW(DualReceiver(parameters, {}, 1), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
