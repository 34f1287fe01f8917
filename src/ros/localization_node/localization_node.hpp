#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <multipath_localization/SetPose.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <std_srvs/Empty.h>
#include <std_srvs/SetBool.h>

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ros/localization_node/backlog.hpp"
#include "ros/localization_node/estimate_messages.hpp"
#include "ros/localization_node/frame_patience.hpp"
#include "ros/localization_node/gnss_inputs.hpp"
#include "ros/localization_node/gyro_input.hpp"
#include "ros/localization_node/localization_diagnostics.hpp"
#include "ros/localization_node/localization_outputs.hpp"
#include "ros/localization_node/localization_parameters.hpp"
#include "ros/localization_node/map_services.hpp"
#include "ros/localization_node/map_to_odom.hpp"
#include "ros/localization_node/report_ledger.hpp"
#include "ros/localization_node/tf_watch.hpp"
#include "ros/map/datum.hpp"
#include "ros/parameters/reconfiguration.hpp"
#include "support/background_writer.hpp"

namespace multipath_localization {

/// GNSS, odometry and yaw rates in, the pose in map out, on the stamps of the messages alone.
class LocalizationNode {
 public:
  LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node, const LocalizationSettings& settings);

  /// Takes messages until ROS shuts down.
  void spin();

 private:
  struct ReadOdometry {
    nav_msgs::Odometry message;  ///< its twist is the motion read from it
    Pose2 base_in_odom;
  };

  void on_odometry(const nav_msgs::Odometry::ConstPtr& message);
  void on_yaw_rate(const YawRate& yaw_rate) {
    if (enabled_) localizer_.add(yaw_rate);
  }
  void on_gnss(const GnssMessage& message);
  void on_unpaired(const sensor_msgs::NavSatFix& fix);
  void on_pose(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr& message) { set_pose(*message); }
  bool on_set_pose(SetPose::Request& request, SetPose::Response&) { return set_pose(request.pose); }
  bool on_reset(std_srvs::Empty::Request&, std_srvs::Empty::Response&);
  bool on_toggle(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  /// The antenna of a frame on the base, nothing where tf does not know.
  std::optional<Eigen::Vector2d> antenna_in_base(const std::string& frame);
  /// Whether tf may yet place an antenna of the message and is given a moment to.
  bool waits_for_frame(const GnssMessage& message);
  /// Whether tf has placed an antenna since that was taken to be elsewhere.
  bool antenna_appeared(const GnssMessage& message);
  /// Hands what odometry is held to the localizer.
  void catch_up();
  /// The same, and publishes what comes of it.
  void answer_odometry();
  /// Looks for the datum by a measurement, and weighs what the search lets pass.
  void admit(const GnssMessage& message);
  /// Reads a measurement and hands it to the localizer; refuses it, or lets it wait for its frame.
  void weigh(const GnssMessage& message);
  void weigh_waiting();
  /// Admits a measurement and publishes what comes of it.
  void use(const GnssMessage& message);
  /// Reports a measurement as refused.
  void refuse(const GnssMessage& message, Reason reason, const std::string& detail = "");
  /// Answers the odometry that has no pose as yet: the last message, and at the start those before it,
  /// because the first fix may reach us after odometry that is younger.
  void publish_poses();
  void publish_reports();
  void publish(FixReport report, const Innovation& innovation, const std::string& detail = "");
  [[nodiscard]] ros::Time odometry_stamp() const {
    return odometry_ ? odometry_->message.header.stamp : ros::Time();
  }

  /// Starts the estimator afresh at that pose, or refuses it with a warning.
  bool set_pose(const geometry_msgs::PoseWithCovarianceStamped& message);
  /// Starts the estimator afresh, at the prior if there is one. What had waited is reported as not started.
  void restart(const std::string& why, const std::optional<PosePrior>& prior = std::nullopt);
  /// The same after the stamps of odometry have jumped, forgetting also what was last seen.
  void restart_time(const std::string& why);
  /// The same, and the next odometry is a first one.
  void forget(const std::string& why);
  /// Goes on from the saved pose at the first odometry, or says why not.
  void resume();
  /// Once a second, without waiting for the disk.
  void save_pose(const PoseEstimate& estimate);
  void watch_clock();
  /// Shows all that may change while it runs to a visitor that may change it.
  void tune(ParameterVisitor& field);
  void tell_what_is_missing();
  /// What became of each input, as the node ends: roscpp's console is closed by then.
  void tell_sums() const;

  LocalizationParameters parameters_;
  Localizer localizer_;
  Datum datum_;
  MapServices map_services_;
  OdometryReader odometry_reader_;
  TfWatch tf_;
  MapToOdom map_to_odom_;
  LocalizationOutputs outputs_;
  ReportLedger reports_;
  UsedKinds used_;
  GnssInputs gnss_;
  InputMonitor odometry_input_;
  GyroInput gyro_input_;
  LocalizationDiagnostics diagnostics_;

  Reconfiguration reconfiguration_;
  Backlog backlog_;
  HeldOdometry held_;
  BackgroundWriter pose_writer_;

  bool enabled_ = true;
  bool started_ = false;     ///< odometry was there
  double pose_saved_ = 0.0;  ///< stamp of that odometry [s]
  ros::Time latest_clock_;
  std::optional<ReadOdometry> odometry_;      ///< the last one accepted
  std::deque<ReadOdometry> unanswered_;       ///< those of the last moments without a pose as yet
  std::map<std::size_t, GnssMessage> early_;  ///< by kind, the last that came before any odometry
  std::vector<GnssMessage> unplaced_;         ///< that wait for tf to place their antennas
  FramePatience patience_;
  std::map<std::string, Eigen::Vector2d> assumed_;  ///< antennas that tf did not place, by frame [m]

  ros::Subscriber initial_pose_, pose_to_set_;
  ros::ServiceServer reset_, global_localization_, toggle_, set_pose_;
  ros::Timer tf_timer_;
  ros::WallTimer diagnostics_timer_, waiting_timer_;
};

}  // namespace multipath_localization
