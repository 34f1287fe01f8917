#include "ros/inputs/fix_pairing.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kLongestWait = 1.0;  ///< [s]
constexpr std::size_t kMostWaiting = 100;

double stamp_of(const sensor_msgs::NavSatFix& fix) { return fix.header.stamp.toSec(); }

template <class From>
void move_to(std::vector<sensor_msgs::NavSatFix>& to, From& from, typename From::iterator begin) {
  to.insert(to.end(), begin, from.end());
  from.erase(begin, from.end());
}

}  // namespace

FixPairing::Outcome FixPairing::add(Side side, const sensor_msgs::NavSatFix& fix) {
  Outcome outcome;
  const double stamp = stamp_of(fix);
  for (Waiting& waiting : waiting_) {
    move_to(outcome.unpaired, waiting,
            std::stable_partition(waiting.begin(), waiting.end(), [&](const auto& w) {
              return std::abs(stamp_of(w) - stamp) <= kLongestWait;
            }));
  }
  Waiting& others = waiting_[side == Side::kLeft ? 1 : 0];
  const auto other = partner(others, stamp);
  if (other == others.end()) {
    Waiting& own = waiting_[side == Side::kLeft ? 0 : 1];
    own.push_back(fix);
    if (own.size() <= kMostWaiting) return outcome;
    outcome.unpaired.push_back(own.front());
    own.pop_front();
    return outcome;
  }
  outcome.pair = side == Side::kLeft ? FixPair{fix, *other} : FixPair{*other, fix};
  others.erase(other);
  return outcome;
}

FixPairing::Waiting::iterator FixPairing::partner(Waiting& others, double stamp) const {
  const auto distance = [&](const sensor_msgs::NavSatFix& fix) { return std::abs(stamp_of(fix) - stamp); };
  const auto nearest = std::min_element(
      others.begin(), others.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return nearest == others.end() || distance(*nearest) <= tolerance_ ? nearest : others.end();
}

std::vector<sensor_msgs::NavSatFix> FixPairing::clear() {
  std::vector<sensor_msgs::NavSatFix> unpaired;
  for (Waiting& waiting : waiting_) move_to(unpaired, waiting, waiting.begin());
  return unpaired;
}

}  // namespace multipath_localization
