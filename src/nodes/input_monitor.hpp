#pragma once

#include <ros/subscriber.h>
#include <ros/time.h>

#include <map>
#include <string>
#include <vector>

#include "multipath_localization/core/estimate.hpp"

namespace multipath_localization {

/// What came in of one kind of input, on one topic or on several that belong together: how often, how long
/// ago, and what became of it.
class InputMonitor {
 public:
  /// `awaited`: whether the node can use it.
  InputMonitor(std::string what, std::vector<ros::Subscriber> subscribers, bool awaited);

  /// A message has come in.
  void arrived();
  /// What became of it.
  void count(Reason reason) { ++counts_[reason]; }

  /// "odom on /odom (1 publisher)", "dual on /gps/left/fix (1 publisher), /gps/right/fix (0 publishers)"
  [[nodiscard]] std::string described() const;
  /// Since the last message, or since the start [s, wall clock].
  [[nodiscard]] double silence() const { return (ros::WallTime::now() - last_).toSec(); }
  [[nodiscard]] bool seen() const { return messages_ > 0; }
  [[nodiscard]] bool awaited() const { return awaited_; }
  [[nodiscard]] const std::map<Reason, unsigned>& counts() const { return counts_; }
  /// Without those that are of no use whatever they hold.
  [[nodiscard]] unsigned refused() const;

 private:
  std::string what_;
  std::vector<ros::Subscriber> subscribers_;
  bool awaited_;
  ros::WallTime last_ = ros::WallTime::now();
  unsigned messages_ = 0;
  std::map<Reason, unsigned> counts_;
};

}  // namespace multipath_localization
