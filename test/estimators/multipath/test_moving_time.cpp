#include <gtest/gtest.h>

#include "estimators/multipath/moving_time.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(MovingTime, CountsEachIncrementThatMoves) {
  MovingTime moving;
  EXPECT_DOUBLE_EQ(moving.add({0.1, 0.1, 1.0, 0.0}), 0.1);
  EXPECT_DOUBLE_EQ(moving.add({2.1, 2.0, 1.0, 0.0}), 2.0) << "however long it lasts";
  EXPECT_DOUBLE_EQ(moving.add({2.2, 0.1, 0.0, 0.5}), 0.1) << "a turn on the spot moves";
}

TEST(MovingTime, CountsTheTimeBetweenTicks) {
  MovingTime moving;
  moving.add({0.1, 0.1, 1.0, 0.0});
  EXPECT_DOUBLE_EQ(moving.add({0.2, 0.1, 0.0, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(moving.add({0.3, 0.1, 1.0, 0.0}), 0.2);
}

TEST(MovingTime, DoesNotCountAStop) {
  MovingTime moving;
  moving.add({0.1, 0.1, 1.0, 0.0});
  for (int i = 2; i <= 11; ++i) EXPECT_DOUBLE_EQ(moving.add({0.1 * i, 0.1, 0.0, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(moving.add({1.2, 0.1, 1.0, 0.0}), 0.1);
}

}  // namespace
}  // namespace multipath_localization::multipath
