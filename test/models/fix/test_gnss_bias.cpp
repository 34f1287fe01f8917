#include <gtest/gtest.h>

#include "multipath_localization/models/fix/gnss_bias.hpp"

namespace multipath_localization {
namespace {

TEST(GnssBias, TransitionMovesTheOffsetByItsRate) {
  const gnss_bias::State eta(1.0, 0.5, -2.0, 0.25);
  const Eigen::Vector2d moved = gnss_bias::offset(gnss_bias::transition(BiasMotion::kRate, 2.0) * eta);
  EXPECT_EQ(moved, Eigen::Vector2d(2.0, -1.5));
  EXPECT_EQ(gnss_bias::observation() * eta, gnss_bias::offset(eta));
}

TEST(GnssBias, TwoShortStepsAreOneLongStep) {
  const auto A = gnss_bias::transition(BiasMotion::kRate, 0.3);
  EXPECT_TRUE((gnss_bias::transition(BiasMotion::kRate, 0.2) * A)
                  .isApprox(gnss_bias::transition(BiasMotion::kRate, 0.5), 1e-12));
  const auto B = gnss_bias::transition(BiasMotion::kRate, 0.2);
  const gnss_bias::Matrix twice = B * gnss_bias::process_noise(BiasMotion::kRate, 1.7, 0.3) * B.transpose() +
                                  gnss_bias::process_noise(BiasMotion::kRate, 1.7, 0.2);
  EXPECT_TRUE(twice.isApprox(gnss_bias::process_noise(BiasMotion::kRate, 1.7, 0.5), 1e-12));
}

TEST(GnssBias, WalkingItHasNoRateAndSpreadsWithTheTime) {
  const gnss_bias::State eta(1.0, 0.5, -2.0, 0.25);
  EXPECT_EQ(gnss_bias::transition(BiasMotion::kWalk, 2.0) * eta, gnss_bias::State(1.0, 0.0, -2.0, 0.0));
  EXPECT_EQ(gnss_bias::process_noise(BiasMotion::kWalk, 0.5, 4.0).diagonal(),
            gnss_bias::State(2.0, 0.0, 2.0, 0.0));
}

TEST(GnssBias, PrintedFilterHasNoProcessNoise) {
  EXPECT_EQ(gnss_bias::process_noise(BiasMotion::kRate, 0.0, 0.5), gnss_bias::Matrix::Zero().eval());
}

}  // namespace
}  // namespace multipath_localization
