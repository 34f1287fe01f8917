#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "estimators/multipath/heading_block.hpp"
#include "multipath_localization/core/angle.hpp"

namespace multipath_localization::multipath {
namespace {

/// Turns for `seconds` at `yaw_rate` [rad/s].
void turn(HeadingBlock& block, double seconds, double yaw_rate) {
  for (int i = 1; i <= std::lround(100.0 * seconds); ++i) block.move({0.01 * i, 0.01, 1.0, yaw_rate});
}

TEST(HeadingBlock, TurnsHeadingsOnToNow) {
  HeadingBlock block;
  block.add({0.0, 0.5, 0.01, 0.1});
  turn(block, 0.5, 0.4);
  const HeadingSighting sighting = block.take();
  EXPECT_NEAR(sighting.yaw, 0.8, 1e-9) << "0.1 rad since its stamp, 0.2 rad since it came";
  EXPECT_NEAR(sighting.turn_rate, 0.4, 1e-9);
  EXPECT_NEAR(sighting.duration, 0.5, 1e-9);
  EXPECT_TRUE(block.empty());
}

TEST(HeadingBlock, TakesTheMeanOfThoseThatAgree) {
  HeadingBlock block;
  block.add({0.1, kPi - 0.02, 0.01});
  block.add({0.2, -kPi + 0.04, 0.03});
  block.add({0.3, 0.0, 0.5});
  const HeadingSighting sighting = block.take();
  EXPECT_NEAR(angle_difference(sighting.yaw, -kPi + 0.01), 0.0, 1e-9);
  EXPECT_NEAR(sighting.variance, 0.02, 1e-12);
  EXPECT_EQ(sighting.count, 2.0);
}

TEST(HeadingBlock, RefusesWhatIsNoneAndWhatRepeatsItself) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  HeadingBlock block;
  EXPECT_EQ(block.add({kNan, 0.0, 0.01}), Reason::kNotFinite);
  EXPECT_EQ(block.add({0.0, kNan, 0.01}), Reason::kNotFinite);
  EXPECT_EQ(block.add({0.0, 0.0, kNan}), Reason::kNotFinite);
  EXPECT_EQ(block.add({0.0, 0.0, -1.0}), Reason::kInvalidCovariance);
  EXPECT_TRUE(block.empty());
  EXPECT_FALSE(block.add({0.1, 0.7, 0.01}));
  EXPECT_EQ(block.add({0.2, 0.7, 0.01, 0.05}), Reason::kRepeated);
}

TEST(HeadingBlock, ForgetsThoseThatNobodyTook) {
  HeadingBlock block;
  block.add({0.0, 0.0, 0.01});
  block.add({2.0, 1.0, 0.01});
  EXPECT_EQ(block.take().yaw, 1.0);
}

}  // namespace
}  // namespace multipath_localization::multipath
