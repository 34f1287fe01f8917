#include <gtest/gtest.h>

#include "estimators/multipath/receiver_watch.hpp"

namespace multipath_localization::multipath {
namespace {

GnssFix fix_of(double sigma) {
  GnssFix fix;
  fix.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
  return fix;
}

Sighting sighting_of(ReceiverWatch& watch, double now, double sigma, double known = 0.1) {
  watch.add(fix_of(sigma), now);
  return watch.take(now, 0.0, known);
}

TEST(ReceiverWatch, WaitsForASecondOfFixes) {
  ReceiverWatch watch(10.0);
  EXPECT_FALSE(watch.due(10.8));
  EXPECT_TRUE(watch.due(11.0));
  for (int i = 0; i < 5; ++i) watch.add(fix_of(1.0), 10.2 + 0.2 * i);
  EXPECT_EQ(watch.take(11.0, 0.0, 0.1).duration, 1.0);
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

TEST(ReceiverWatch, GoesByTheLevelThatAReceiverTellsWhereItTellsOne) {
  ReceiverWatch watch(0.0);
  const auto refixed = [&](double now, FixLevel level, double sigma) {
    GnssFix fix = fix_of(sigma);
    fix.level = level;
    watch.add(fix, now);
    return watch.take(now, 0.0, 0.1).refixed;
  };
  EXPECT_FALSE(refixed(1.0, FixLevel::kFloat, 0.2));
  EXPECT_TRUE(refixed(2.0, FixLevel::kFixed, 0.2)) << "whatever it declares";
  EXPECT_FALSE(refixed(3.0, FixLevel::kFixed, 0.5));
  EXPECT_FALSE(refixed(4.0, FixLevel::kFixed, 0.02)) << "it was fixed all the time";
  EXPECT_FALSE(refixed(5.0, FixLevel::kFloat, 0.02));
}

TEST(ReceiverWatch, TellsTheStatusOfTheFixThatWasWeighedLast) {
  ReceiverWatch watch(0.0);
  GnssFix fix = fix_of(0.02);
  fix.status = FixStatus::kGroundBased;
  watch.add(fix, 1.0);
  watch.take(1.0, 0.0, 0.1);
  EXPECT_EQ(watch.status(), FixStatus::kGroundBased);
}

TEST(ReceiverWatch, DoesNotWaitForFixesThatDoNotCome) {
  ReceiverWatch watch(0.0);
  EXPECT_FALSE(watch.overdue(5.0));
  watch.add(fix_of(1.0), 5.0);
  EXPECT_FALSE(watch.overdue(5.8));
  EXPECT_TRUE(watch.overdue(6.0));
  watch.take(6.0, 0.0, 0.1);
  EXPECT_FALSE(watch.overdue(60.0));
}

TEST(ReceiverWatch, TellsThatAReceiverHasBeenAway) {
  ReceiverWatch watch(0.0);
  EXPECT_FALSE(sighting_of(watch, 1.0, 1.0).reacquired);
  EXPECT_TRUE(sighting_of(watch, 20.0, 1.0).reacquired);
}

TEST(ReceiverWatch, DoubtsAReceiverThatBeginsAnewByNoMoreThanWasKnownWithoutIt) {
  ReceiverWatch watch(0.0);
  sighting_of(watch, 1.0, 0.02, 3.0);
  EXPECT_EQ(watch.doubt(1.0), 0.0) << "nothing has interrupted it";
  sighting_of(watch, 31.0, 0.02, 2.0);
  EXPECT_NEAR(watch.doubt(31.0), 0.3 * 4.0, 1e-9) << "three in ten begin wrong";
  EXPECT_LT(watch.doubt(250.0), 0.4 * watch.doubt(31.0));
  EXPECT_GT(watch.doubt(91.0), 0.6 * watch.doubt(31.0));
  sighting_of(watch, 300.0, 0.02, 1000.0);
  EXPECT_LT(watch.doubt(300.0), 10.0) << "it is off by some metres then, not by the width of a town";
}

TEST(ReceiverWatch, KnowsAReceiverThatRepeatsItself) {
  ReceiverWatch watch(0.0);
  EXPECT_FALSE(watch.defect(fix_of(1.0)));
  EXPECT_EQ(watch.defect(fix_of(1.0)), Reason::kFrozen);
}

}  // namespace
}  // namespace multipath_localization::multipath
