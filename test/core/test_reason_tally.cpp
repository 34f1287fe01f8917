#include <gtest/gtest.h>

#include "multipath_localization/core/reason_tally.hpp"

namespace multipath_localization {
namespace {

ReasonTally tally(Reason reason, int times) {
  ReasonTally result;
  for (int i = 0; i < times; ++i) result.count(reason);
  return result;
}

TEST(ReasonTally, LosesWhereMoreThanATenthIsRefused) {
  ReasonTally fixes = tally(Reason::kAccepted, 9);
  fixes.count(Reason::kOldStamp);
  EXPECT_FALSE(fixes.loses()) << "one of ten";
  fixes.count(Reason::kOldStamp);
  EXPECT_TRUE(fixes.loses());
  EXPECT_FALSE(tally(Reason::kRepeated, 5).loses()) << "what a parked receiver repeats is no fault";
  EXPECT_FALSE(ReasonTally().loses());
}

TEST(ReasonTally, SaysWhyMostWereRefusedAndSumsUp) {
  ReasonTally fixes = tally(Reason::kOldStamp, 3);
  fixes.add(tally(Reason::kNoFix, 1));
  fixes.add(tally(Reason::kAccepted, 2));
  EXPECT_EQ(fixes.most_frequent_refusal(), Reason::kOldStamp);
  EXPECT_EQ(fixes.refusal().rfind("refused 4 of 6, most often for: old stamp (", 0), 0u) << fixes.refusal();
  EXPECT_EQ(fixes.sum(), "2 of 6 used; no fix 1, old stamp 3");
  fixes.remove(Reason::kNoFix);
  EXPECT_EQ(fixes.sum(), "2 of 5 used; old stamp 3");
  EXPECT_EQ(ReasonTally().most_frequent_refusal(), Reason::kAccepted);
}

TEST(ReasonTally, FallsShortWhereWhatIsWantedIsNotUsed) {
  ReasonTally fixes = tally(Reason::kAccepted, 9);
  fixes.add(tally(Reason::kRepeated, 1));
  fixes.add(tally(Reason::kNotNeeded, 20));
  EXPECT_FALSE(fixes.falls_short());
  fixes.count(Reason::kRepeated);
  EXPECT_TRUE(fixes.falls_short());
  fixes.count(Reason::kFrozen);
  EXPECT_NE(fixes.explained_sum().find("frozen 1, repeated 2 (the same place"), std::string::npos)
      << fixes.explained_sum();
}

}  // namespace
}  // namespace multipath_localization
