#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <string>

#include "multipath_localization/FixReport.h"
#include "multipath_localization/estimators/localizer.hpp"
#include "nodes/input_monitor.hpp"
#include "nodes/tf_watch.hpp"

namespace multipath_localization {

/// Four statuses on /diagnostics, each one sentence and its figures: fix, odometry, filter, tf.
class LocalizationDiagnostics {
 public:
  /// Looks at its arguments whenever it reports; they have to outlive it.
  LocalizationDiagnostics(const InputMonitor& fix, const InputMonitor& odometry, const Localizer& localizer,
                          const TfWatch& tf, const LocalizationParameters& parameters);

  /// Publishes all four and starts new averages. To be called at a steady rate.
  void report() { updater_.force_update(); }

  void add(const FixReport& report);
  void add_update_time(double seconds) { slowest_update_ = std::max(slowest_update_, seconds); }
  void add_pose() { ++poses_; }

  /// One sentence on a pause, a restart or a breakdown, shown by `filter` until the next report.
  void note(const std::string& sentence) { note_ = sentence; }
  /// An antenna frame that tf does not know, empty for none.
  void set_unknown_antenna_frame(const std::string& frame) { unknown_antenna_frame_ = frame; }

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  void report_fix(Status& status);
  void report_odometry(Status& status);
  void report_filter(Status& status);
  void report_tf(Status& status);

  const InputMonitor& fix_;
  const InputMonitor& odometry_;
  const Localizer& localizer_;
  const TfWatch& tf_;
  const LocalizationParameters& parameters_;
  unsigned refused_fixes_ = 0, refused_odometry_ = 0;  ///< at the last report
  unsigned poses_ = 0;
  FixReport last_report_;
  double sum_of_squared_innovations_ = 0.0;
  unsigned innovations_ = 0;
  double slowest_update_ = 0.0;
  std::string note_;
  std::string unknown_antenna_frame_;
  diagnostic_updater::Updater updater_;
};

}  // namespace multipath_localization
