#include "estimators/pseudorange_mixture/satellite_slots.hpp"

#include <algorithm>
#include <limits>

namespace multipath_localization {

std::optional<int> SatelliteSlots::find(const SlotOwner& owner) const {
  for (int slot = 0; slot < size(); ++slot) {
    if (this->owner(slot) == owner) return slot;
  }
  return std::nullopt;
}

double SatelliteSlots::unseen(const SlotOwner& owner, double stamp) const {
  const std::optional<int> slot = find(owner);
  if (!slot) return std::numeric_limits<double>::infinity();
  return std::max(0.0, stamp - slots_[static_cast<std::size_t>(*slot)].last_seen);
}

std::vector<SatelliteSlots::Change> SatelliteSlots::admit(const std::vector<SlotOwner>& seen, double now) {
  for (const SlotOwner& owner : seen) {
    if (const auto slot = find(owner)) slots_[static_cast<std::size_t>(*slot)].last_seen = now;
  }
  std::vector<Change> changes;
  for (const SlotOwner& owner : seen) {
    if (find(owner)) continue;
    if (size() == kCapacity) {
      const std::optional<int> oldest = stale(now);
      if (!oldest) break;
      changes.push_back(remove(*oldest));
    }
    slots_.push_back({owner, now});
    changes.push_back({std::nullopt, owner});
  }
  return changes;
}

std::vector<SatelliteSlots::Change> SatelliteSlots::retire(double stamp) {
  std::vector<Change> changes;
  while (const auto slot = stale(stamp)) changes.push_back(remove(*slot));
  return changes;
}

std::optional<int> SatelliteSlots::stale(double stamp) const {
  std::optional<int> oldest;
  for (int i = 0; i < size(); ++i) {
    const Slot& slot = slots_[static_cast<std::size_t>(i)];
    if (!slot.owner.satellite || slot.last_seen >= stamp) continue;
    stamp = slot.last_seen;
    oldest = i;
  }
  return oldest;
}

SatelliteSlots::Change SatelliteSlots::remove(int slot) {
  slots_[static_cast<std::size_t>(slot)] = slots_.back();
  slots_.pop_back();
  return {slot, {}};
}

}  // namespace multipath_localization
