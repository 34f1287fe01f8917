#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "multipath_localization/FixReport.h"
#include "multipath_localization/localization/localizer.hpp"
#include "ros/localization_node/backlog.hpp"
#include "ros/localization_node/gnss_inputs.hpp"
#include "ros/localization_node/gyro_input.hpp"
#include "ros/localization_node/localization_parameters.hpp"
#include "ros/localization_node/tf_watch.hpp"
#include "ros/localization_node/tilt_input.hpp"

namespace multipath_localization {

/// All that comes in.
struct LocalizationInputs {
  const GnssInputs& gnss;
  const InputMonitor& odometry;
  const GyroInput& gyro;
  const TiltInput& tilt;
};

/// Statuses on /diagnostics, each one sentence and its figures: odometry, filter, tf, once there are any
/// gyro and tilt, and for each input of GNSS that the estimator uses or that is published one of its name.
class LocalizationDiagnostics {
 public:
  /// Looks at its arguments whenever it reports; they have to outlive it.
  LocalizationDiagnostics(const LocalizationInputs& inputs, const Localizer& localizer, const TfWatch& tf,
                          Backlog& backlog, const LocalizationParameters& parameters);

  /// Publishes all. To be called at a steady rate.
  void report();

  void add(const FixReport& report) { figures_[report.kind] = report; }
  void add_update_time(double seconds) { slowest_update_ = std::max(slowest_update_, seconds); }
  void add_poses(unsigned number) { poses_ += number; }

  /// One sentence on a pause, a restart or a breakdown, shown by `filter` until the next report.
  void note(const std::string& sentence) { note_ = sentence; }
  /// Whether tf knows the frame of an antenna. Returns true when it is not and nobody said so before.
  bool set_antenna_frame(const std::string& frame, bool known);

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  void report_gnss(Status& status, const GnssInput& input);
  void report_odometry(Status& status);
  void report_gyro(Status& status);
  void report_tilt(Status& status);
  void report_filter(Status& status);
  void report_tf(Status& status);

  LocalizationInputs inputs_;
  const Localizer& localizer_;
  const TfWatch& tf_;
  Backlog& backlog_;
  const LocalizationParameters& parameters_;
  std::map<std::string, FixReport> figures_;  ///< the last one of each input
  std::set<std::string> shown_;               ///< inputs that have a status
  unsigned poses_ = 0;
  double slowest_update_ = 0.0;
  std::string note_;
  std::set<std::string> unknown_antenna_frames_;
  diagnostic_updater::Updater updater_;
};

}  // namespace multipath_localization
