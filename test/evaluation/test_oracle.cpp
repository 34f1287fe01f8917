#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/oracle.hpp"
#include "evaluation/runner.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"

namespace multipath_localization {
namespace {

constexpr double kFrom = 60.0;

TEST(Oracle, IsConsistent) {
  double sum = 0.0;
  std::size_t drives = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Score result = score(run_oracle(random_drive(seed)), kFrom);
    ASSERT_TRUE(result.nees_mean) << seed;
    EXPECT_LT(*result.nees_mean, 30.0) << seed;
    sum += *result.nees_mean;
    ++drives;
  }
  EXPECT_GT(sum / static_cast<double>(drives), 0.7);
  EXPECT_LT(sum / static_cast<double>(drives), 4.0);
}

TEST(Oracle, IsNotBeatenInTheMean) {
  double ratio = 0.0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const RandomDrive made = random_drive(seed);
    const auto make = [&] { return make_estimator("gated_ekf", YAML::Node(), seed); };
    const double told = *score(run_oracle(made), kFrom).rmse;
    const double untold = *score(run_drive(made.drive, make, {}), kFrom).rmse;
    const double fixes = *score_fixes(made.drive, kFrom).rmse;
    ratio += std::log(std::min(untold, fixes) / told) / 30.0;
  }
  EXPECT_GT(ratio, 0.1);
}

TEST(Oracle, SeesThroughAShadowItIsToldOf) {
  RandomDrive made = random_drive(1);
  made.robot.receiver.levels = {{0.0, 0.0, 1.0, 0.1}};
  made.drive.measurements.clear();
  made.fix_truths.clear();
  for (const TruthSample& truth : made.drive.truth) {
    GnssFix fix;
    fix.stamp = truth.stamp;
    fix.position = truth.base_in_map.position();
    FixTruth wrong;
    if (truth.stamp > 100.0) {
      wrong.fault = FixFault::kShadow;
      wrong.new_bias = wrong.bias_sigma == 0.0 && made.fix_truths.back().fault == FixFault::kNone;
      wrong.bias_sigma = 20.0;
      wrong.bias_part = 1.0;
      fix.position += Eigen::Vector2d(30.0, 0.0);
    }
    made.drive.measurements.push_back({fix, fix.stamp});
    made.fix_truths.push_back(wrong);
  }
  const std::vector<Epoch> epochs = run_oracle(made);
  EXPECT_LT(*score(epochs, kFrom).rmse, 5.0);
  EXPECT_LT(*score(epochs, kFrom).nees_mean, 6.0);
}

}  // namespace
}  // namespace multipath_localization
