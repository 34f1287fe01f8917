#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "ros/localization_node/backlog.hpp"
#include "ros/localization_node/gnss_pipeline.hpp"
#include "ros/localization_node/gyro_input.hpp"
#include "ros/localization_node/localization_diagnostics.hpp"
#include "ros/localization_node/localization_outputs.hpp"
#include "ros/localization_node/localization_parameters.hpp"
#include "ros/localization_node/map_services.hpp"
#include "ros/localization_node/odometry_input.hpp"
#include "ros/localization_node/periodic_reports.hpp"
#include "ros/localization_node/pose_answers.hpp"
#include "ros/localization_node/restart_requests.hpp"
#include "ros/localization_node/tf_watch.hpp"
#include "ros/localization_node/tilt_input.hpp"
#include "ros/map/datum.hpp"
#include "ros/parameters/reconfiguration.hpp"

namespace multipath_localization {

/// GNSS, odometry and yaw rates in, the pose in map out, on the stamps of the messages alone.
class LocalizationNode {
 public:
  LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node, const LocalizationSettings& settings);

  /// Takes messages until ROS shuts down.
  void spin();

 private:
  void on_odometry(const nav_msgs::Odometry& message);
  /// Hands what odometry is held to the localizer.
  void catch_up();
  /// Publishes the poses that odometry awaits.
  void answer();
  /// Hands on what odometry is held, and publishes what comes of it.
  void answer_odometry();

  /// Starts the estimator afresh, at the prior if there is one. What had waited is reported as not started.
  void restart(const std::string& why, const std::optional<PosePrior>& prior = std::nullopt);
  /// Restarts after the stamps of odometry have jumped, and forgets what was last seen.
  void restart_time(const std::string& why);
  /// Restarts, and the next odometry is a first one.
  void forget(const std::string& why);
  /// Goes on from the saved pose at the first odometry, or says why not.
  void resume();
  /// Forgets all when the clock has gone back.
  void watch_clock();
  /// Shows all that may change while it runs to a visitor that may change it.
  void tune(ParameterVisitor& field);

  LocalizationParameters parameters_;
  Localizer localizer_;
  Datum datum_;
  MapServices map_services_;
  TfWatch tf_;
  LocalizationOutputs outputs_;
  PoseAnswers answers_;
  RestartRequests requests_;
  OdometryInput odometry_;
  TiltInput tilt_;
  GnssPipeline gnss_;
  GyroInput gyro_;
  LocalizationDiagnostics diagnostics_;
  PeriodicReports reports_;
  Reconfiguration reconfiguration_;
  Backlog backlog_;
  ros::Timer tf_timer_;
  ros::Time latest_clock_;
};

}  // namespace multipath_localization
