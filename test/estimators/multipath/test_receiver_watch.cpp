#include <gtest/gtest.h>

#include "estimators/multipath/receiver_watch.hpp"

namespace multipath_localization::multipath {
namespace {

GnssFix fix_of(double sigma) {
  GnssFix fix;
  fix.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
  return fix;
}

Sighting sighting_of(ReceiverWatch& watch, double now, double sigma) {
  watch.add(fix_of(sigma), now);
  return watch.take(now, 0.0);
}

TEST(ReceiverWatch, WaitsForASecondOfFixes) {
  ReceiverWatch watch(10.0);
  EXPECT_FALSE(watch.due(10.8));
  EXPECT_TRUE(watch.due(11.0));
  for (int i = 0; i < 5; ++i) watch.add(fix_of(1.0), 10.2 + 0.2 * i);
  EXPECT_EQ(watch.take(11.0, 0.0).duration, 1.0);
  EXPECT_EQ(watch.fixes_in_block(), 5.0);
  EXPECT_FALSE(watch.due(11.8));
}

TEST(ReceiverWatch, TellsThatAReceiverHasFixedItsAmbiguitiesAnew) {
  ReceiverWatch watch(0.0);
  EXPECT_FALSE(sighting_of(watch, 1.0, 0.5).refixed);
  const Sighting refixed = sighting_of(watch, 2.0, 0.02);
  EXPECT_TRUE(refixed.refixed);
  EXPECT_TRUE(refixed.reacquired);
  EXPECT_FALSE(sighting_of(watch, 3.0, 0.02).refixed);
  EXPECT_TRUE(sighting_of(watch, 6.0, 0.02).reacquired);
  EXPECT_FALSE(sighting_of(watch, 8.0, 0.02).reacquired);
}

TEST(ReceiverWatch, DoesNotWaitForFixesThatDoNotCome) {
  ReceiverWatch watch(0.0);
  EXPECT_FALSE(watch.overdue(5.0));
  watch.add(fix_of(1.0), 5.0);
  EXPECT_FALSE(watch.overdue(5.8));
  EXPECT_TRUE(watch.overdue(6.0));
  watch.take(6.0, 0.0);
  EXPECT_FALSE(watch.overdue(60.0));
}

TEST(ReceiverWatch, TellsThatAReceiverHasBeenAway) {
  ReceiverWatch watch(0.0);
  EXPECT_FALSE(sighting_of(watch, 1.0, 1.0).reacquired);
  EXPECT_TRUE(sighting_of(watch, 20.0, 1.0).reacquired);
}

TEST(ReceiverWatch, KnowsAReceiverThatRepeatsItself) {
  ReceiverWatch watch(0.0);
  EXPECT_FALSE(watch.defect(fix_of(1.0)));
  EXPECT_EQ(watch.defect(fix_of(1.0)), Reason::kFrozen);
}

}  // namespace
}  // namespace multipath_localization::multipath
