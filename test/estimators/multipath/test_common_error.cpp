#include <gtest/gtest.h>

#include "estimators/multipath/common_error.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(CommonError, IsThereWithoutCorrectionsAndGrowsBackAfterThem) {
  CommonError error;
  error.begin(FixStatus::kSingle, 1.5);
  EXPECT_NEAR(error.variance(), 2.25, 1e-12);
  error.go_on(FixStatus::kGroundBased, 1.0, 1.5);
  EXPECT_EQ(error.variance(), 0.0);
  error.go_on(FixStatus::kSingle, 1.0, 1.5);
  EXPECT_GT(error.variance(), 0.0);
  EXPECT_LT(error.variance(), 0.1);
  error.go_on(FixStatus::kSingle, 1000.0, 1.5);
  EXPECT_NEAR(error.variance(), 2.25, 1e-12) << "and no further";
}

}  // namespace
}  // namespace multipath_localization::multipath
