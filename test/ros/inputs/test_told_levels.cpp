#include <gtest/gtest.h>

#include "ros/inputs/told_levels.hpp"

namespace multipath_localization {
namespace {

TEST(ToldLevels, AreThoseOfTheSameStampOrTheLastBefore) {
  ToldLevels levels;
  EXPECT_EQ(levels.at(1.0), FixLevel::kUntold);
  levels.add({1.0, FixLevel::kFloat});
  levels.add({2.0, FixLevel::kFixed});
  EXPECT_EQ(levels.at(1.0), FixLevel::kFloat) << "the fix comes late";
  EXPECT_EQ(levels.at(1.999), FixLevel::kFixed) << "the driver rounds";
  EXPECT_EQ(levels.at(2.2), FixLevel::kFixed) << "the level comes late";
  EXPECT_EQ(levels.at(5.0), FixLevel::kUntold) << "it is not told any more";
  EXPECT_EQ(levels.at(0.9), FixLevel::kUntold);
}

TEST(ToldLevels, ForgetTheOldest) {
  ToldLevels levels(2);
  for (const double stamp : {1.0, 2.0, 3.0}) levels.add({stamp, FixLevel::kFixed});
  EXPECT_EQ(levels.at(1.0), FixLevel::kUntold);
  EXPECT_EQ(levels.at(2.0), FixLevel::kFixed);
}

}  // namespace
}  // namespace multipath_localization
