#include <gtest/gtest.h>

#include "simulation/periods.hpp"

namespace multipath_localization {
namespace {

TEST(Periods, CountOneThatRoundingKeepsFromItsEnd) {
  EXPECT_EQ(periods(0.0, 10.0), 0);
  EXPECT_EQ(periods(0.29, 10.0), 2);
  EXPECT_EQ(periods(0.1 + 0.2, 10.0), 3);
  EXPECT_EQ(periods(0.3 - 1e-12, 10.0), 3);
  EXPECT_EQ(periods(100.0, 0.0), 0) << "a sensor that is not there";
}

}  // namespace
}  // namespace multipath_localization
