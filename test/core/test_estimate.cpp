#include <gtest/gtest.h>

#include <set>
#include <string>

#include "multipath_localization/core/estimate.hpp"

namespace multipath_localization {
namespace {

TEST(Reason, EachHasATextOfItsOwn) {
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(Reason::kOverload); ++i) {
    const std::string text(to_string(static_cast<Reason>(i)));
    EXPECT_NE(text, "unknown") << i;
    EXPECT_TRUE(texts.insert(text).second) << text;
  }
}

TEST(Innovation, IsAcceptedForOneReasonOnly) {
  for (int i = 0; i <= static_cast<int>(Reason::kOverload); ++i) {
    const auto reason = static_cast<Reason>(i);
    EXPECT_EQ(refused(reason).accepted(), reason == Reason::kAccepted);
    EXPECT_EQ(refused(reason).reason, reason);
  }
  EXPECT_FALSE(Innovation{}.accepted());
}

TEST(Reason, WhatIsOfNoUseWhateverItHoldsIsNoFault) {
  EXPECT_FALSE(is_fault(Reason::kAccepted));
  EXPECT_FALSE(is_fault(Reason::kUnused));
  EXPECT_FALSE(is_fault(Reason::kNotNeeded));
  EXPECT_FALSE(is_fault(Reason::kRepeated));
  EXPECT_FALSE(is_fault(Reason::kOverload));
  EXPECT_TRUE(is_fault(Reason::kGated));
}

TEST(PoseEstimate, CountsForNothingUntilMeasured) {
  EXPECT_FALSE(PoseEstimate{}.valid);
  EXPECT_FALSE(PoseEstimate{}.aligned);
}

}  // namespace
}  // namespace multipath_localization
