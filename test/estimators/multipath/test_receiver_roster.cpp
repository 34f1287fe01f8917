#include <gtest/gtest.h>

#include "estimators/multipath/receiver_roster.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(ReceiverRoster, FindsReceiversByNumber) {
  ReceiverRoster roster;
  EXPECT_TRUE(roster.known().empty());
  roster.attended = 2;
  roster.others = {{3, {}, 0.0}, {0, {}, 0.0}};
  EXPECT_EQ(roster.known(), (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(roster.place_of(0), 1u);
  EXPECT_EQ(roster.place_of(2), 2u) << "none of the others";
}

}  // namespace
}  // namespace multipath_localization::multipath
