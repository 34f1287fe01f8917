#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "multipath_localization/FixReport.h"
#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "ros/localization_node/localization_parameters.hpp"
#include "ros/localization_node/odometry_log.hpp"
#include "ros/localization_node/trail.hpp"

namespace multipath_localization {

/// Publishers of localization_node, tf aside. Topics: doc/reference/nodes.md.
class LocalizationOutputs {
 public:
  LocalizationOutputs(ros::NodeHandle node, ros::NodeHandle private_node,
                      const LocalizationParameters& parameters);

  /// The estimate as the pose that belongs to one odometry message; particles, state, markers and path at
  /// most at `cloud_rate`.
  void publish(const Localizer& localizer, const PoseEstimate& estimate, const ReadOdometry& odometry,
               const LocalFrame& map);

  /// The state alone, latched, when it is not the one published last.
  void publish_changed_state(const Localizer& localizer, const ros::Time& stamp);
  /// The same whatever was published last.
  void publish_state(const Localizer& localizer, const ros::Time& stamp);

  /// The fixes of a measurement as they lie in map.
  void publish_fixes(const Measurement& measurement, const GnssMessage& message);

  /// What became of a fix.
  void publish(const FixReport& report) const { report_.publish(report); }

  /// The bias as tracked.
  void publish_bias(const PoseEstimate& estimate, const ros::Time& stamp) const;

  /// Forgets when and what was published, as when the clock has gone back.
  void clear();

 private:
  [[nodiscard]] std_msgs::Header in_map(const ros::Time& stamp) const;
  void publish_fix(const GnssFix& fix, const std_msgs::Header& header);
  void publish_picture(const Localizer& localizer, const PoseEstimate& estimate, const ros::Time& stamp);

  FrameParameters frames_;
  OutputParameters parameters_;
  ros::Publisher odometry_, pose_, cloud_, gps_odometry_, gps_filtered_, bias_, report_, state_, markers_,
      path_;
  Trail trail_;
  std::optional<GnssFix> last_fix_;
  std::optional<Trust> last_state_;
  double last_picture_ = 0.0;
};

}  // namespace multipath_localization
