#include "estimators/multipath/receiver_watches.hpp"

#include <algorithm>
#include <limits>

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

double ReceiverWatches::least_doubt(double now) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [number, watch] : watches_) least = std::min(least, watch.doubt(now));
  return watches_.empty() ? 0.0 : least;
}

}  // namespace multipath_localization::multipath
