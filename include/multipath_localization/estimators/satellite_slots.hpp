#pragma once

#include <optional>
#include <vector>

#include "multipath_localization/core/constellation.hpp"

namespace multipath_localization {

/// Whose number a state is: a satellite's bias or, without a satellite, the offset of a constellation's
/// clock.
struct SlotOwner {
  Constellation constellation = Constellation::kGps;
  std::optional<int> satellite;

  bool operator==(const SlotOwner& other) const {
    return constellation == other.constellation && satellite == other.satellite;
  }
};

/// Which state past the fixed ones belongs to whom: satellites rise and set, states come and go. The same for
/// all hypotheses of a bank, which follow each change.
class SatelliteSlots {
 public:
  static constexpr int kCapacity = 40;

  [[nodiscard]] int size() const { return static_cast<int>(slots_.size()); }
  [[nodiscard]] bool full() const { return size() == kCapacity; }
  [[nodiscard]] const SlotOwner& owner(int slot) const {
    return slots_[static_cast<std::size_t>(slot)].owner;
  }

  /// The owner's slot, which counts as seen at `now` [s].
  std::optional<int> find(const SlotOwner& owner, double now);

  /// Gives a new slot, the last; there must be room.
  int append(const SlotOwner& owner, double now);

  /// The satellite unseen for longest, if it was last seen before `stamp` [s]. Offsets of constellations
  /// stay.
  [[nodiscard]] std::optional<int> stale(double stamp) const;

  /// Takes a slot back; the last one moves into its place.
  void remove(int slot);

 private:
  struct Slot {
    SlotOwner owner;
    double last_seen;
  };
  std::vector<Slot> slots_;
};

}  // namespace multipath_localization
