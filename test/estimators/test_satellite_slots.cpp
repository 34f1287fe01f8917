#include <gtest/gtest.h>

#include "multipath_localization/estimators/satellite_slots.hpp"

namespace multipath_localization {
namespace {

const SlotOwner kOffset{Constellation::kGlonass, std::nullopt};

SlotOwner gps(int satellite) { return {Constellation::kGps, satellite}; }

TEST(SatelliteSlots, FindWhatWasAppended) {
  SatelliteSlots slots;
  EXPECT_EQ(slots.append(gps(3), 0.0), 0);
  EXPECT_EQ(slots.append(kOffset, 0.0), 1);
  EXPECT_EQ(slots.append({Constellation::kGlonass, 3}, 0.0), 2);
  EXPECT_EQ(slots.find(gps(3), 1.0), 0);
  EXPECT_EQ(slots.find(kOffset, 1.0), 1);
  EXPECT_EQ(slots.find({Constellation::kGlonass, 3}, 1.0), 2);
  EXPECT_FALSE(slots.find(gps(4), 1.0));
}

TEST(SatelliteSlots, TheLastMovesIntoTheGap) {
  SatelliteSlots slots;
  for (int i = 0; i < 3; ++i) slots.append(gps(i), 0.0);
  slots.remove(0);
  EXPECT_EQ(slots.size(), 2);
  EXPECT_EQ(slots.find(gps(2), 1.0), 0);
  EXPECT_EQ(slots.find(gps(1), 1.0), 1);
  EXPECT_FALSE(slots.find(gps(0), 1.0));
}

TEST(SatelliteSlots, StaleIsTheSatelliteUnseenForLongest) {
  SatelliteSlots slots;
  slots.append(kOffset, 0.0);
  slots.append(gps(1), 3.0);
  slots.append(gps(2), 2.0);
  slots.append(gps(3), 1.0);
  EXPECT_FALSE(slots.stale(1.0));
  EXPECT_EQ(slots.stale(10.0), 3);
  slots.find(gps(3), 10.0);
  EXPECT_EQ(slots.stale(10.0), 2);
}

TEST(SatelliteSlots, AreFullAtTheirCapacity) {
  SatelliteSlots slots;
  for (int i = 0; i < SatelliteSlots::kCapacity; ++i) {
    EXPECT_FALSE(slots.full());
    slots.append(gps(i), 0.0);
  }
  EXPECT_TRUE(slots.full());
}

}  // namespace
}  // namespace multipath_localization
