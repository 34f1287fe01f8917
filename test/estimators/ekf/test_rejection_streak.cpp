#include <gtest/gtest.h>

#include "estimators/ekf/rejection_streak.hpp"

namespace multipath_localization {
namespace {

TEST(RejectionStreak, LastsFromTheFirstRejectionToTheLatest) {
  RejectionStreak streak;
  EXPECT_EQ(streak.add(10.0), 0.0);
  EXPECT_EQ(streak.add(11.5), 1.5);
  EXPECT_EQ(streak.add(13.0), 3.0);
}

TEST(RejectionStreak, EndsWithAMeasurementThatPasses) {
  RejectionStreak streak;
  streak.add(10.0);
  streak.end();
  EXPECT_EQ(streak.add(11.0), 0.0);
}

TEST(RejectionStreak, TwoOutliersWithSilenceBetweenThemCountLittle) {
  RejectionStreak streak;
  streak.add(10.0);
  EXPECT_EQ(streak.add(1000.0), RejectionStreak::kLongestPause);
}

TEST(RejectionStreak, GrowsWithSlowMeasurementsToo) {
  RejectionStreak streak;
  for (const double now : {10.0, 20.0, 30.0}) streak.add(now);
  EXPECT_EQ(streak.add(40.0), 3.0 * RejectionStreak::kLongestPause);
}

}  // namespace
}  // namespace multipath_localization
