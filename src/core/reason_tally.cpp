#include "multipath_localization/core/reason_tally.hpp"

namespace multipath_localization {

std::string_view meaning(Reason reason) {
  switch (reason) {
    case Reason::kZeroStamp: return "its driver does not fill header.stamp in";
    case Reason::kOldStamp:
      return "stamped before the odometry that is kept, localizer/history_length: two clocks? Let doctor "
             "look";
    case Reason::kFutureStamp:
      return "stamped ahead of the odometry by more than localizer/future_tolerance: two clocks, or too "
             "little odometry? Let doctor look";
    case Reason::kNoFix: return "the receiver has no fix, or its status is below fix/min_fix_status";
    case Reason::kInvalidPosition:
      return "out of range, 0, 0, far from the datum, or apart from the others while that was looked for";
    case Reason::kInvalidOrientation:
      return "a quaternion not of length 1, or all zero while the pose moves and the twist does not: its "
             "driver does not fill pose.orientation in";
    case Reason::kInvalidCovariance: return "negative, not finite or above fix/largest_sigma squared";
    case Reason::kInvalidFrame: return "not placed on the robot by tf, or not of this input";
    case Reason::kNotStarted: return "there was no odometry, or no datum";
    case Reason::kFrozen: return "the same place while the robot drives: restart the receiver's driver";
    case Reason::kGated: return "too far from the pose to be believed by this estimator";
    default: return "";
  }
}

void ReasonTally::add(const ReasonTally& other) {
  for (const auto& [reason, number] : other.counts_) counts_[reason] += number;
}

void ReasonTally::remove(Reason reason) {
  const auto counted = counts_.find(reason);
  if (counted != counts_.end() && --counted->second == 0) counts_.erase(counted);
}

unsigned ReasonTally::total() const {
  unsigned sum = 0;
  for (const auto& [reason, number] : counts_) sum += number;
  return sum;
}

unsigned ReasonTally::of(Reason reason) const {
  const auto counted = counts_.find(reason);
  return counted == counts_.end() ? 0 : counted->second;
}

unsigned ReasonTally::refused() const {
  unsigned sum = 0;
  for (const auto& [reason, number] : counts_) sum += is_fault(reason) ? number : 0;
  return sum;
}

Reason ReasonTally::most_frequent_refusal() const {
  Reason found = Reason::kAccepted;
  for (const auto& [reason, number] : counts_) {
    if (is_fault(reason) && (found == Reason::kAccepted || number > counts_.at(found))) found = reason;
  }
  return found;
}

bool ReasonTally::falls_short() const {
  const unsigned wanted = total() - of(Reason::kUnused) - of(Reason::kNotNeeded);
  return 10 * of(Reason::kAccepted) < 9 * wanted;
}

std::string ReasonTally::explained_sum() const {
  const std::string_view means = meaning(most_frequent_refusal());
  return sum() + (means.empty() ? "" : " (" + std::string(means) + ")");
}

std::string ReasonTally::refusal() const {
  const Reason why = most_frequent_refusal();
  const std::string_view means = meaning(why);
  return "refused " + std::to_string(refused()) + " of " + std::to_string(total()) +
         ", most often for: " + std::string(to_string(why)) +
         (means.empty() ? "" : " (" + std::string(means) + ")");
}

std::string ReasonTally::sum() const {
  std::string text = std::to_string(of(Reason::kAccepted)) + " of " + std::to_string(total()) + " used";
  const char* separator = "; ";
  for (const auto& [reason, number] : counts_) {
    if (reason == Reason::kAccepted) continue;
    text += separator + std::string(to_string(reason)) + " " + std::to_string(number);
    separator = ", ";
  }
  return text;
}

}  // namespace multipath_localization
