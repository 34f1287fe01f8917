#include "ros/bags/bag_refusals.hpp"

namespace multipath_localization {

bool BagRefusals::passes(const std::string& topic, Reason reason) {
  if (reason == Reason::kAccepted) return true;
  ++times_[topic + ": " + std::string(to_string(reason))];
  return false;
}

std::vector<std::string> BagRefusals::lines() const {
  std::vector<std::string> all;
  for (const auto& [refusal, times] : times_) {
    all.push_back(refusal + ", " + std::to_string(times) + " times");
  }
  return all;
}

std::string BagRefusals::in_brackets() const {
  std::string all;
  for (const std::string& line : lines()) all += (all.empty() ? " (" : "; ") + line;
  return all.empty() ? "" : all + ")";
}

}  // namespace multipath_localization
