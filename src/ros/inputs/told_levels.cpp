#include "ros/inputs/told_levels.hpp"

#include <iterator>

namespace multipath_localization {

namespace {

constexpr double kSameInstant = 0.02;  // drivers round nanoseconds in their own ways [s]
constexpr double kLastsAtMost = 2.5;   // a slow receiver's, where its level comes after its fix [s]

}  // namespace

void ToldLevels::add(const ToldLevel& told) {
  told_[told.stamp] = told.level;
  if (told_.size() > most_) told_.erase(told_.begin());
}

FixLevel ToldLevels::at(double stamp) const {
  const auto next = told_.upper_bound(stamp + kSameInstant);
  if (next == told_.begin()) return FixLevel::kUntold;
  const auto& [when, level] = *std::prev(next);
  return stamp - when <= kLastsAtMost ? level : FixLevel::kUntold;
}

}  // namespace multipath_localization
