#include <gtest/gtest.h>

#include <limits>

#include "multipath_localization/guidance/stopover.hpp"

namespace multipath_localization {
namespace {

TEST(Stopover, LastsAsLongAsToldFromTheFirstLook) {
  Stopover stopover;
  EXPECT_FALSE(stopover.lasts(5.0));
  stopover.begin(2.0);
  EXPECT_TRUE(stopover.lasts(10.0));
  EXPECT_EQ(stopover.status(), "waiting for 2 s");
  EXPECT_TRUE(stopover.lasts(11.5));
  EXPECT_EQ(stopover.status(), "waiting for 1 s");
  EXPECT_FALSE(stopover.lasts(12.0));
  EXPECT_FALSE(stopover.lasts(11.0));
}

TEST(Stopover, IsNotMadeLongerOrShorterByAClockThatRunsBack) {
  Stopover stopover;
  stopover.begin(2.0);
  stopover.lasts(10.0);
  EXPECT_TRUE(stopover.lasts(3.0));
  EXPECT_TRUE(stopover.lasts(4.9));
  EXPECT_FALSE(stopover.lasts(5.1));
}

TEST(Stopover, EndsByCall) {
  Stopover stopover;
  EXPECT_FALSE(stopover.end());
  stopover.begin(std::numeric_limits<double>::infinity());
  stopover.lasts(0.0);
  EXPECT_TRUE(stopover.lasts(1e9));
  EXPECT_EQ(stopover.status(), "waiting for resume");
  EXPECT_TRUE(stopover.end());
  EXPECT_FALSE(stopover.lasts(1e9));
}

}  // namespace
}  // namespace multipath_localization
