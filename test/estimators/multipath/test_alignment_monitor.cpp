#include <gtest/gtest.h>

#include "estimators/multipath/alignment_monitor.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(AlignmentMonitor, WantsAWayAndAHeading) {
  AlignmentMonitor monitor(false);
  EXPECT_GT(monitor.way_left(), 5.0);
  monitor.update(3.0, 0.001, false);
  EXPECT_FALSE(monitor.aligned()) << "too little driving";
  monitor.update(20.0, 1.0, false);
  EXPECT_EQ(monitor.way_left(), 0.0);
  EXPECT_FALSE(monitor.aligned()) << "the heading is not known";
  monitor.update(0.0, 0.001, false);
  EXPECT_TRUE(monitor.aligned());
}

TEST(AlignmentMonitor, StaysAlignedUntilTheHeadingIsLost) {
  AlignmentMonitor monitor(true);
  monitor.update(0.0, 0.01, false);
  EXPECT_TRUE(monitor.aligned());
  monitor.update(0.0, 0.1, false);
  EXPECT_TRUE(monitor.aligned()) << "more than it takes, less than is lost";
  monitor.update(0.0, 0.5, false);
  EXPECT_FALSE(monitor.aligned());
  monitor.update(0.0, 0.1, false);
  EXPECT_FALSE(monitor.aligned());
}

TEST(AlignmentMonitor, HoldsAConfirmedPoseToBeSoAsLongAsItWouldHaveBeen) {
  AlignmentMonitor confirmed(true);
  confirmed.update(0.0, 0.1, false);
  EXPECT_TRUE(confirmed.aligned());
  AlignmentMonitor doubtful(true);
  doubtful.update(0.0, 0.5, false);
  EXPECT_FALSE(doubtful.aligned());
}

}  // namespace
}  // namespace multipath_localization::multipath
