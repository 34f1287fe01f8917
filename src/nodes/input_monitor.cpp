#include "nodes/input_monitor.hpp"

#include <utility>

namespace multipath_localization {

InputMonitor::InputMonitor(std::string what, ros::Subscriber subscriber)
    : what_(std::move(what)), subscriber_(std::move(subscriber)) {}

void InputMonitor::arrived() {
  ++messages_;
  last_ = ros::WallTime::now();
}

std::string InputMonitor::described() const {
  const auto publishers = subscriber_.getNumPublishers();
  return what_ + " on " + subscriber_.getTopic() + " (" + std::to_string(publishers) +
         (publishers == 1 ? " publisher)" : " publishers)");
}

unsigned InputMonitor::refused() const {
  unsigned sum = 0;
  for (const auto& [reason, number] : counts_) sum += reason == Reason::kAccepted ? 0 : number;
  return sum;
}

}  // namespace multipath_localization
