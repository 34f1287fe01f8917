#include "nodes/fix_ledger.hpp"

#include <algorithm>

namespace multipath_localization {

void FixLedger::open(const sensor_msgs::NavSatFix& fix) { entries_.push_back({fix, ++sequence_}); }

std::optional<FixLedger::Entry> FixLedger::close(double stamp) {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.fix.header.stamp.toSec() == stamp; });
  if (entry == entries_.end()) return {};
  std::optional<Entry> closed(*entry);
  entries_.erase(entry);
  return closed;
}

std::optional<double> FixLedger::oldest() const {
  if (entries_.empty()) return {};
  return entries_.front().fix.header.stamp.toSec();
}

}  // namespace multipath_localization
