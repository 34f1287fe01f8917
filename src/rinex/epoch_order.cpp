#include "rinex/epoch_order.hpp"

#include <algorithm>

namespace multipath_localization {

std::vector<std::size_t> longest_in_order(const std::vector<GnssTime>& times) {
  const auto later = [](const GnssTime& a, const GnssTime& b) { return b < a; };
  std::vector<std::size_t> length(times.size());  // of the longest series that begins there
  std::vector<GnssTime> latest;                   // beginning of a series of 1, 2, ... times
  for (std::size_t i = times.size(); i-- > 0;) {
    const auto place = std::lower_bound(latest.begin(), latest.end(), times[i], later);
    length[i] = static_cast<std::size_t>(place - latest.begin()) + 1;
    if (place == latest.end()) {
      latest.push_back(times[i]);
    } else {
      *place = times[i];
    }
  }
  std::vector<std::size_t> places;
  std::size_t left = latest.size();
  for (std::size_t i = 0; i < times.size() && left > 0; ++i) {
    if (length[i] != left || (!places.empty() && !(times[places.back()] < times[i]))) continue;
    places.push_back(i);
    --left;
  }
  return places;
}

}  // namespace multipath_localization
