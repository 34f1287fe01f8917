#include "ros/localization_node/periodic_reports.hpp"

#include <ros/console.h>

#include <iostream>

namespace multipath_localization {

namespace {

constexpr double kReportEvery = 1.0;  ///< [s]
constexpr double kTellEvery = 5.0;    ///< [s]
constexpr double kLongSilence = 5.0;  ///< [s]

}  // namespace

PeriodicReports::PeriodicReports(ros::NodeHandle node, const Parts& parts) : parts_(parts) {
  report_timer_ =
      node.createWallTimer(ros::WallDuration(kReportEvery), [this](const ros::WallTimerEvent&) { report(); });
  missing_timer_ = node.createWallTimer(ros::WallDuration(kTellEvery),
                                        [this](const ros::WallTimerEvent&) { tell_what_is_missing(); });
}

void PeriodicReports::report() {
  parts_.diagnostics.report();
  parts_.gnss.tell_new();
  parts_.gyro.tell(parts_.localizer.gyro());
  parts_.tilt.tell();
}

void PeriodicReports::tell_what_is_missing() const {
  if (!parts_.enabled) return;
  std::string missing;
  if (parts_.odometry.silent(kLongSilence)) missing = parts_.odometry.described();
  if (parts_.gnss.silent(kLongSilence)) missing += (missing.empty() ? "" : ", ") + parts_.gnss.described();
  if (!missing.empty()) ROS_WARN("waiting for: %s", missing.c_str());
}

void PeriodicReports::tell_sums() const {
  std::vector<std::string> sums = parts_.gnss.sums();
  sums.push_back(parts_.odometry.sum());
  sums.push_back(parts_.gyro.monitor().sum());
  for (const std::string& sum : sums) {
    if (!sum.empty()) std::cerr << ros::this_node::getName() << ": " << sum << "\n";
  }
}

}  // namespace multipath_localization
