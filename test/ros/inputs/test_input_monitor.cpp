#include <gtest/gtest.h>

#include "ros/inputs/input_monitor.hpp"

namespace multipath_localization {
namespace {

InputMonitor fixes(Reason reason, int times) {
  InputMonitor monitor("fix", {}, true);
  for (int i = 0; i < times; ++i) {
    monitor.arrived();
    monitor.count(reason);
  }
  return monitor;
}

TEST(InputMonitor, CallsNothingUsedThatIsNot) {
  InputMonitor monitor("fix", {}, true);
  EXPECT_FALSE(monitor.standing().sound);
  EXPECT_EQ(monitor.standing().sentence.rfind("waiting for fix", 0), 0u);
  monitor.arrived();
  EXPECT_EQ(monitor.standing().sentence, "arrives, and waits to be used");
  EXPECT_FALSE(monitor.standing().sound);
  monitor.count(Reason::kAccepted);
  EXPECT_TRUE(monitor.standing().sound);
  EXPECT_EQ(monitor.standing().sentence, "arrives and is used");
  EXPECT_TRUE(fixes(Reason::kRepeated, 5).standing().sound) << "a parked receiver";
  EXPECT_FALSE(fixes(Reason::kOverload, 5).standing().sound);
}

TEST(InputMonitor, StandsByTheLastOutcomesAndNotByTheLastReport) {
  InputMonitor monitor = fixes(Reason::kOldStamp, 3);
  for (int report = 0; report < 3; ++report) {  // between which nothing comes
    EXPECT_FALSE(monitor.standing().sound);
    EXPECT_EQ(monitor.standing().sentence.rfind("refused 3 of 3, most often for: old stamp", 0), 0u);
  }
  for (int i = 0; i < 40; ++i) monitor.count(Reason::kAccepted);
  EXPECT_TRUE(monitor.standing().sound) << "three of 43";
}

TEST(InputMonitor, ComplainsAtOnceAndNotTimeAndAgain) {
  InputMonitor monitor = fixes(Reason::kAccepted, 20);
  EXPECT_EQ(monitor.complaint(), "");
  for (int i = 0; i < 3; ++i) monitor.count(Reason::kInvalidPosition, "5700 km");
  const std::string first = monitor.complaint();
  EXPECT_EQ(first.rfind("fix: refused 3 of 23, most often for: invalid position", 0), 0u) << first;
  EXPECT_NE(first.find(": 5700 km"), std::string::npos) << first;
  monitor.count(Reason::kInvalidPosition);
  EXPECT_EQ(monitor.complaint(), "") << "said a moment ago";
  for (int i = 0; i < 5; ++i) monitor.count(Reason::kNoFix);
  EXPECT_NE(monitor.complaint(), "") << "another reason";
  EXPECT_EQ(monitor.sum(), "fix: 20 of 29 used; invalid position 4, no fix 5");
}

TEST(InputMonitor, IsSilentAboutWhatNobodyAwaits) {
  InputMonitor monitor("epoch", {}, false);
  monitor.count(Reason::kNoFix);
  EXPECT_EQ(monitor.complaint(), "");
}

}  // namespace
}  // namespace multipath_localization
