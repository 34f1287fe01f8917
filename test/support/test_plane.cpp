#include <gtest/gtest.h>

#include "support/plane.hpp"

namespace multipath_localization {
namespace {

TEST(Cross, IsPositiveToTheLeft) {
  EXPECT_EQ(cross({2.0, 0.0}, {1.0, 3.0}), 6.0);
  EXPECT_EQ(cross({1.0, 3.0}, {2.0, 0.0}), -6.0);
  EXPECT_EQ(cross({1.0, 3.0}, {2.0, 6.0}), 0.0);
}

}  // namespace
}  // namespace multipath_localization
