#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "multipath_localization/core/trust.hpp"

namespace multipath_localization {
namespace {

TEST(Trust, NamesAndNumbersAreThoseOfTheMessage) {
  const std::vector<std::string> names = {"NOT_READY", "ALIGNING",       "GOOD",
                                          "MULTIPATH", "DEAD_RECKONING", "LOST"};
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(to_string(static_cast<Trust>(i)), names[i]);
  EXPECT_EQ(static_cast<int>(Trust::kLost), 5);
}

}  // namespace
}  // namespace multipath_localization
