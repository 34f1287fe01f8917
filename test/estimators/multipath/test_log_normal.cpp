#include <gtest/gtest.h>

#include "estimators/multipath/log_normal.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(LogNormal, IsThatOfOneDimensionTwiceWhereNothingIsCorrelated) {
  const Eigen::Vector2d v(0.3, -1.2);
  const Eigen::Matrix2d S = Eigen::Vector2d(0.5, 2.0).asDiagonal();
  EXPECT_NEAR(log_normal(v, S), log_normal(0.3, 0.5) + log_normal(-1.2, 2.0), 1e-12);
  EXPECT_NEAR(log_normal(0.0, 1.0), -0.9189385332, 1e-9);
}

}  // namespace
}  // namespace multipath_localization::multipath
