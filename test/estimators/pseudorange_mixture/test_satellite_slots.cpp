#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pseudorange_mixture/satellite_slots.hpp"

namespace multipath_localization {
namespace {

const SlotOwner kOffset{Constellation::kGlonass, std::nullopt};

SlotOwner gps(int satellite) { return {Constellation::kGps, satellite}; }

std::vector<SlotOwner> satellites(int first, int count) {
  std::vector<SlotOwner> owners;
  for (int i = first; i < first + count; ++i) owners.push_back(gps(i));
  return owners;
}

/// What a hypothesis knows of its slots that follows the changes: whose each is.
class Follower {
 public:
  void follow(const std::vector<SatelliteSlots::Change>& changes) {
    for (const SatelliteSlots::Change& change : changes) {
      if (!change.removed) {
        owners_.push_back(change.appended);
        continue;
      }
      owners_[static_cast<std::size_t>(*change.removed)] = owners_.back();
      owners_.pop_back();
    }
  }

  void expect_as(const SatelliteSlots& slots) const {
    ASSERT_EQ(static_cast<int>(owners_.size()), slots.size());
    for (int slot = 0; slot < slots.size(); ++slot) {
      EXPECT_EQ(slots.find(owners_[static_cast<std::size_t>(slot)]), slot);
    }
  }

 private:
  std::vector<SlotOwner> owners_;
};

TEST(SatelliteSlots, AreGivenInOrder) {
  SatelliteSlots slots;
  slots.admit({gps(3), kOffset, {Constellation::kGlonass, 3}, gps(3)}, 0.0);
  EXPECT_EQ(slots.size(), 3);
  EXPECT_EQ(slots.find(gps(3)), 0);
  EXPECT_EQ(slots.find(kOffset), 1);
  EXPECT_EQ(slots.find({Constellation::kGlonass, 3}), 2);
  EXPECT_FALSE(slots.find(gps(4)));
}

TEST(SatelliteSlots, RetireSatellitesUnseenAndNoOffset) {
  SatelliteSlots slots;
  Follower follower;
  follower.follow(slots.admit({gps(1), kOffset, gps(2), gps(3)}, 0.0));
  follower.follow(slots.admit({gps(2)}, 5.0));
  follower.follow(slots.retire(5.0));
  EXPECT_EQ(slots.size(), 2);
  EXPECT_TRUE(slots.find(kOffset) && slots.find(gps(2)));
  follower.expect_as(slots);
}

TEST(SatelliteSlots, TellForHowLongASatelliteWasUnseen) {
  SatelliteSlots slots;
  slots.admit({gps(1), gps(2)}, 3.0);
  slots.admit({gps(2)}, 5.0);
  EXPECT_DOUBLE_EQ(slots.unseen(gps(1), 5.0), 2.0);
  EXPECT_DOUBLE_EQ(slots.unseen(gps(2), 5.0), 0.0);
  EXPECT_TRUE(std::isinf(slots.unseen(gps(3), 5.0)));
}

TEST(SatelliteSlots, WhereThereIsNoRoomThoseUnseenForLongestGo) {
  SatelliteSlots slots;
  Follower follower;
  follower.follow(slots.admit({kOffset}, 0.0));
  follower.follow(slots.admit({gps(100)}, 2.0));
  follower.follow(slots.admit({gps(101)}, 1.0));
  follower.follow(slots.admit(satellites(0, SatelliteSlots::kCapacity - 3), 3.0));
  EXPECT_EQ(slots.size(), SatelliteSlots::kCapacity);
  follower.follow(slots.admit({gps(200)}, 4.0));
  EXPECT_TRUE(slots.find(gps(100)) && slots.find(kOffset) && slots.find(gps(200)));
  EXPECT_FALSE(slots.find(gps(101)));
  follower.expect_as(slots);
}

TEST(SatelliteSlots, NoneSeenNowGoesForANewcomer) {
  SatelliteSlots slots;
  Follower follower;
  follower.follow(slots.admit(satellites(0, SatelliteSlots::kCapacity), 0.0));
  // Newcomers come first in the list, and more of them than have set.
  std::vector<SlotOwner> seen = satellites(100, 4);
  for (const SlotOwner& owner : satellites(2, SatelliteSlots::kCapacity - 2)) seen.push_back(owner);
  follower.follow(slots.admit(seen, 1.0));
  for (int i = 2; i < SatelliteSlots::kCapacity; ++i) EXPECT_TRUE(slots.find(gps(i))) << i;
  EXPECT_TRUE(slots.find(gps(100)) && slots.find(gps(101)));
  EXPECT_FALSE(slots.find(gps(102)) || slots.find(gps(103)) || slots.find(gps(0)) || slots.find(gps(1)));
  follower.expect_as(slots);
}

}  // namespace
}  // namespace multipath_localization
