#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/localization/localizer.hpp"
#include "ros/localization_node/antenna_placement.hpp"
#include "ros/localization_node/backlog.hpp"
#include "ros/localization_node/gnss_inputs.hpp"
#include "ros/localization_node/localization_diagnostics.hpp"
#include "ros/localization_node/localization_outputs.hpp"
#include "ros/localization_node/map_services.hpp"
#include "ros/localization_node/odometry_log.hpp"
#include "ros/localization_node/report_ledger.hpp"
#include "ros/localization_node/tf_watch.hpp"
#include "ros/localization_node/tilt_input.hpp"

namespace multipath_localization {

/// Brings what receivers say to the localizer, and reports what became of each message, once: it waits for
/// odometry, for map's datum and for its antenna's place on the base, and is refused with a reason.
class GnssPipeline {
 public:
  /// What it works on; all has to outlive it.
  struct Parts {
    const LocalizationParameters& parameters;
    Localizer& localizer;
    Datum& datum;
    MapServices& map_services;
    TfWatch& tf;
    const TiltInput& tilt;
    LocalizationOutputs& outputs;
    LocalizationDiagnostics& diagnostics;
    Backlog& backlog;
    const OdometryLog& odometry;
    const bool& enabled;  ///< messages count
  };
  /// What is asked of the node.
  struct Hooks {
    std::function<void()> watch_clock;  ///< before a message is looked at
    std::function<void()> catch_up;     ///< hands what odometry is held to the localizer
    std::function<void()> answer;       ///< answers odometry by poses
    std::function<void(const std::string& why)> restart;
  };
  GnssPipeline(ros::NodeHandle node, const UsedKinds& used, const Parts& parts, Hooks hooks);

  [[nodiscard]] GnssInputs& inputs() { return inputs_; }

  /// Uses those that came before the first odometry, which is there now.
  void use_early();
  /// Weighs those that waited for tf to place their antennas.
  void weigh_waiting();
  /// Reports what has become of measurements in the localizer.
  void publish_done();
  /// Forgets all that waits, as the localizer starts afresh. It is reported as not started.
  void restart();

 private:
  void on_message(const GnssMessage& message);
  void on_unpaired(const sensor_msgs::NavSatFix& fix);
  /// Admits a measurement and publishes what comes of it.
  void use(const GnssMessage& message);
  /// Looks for the datum by a measurement, and weighs what the search lets pass.
  void admit(const GnssMessage& message);
  /// Reads a measurement and hands it to the localizer; refuses it, or lets it wait for its frame.
  void weigh(const GnssMessage& message);
  /// Reports a measurement as refused.
  void refuse(const GnssMessage& message, Reason reason, const std::string& detail = "");
  void publish(FixReport report, const Innovation& innovation, const std::string& detail = "");
  /// The antenna of a frame on the base as levelled at a stamp [s], nothing where tf does not know.
  std::optional<Eigen::Vector2d> antenna_in_base(const std::string& frame, double stamp);

  Parts parts_;
  Hooks hooks_;
  UsedKinds used_;
  ReportLedger reports_;
  std::map<std::string, GnssMessage> early_;  ///< by name, the last that came before any odometry
  std::vector<GnssMessage> unplaced_;         ///< that wait for tf to place their antennas
  AntennaPlacement antennas_;
  GnssInputs inputs_;
};

}  // namespace multipath_localization
