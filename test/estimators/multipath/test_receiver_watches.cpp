#include <gtest/gtest.h>

#include "estimators/multipath/receiver_watches.hpp"

namespace multipath_localization::multipath {
namespace {

GnssFix some_fix() {
  GnssFix fix;
  fix.covariance.setIdentity();
  return fix;
}

TEST(ReceiverWatches, FindsTheOneWhoseFixesWaitForOthers) {
  ReceiverWatches watches;
  watches.of(0, 0.0);
  ReceiverWatch& second = watches.of(1, 0.0);
  EXPECT_EQ(watches.overdue(10.0), nullptr);
  second.add(some_fix(), 5.0);
  EXPECT_EQ(watches.overdue(10.0), &second);
  second.take(10.0, 0.0, 0.1);
  EXPECT_EQ(watches.overdue(20.0), nullptr);
}

TEST(ReceiverWatches, TellTheDoubtAboutEachOne) {
  ReceiverWatches watches;
  EXPECT_EQ(watches.doubt(0, 0.0), 0.0);
  ReceiverWatch& first = watches.of(0, 0.0);
  first.add(some_fix(), 60.0);
  first.take(60.0, 0.0, 2.0);
  EXPECT_GT(watches.doubt(0, 60.0), 1.0);
  watches.of(1, 0.0);
  EXPECT_EQ(watches.doubt(1, 60.0), 0.0) << "which no gap has interrupted";
}

}  // namespace
}  // namespace multipath_localization::multipath
