#include "estimators/multipath/receiver_watches.hpp"

#include <algorithm>

namespace multipath_localization::multipath {

void ReceiverWatches::move(const Pose2& step) {
  for (auto& [number, watch] : watches_) watch.move(step);
}

void ReceiverWatches::begin(double now) {
  for (auto& [number, watch] : watches_) watch.begin(now);
}

ReceiverWatch* ReceiverWatches::overdue(double now) {
  const auto late = std::find_if(watches_.begin(), watches_.end(),
                                 [&](const auto& watch) { return watch.second.overdue(now); });
  return late == watches_.end() ? nullptr : &late->second;
}

double ReceiverWatches::doubt(std::size_t receiver, double now) const {
  const auto watch = watches_.find(receiver);
  return watch == watches_.end() ? 0.0 : watch->second.doubt(now);
}

}  // namespace multipath_localization::multipath
