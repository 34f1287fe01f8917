#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/NavSatFix.h>

#include <string>
#include <vector>

#include "multipath_localization/FixReport.h"
#include "multipath_localization/GnssBias.h"
#include "multipath_localization/LocalizationState.h"
#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "ros/localization_node/odometry_log.hpp"
#include "ros/messages/gnss_message.hpp"

/// What the estimators know, as messages. Frames and axes: conversions.hpp.
namespace multipath_localization {

/// Row-major 6x6 over x, y, z and turns about fixed axes; z, roll and pitch are zero. The x-y block is that
/// of all hypotheses, so that a consumer is not told more than is known; the rest is that of the dominant
/// one. A tilt is in the orientation alone.
geometry_msgs::PoseWithCovariance to_message(const PoseEstimate& estimate, const Tilt& tilt = {});

/// The estimate in `map_frame`, with stamp, twist and tilt of the odometry it stands for.
nav_msgs::Odometry to_odometry(const PoseEstimate& estimate, const ReadOdometry& odometry,
                               const std::string& map_frame, const std::string& base_frame);

/// A fix in map, without heading; the child frame is that of the antenna.
nav_msgs::Odometry to_odometry(const GnssFix& fix, const std_msgs::Header& fix_header,
                               const std::string& map_frame);

/// At most `max_poses` of the hypotheses, evenly picked.
geometry_msgs::PoseArray to_pose_array(const std::vector<Hypothesis>& hypotheses, std::size_t max_poses,
                                       const std_msgs::Header& header);

GnssBias to_bias(const PoseEstimate& estimate, const std_msgs::Header& header);

LocalizationState to_state(const Localizer& localizer, const std_msgs::Header& header);

/// A report on a measurement that has just come in: what it says of itself.
FixReport to_report(const GnssMessage& message);

/// "declared 0.10 m, observed 4.20 m, using 4.50 m": what there is to say of how far off fixes are.
std::string sigmas_told(const FixReport& report);

/// The report with what became of the measurement, at `now` [s, 0 for not known].
FixReport concluded(FixReport report, const Innovation& innovation, double now);

/// Where the base is on the ellipsoid, at the height of the datum's tangent plane; the height's sigma is 100
/// m. The status claims a fix only while `trust` is above LOST, never an augmentation.
sensor_msgs::NavSatFix to_nav_sat_fix(const PoseEstimate& estimate, Trust trust, const LocalFrame& map,
                                      const std_msgs::Header& header);

/// True when nothing in the estimate would make a message non-finite.
bool finite(const PoseEstimate& estimate);

}  // namespace multipath_localization
