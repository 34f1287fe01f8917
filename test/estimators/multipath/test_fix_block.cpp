#include <gtest/gtest.h>

#include "estimators/multipath/fix_block.hpp"

namespace multipath_localization::multipath {
namespace {

GnssFix fix_at(double x, double y) {
  GnssFix fix;
  fix.position = {x, y};
  return fix;
}

TEST(FixBlock, OfOneFixIsThatFix) {
  FixBlock block;
  block.add(fix_at(3.0, 4.0));
  const GnssFix fix = block.take(0.5);
  EXPECT_EQ(fix.position, Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(fix.antenna_in_base, Eigen::Vector2d::Zero());
}

TEST(FixBlock, OfADriveIsAFixOfItsEnd) {
  const double yaw = 0.7;
  FixBlock block;
  Pose2 base{1.0, 2.0, yaw};
  for (int i = 0; i < 5; ++i) {
    const Pose2 step{0.4, 0.0, 0.1};
    block.move(step);
    base = base * step;
    block.add(fix_at(base.x, base.y));
  }
  const GnssFix mean = block.take(base.yaw);
  EXPECT_LT((base * mean.antenna_in_base - mean.position).norm(), 1e-12);
}

TEST(FixBlock, LeavesOutWhatLiesFarFromTheRest) {
  FixBlock block;
  for (const double x : {0.0, 0.1, -0.1, 0.05, 25.0}) block.add(fix_at(x, 0.0));
  EXPECT_NEAR(block.take(0.0).position.x(), 0.0125, 1e-9);
}

TEST(FixBlock, ForgetsWhatWasTaken) {
  FixBlock block;
  block.add(fix_at(100.0, 0.0));
  block.take(0.0);
  block.add(fix_at(1.0, 0.0));
  EXPECT_EQ(block.take(0.0).position.x(), 1.0);
}

}  // namespace
}  // namespace multipath_localization::multipath
