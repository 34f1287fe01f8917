#include <gtest/gtest.h>

#include "rinex/epoch_order.hpp"

namespace multipath_localization {
namespace {

std::vector<std::size_t> kept(const std::vector<double>& seconds) {
  std::vector<GnssTime> times;
  for (const double second : seconds) times.push_back({2320, second});
  return longest_in_order(times);
}

using Places = std::vector<std::size_t>;

TEST(EpochOrder, KeepsWhatIsInOrder) {
  EXPECT_EQ(kept({}), Places());
  EXPECT_EQ(kept({5.0}), Places{0});
  EXPECT_EQ(kept({1.0, 2.0, 3.0}), (Places{0, 1, 2}));
}

TEST(EpochOrder, OfARepeatedTimeTheFirstStays) { EXPECT_EQ(kept({1.0, 1.0, 2.0, 2.0}), (Places{0, 2})); }

TEST(EpochOrder, OneWrongTimeCostsOne) {
  EXPECT_EQ(kept({1.0, 99.0, 2.0, 3.0}), (Places{0, 2, 3}));
  EXPECT_EQ(kept({1.0, 2.0, 0.5, 3.0}), (Places{0, 1, 3}));
  EXPECT_EQ(kept({99.0, 1.0, 2.0}), (Places{1, 2}));
}

TEST(EpochOrder, TheLongerOfTwoPartsStays) { EXPECT_EQ(kept({7.0, 8.0, 1.0, 2.0, 3.0}), (Places{2, 3, 4})); }

TEST(EpochOrder, WeeksCountBeforeSeconds) {
  EXPECT_EQ(longest_in_order({{2320, 604799.0}, {2321, 0.0}, {2320, 604799.5}, {2321, 1.0}}),
            (Places{0, 1, 3}));
}

}  // namespace
}  // namespace multipath_localization
