#include "nodes/input_monitor.hpp"

#include <utility>

namespace multipath_localization {

InputMonitor::InputMonitor(std::string what, std::vector<ros::Subscriber> subscribers, bool awaited)
    : what_(std::move(what)), subscribers_(std::move(subscribers)), awaited_(awaited) {}

void InputMonitor::arrived() {
  ++messages_;
  last_ = ros::WallTime::now();
}

std::string InputMonitor::described() const {
  std::string text = what_ + " on ";
  const char* separator = "";
  for (const ros::Subscriber& subscriber : subscribers_) {
    const auto publishers = subscriber.getNumPublishers();
    text += separator + subscriber.getTopic() + " (" + std::to_string(publishers) +
            (publishers == 1 ? " publisher)" : " publishers)");
    separator = ", ";
  }
  return text;
}

unsigned InputMonitor::refused() const {
  unsigned sum = 0;
  for (const auto& [reason, number] : counts_) {
    if (is_fault(reason)) sum += number;
  }
  return sum;
}

}  // namespace multipath_localization
