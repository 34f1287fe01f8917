#include <gtest/gtest.h>

#include "ros/localization_node/frame_patience.hpp"

namespace multipath_localization {
namespace {

TEST(FramePatience, LastsForAMomentOnEitherClockAndOnce) {
  FramePatience patience;
  EXPECT_TRUE(patience.lasts("gps", 100.0, 10.0));
  EXPECT_TRUE(patience.lasts("gps", 101.0, 11.0));
  EXPECT_TRUE(patience.lasts("other", 102.0, 11.0)) << "counted by frame";
  EXPECT_FALSE(patience.lasts("gps", 102.0, 11.1)) << "by stamps";
  EXPECT_FALSE(patience.lasts("gps", 100.0, 10.0)) << "it has waited in vain";
  EXPECT_FALSE(patience.lasts("other", 102.0, 13.0)) << "stamps stand still";
}

}  // namespace
}  // namespace multipath_localization
