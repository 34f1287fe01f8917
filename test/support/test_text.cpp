#include <gtest/gtest.h>

#include "support/text.hpp"

namespace multipath_localization {
namespace {

TEST(Trimmed, LosesTheBlanksAtItsEndsAlone) {
  EXPECT_EQ(trimmed(" \ta b\r", " \t\r"), "a b");
  EXPECT_EQ(trimmed("a", " "), "a");
  EXPECT_EQ(trimmed("\ta ", " "), "\ta");
}

TEST(Trimmed, IsEmptyWhereAllIsBlank) {
  EXPECT_EQ(trimmed("  ", " "), "");
  EXPECT_EQ(trimmed("", " "), "");
}

}  // namespace
}  // namespace multipath_localization
