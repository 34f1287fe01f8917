#pragma once

#include <ros/subscriber.h>
#include <ros/time.h>

#include <map>
#include <string>

#include "multipath_localization/core/estimate.hpp"

namespace multipath_localization {

/// What came in on one topic: how often, how long ago, and what became of it.
class InputMonitor {
 public:
  InputMonitor(std::string what, ros::Subscriber subscriber);

  /// A message has come in.
  void arrived();
  /// What became of it.
  void count(Reason reason) { ++counts_[reason]; }

  /// "odom on /odom (1 publisher)"
  [[nodiscard]] std::string described() const;
  /// Since the last message, or since the start [s, wall clock].
  [[nodiscard]] double silence() const { return (ros::WallTime::now() - last_).toSec(); }
  [[nodiscard]] bool seen() const { return messages_ > 0; }
  [[nodiscard]] const std::map<Reason, unsigned>& counts() const { return counts_; }
  [[nodiscard]] unsigned refused() const;

 private:
  std::string what_;
  ros::Subscriber subscriber_;
  ros::WallTime last_ = ros::WallTime::now();
  unsigned messages_ = 0;
  std::map<Reason, unsigned> counts_;
};

}  // namespace multipath_localization
