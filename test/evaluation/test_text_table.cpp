#include <gtest/gtest.h>

#include "evaluation/text_table.hpp"

namespace multipath_localization {
namespace {

TEST(TextTable, AlignsNamesLeftAndFiguresRight) {
  EXPECT_EQ(side_by_side({{"name", "a"}, {"m", "1.25"}}, 1), "name     m\na     1.25\n");
}

TEST(TextTable, GivesSmallFiguresADigitMoreAndHugeOnesPowersOfTen) {
  EXPECT_EQ(figure(1.234, 2), "1.23");
  EXPECT_EQ(figure(0.0123, 2), "0.012");
  EXPECT_EQ(number(2e7, 1), "2.0e+07");
}

}  // namespace
}  // namespace multipath_localization
