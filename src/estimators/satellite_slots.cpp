#include "multipath_localization/estimators/satellite_slots.hpp"

namespace multipath_localization {

std::optional<int> SatelliteSlots::find(const SlotOwner& owner, double now) {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (!(slots_[i].owner == owner)) continue;
    slots_[i].last_seen = now;
    return static_cast<int>(i);
  }
  return std::nullopt;
}

int SatelliteSlots::append(const SlotOwner& owner, double now) {
  slots_.push_back({owner, now});
  return size() - 1;
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

void SatelliteSlots::remove(int slot) {
  slots_[static_cast<std::size_t>(slot)] = slots_.back();
  slots_.pop_back();
}

}  // namespace multipath_localization
