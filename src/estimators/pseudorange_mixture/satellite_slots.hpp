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
  static constexpr int kCapacity = 64;

  /// What hypotheses do too: take this slot back, the last one moving into its place; or give one more, the
  /// last.
  struct Change {
    std::optional<int> removed;
    SlotOwner appended;
  };

  [[nodiscard]] int size() const { return static_cast<int>(slots_.size()); }
  [[nodiscard]] const SlotOwner& owner(int slot) const {
    return slots_[static_cast<std::size_t>(slot)].owner;
  }

  /// The slot of an owner, if it has one. Good until the next change.
  [[nodiscard]] std::optional<int> find(const SlotOwner& owner) const;

  /// For how long [s] nothing had been seen of an owner at `stamp`; 0 when it was then, infinite when it has
  /// no slot.
  [[nodiscard]] double unseen(const SlotOwner& owner, double stamp) const;

  /// All of these are seen at `now` [s]: gives slots to those that have none, in order and as far as there is
  /// room. It is made by taking back those of the satellites unseen for longest, of none that is seen now.
  /// Gives the changes in their order.
  std::vector<Change> admit(const std::vector<SlotOwner>& seen, double now);

  /// Takes back the slots of satellites last seen before `stamp` [s]. Offsets of constellations stay.
  std::vector<Change> retire(double stamp);

 private:
  struct Slot {
    SlotOwner owner;
    double last_seen;
  };

  /// The satellite unseen for longest, if it was last seen before `stamp` [s].
  [[nodiscard]] std::optional<int> stale(double stamp) const;
  Change remove(int slot);

  std::vector<Slot> slots_;
};

}  // namespace multipath_localization
