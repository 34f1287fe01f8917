#include "ros/localization_node/estimate_messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "multipath_localization/core/covariance.hpp"
#include "ros/messages/tilt_conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kUnknownHeightSigma = 100.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kX = 0, kY = 7, kYaw = 35, kXY = 1, kXYaw = 5, kYYaw = 11;  ///< in a row-major 6x6
constexpr std::size_t kYX = 6, kYawX = 30, kYawY = 31;                            ///< their mirror images

}  // namespace

geometry_msgs::PoseWithCovariance to_message(const PoseEstimate& estimate, const Tilt& tilt) {
  geometry_msgs::PoseWithCovariance message;
  message.pose = to_message(estimate.pose);
  message.pose.orientation = to_orientation(estimate.pose.yaw, tilt);
  const Eigen::Matrix3d covariance = covariance_overall(estimate);
  message.covariance[kX] = covariance(0, 0);
  message.covariance[kXY] = message.covariance[kYX] = covariance(0, 1);
  message.covariance[kY] = covariance(1, 1);
  message.covariance[kXYaw] = message.covariance[kYawX] = covariance(0, 2);
  message.covariance[kYYaw] = message.covariance[kYawY] = covariance(1, 2);
  message.covariance[kYaw] = covariance(2, 2);
  return message;
}

nav_msgs::Odometry to_odometry(const PoseEstimate& estimate, const ReadOdometry& odometry,
                               const std::string& map_frame, const std::string& base_frame) {
  nav_msgs::Odometry message;
  message.header.stamp = odometry.message.header.stamp;
  message.header.frame_id = map_frame;
  message.child_frame_id = base_frame;
  message.pose = to_message(estimate, odometry.tilt);
  message.twist = odometry.message.twist;
  return message;
}

nav_msgs::Odometry to_odometry(const GnssFix& fix, const std_msgs::Header& fix_header,
                               const std::string& map_frame) {
  nav_msgs::Odometry message;
  message.header.stamp = fix_header.stamp;
  message.header.frame_id = map_frame;
  message.child_frame_id = without_slash(fix_header.frame_id);
  message.pose.pose = to_message(Pose2{fix.position.x(), fix.position.y(), 0.0});
  message.pose.covariance[kX] = fix.covariance(0, 0);
  message.pose.covariance[kXY] = message.pose.covariance[kYX] = fix.covariance(0, 1);
  message.pose.covariance[kY] = fix.covariance(1, 1);
  message.pose.covariance[kYaw] = kPi * kPi;
  return message;
}

geometry_msgs::PoseArray to_pose_array(const std::vector<Hypothesis>& hypotheses, std::size_t max_poses,
                                       const std_msgs::Header& header) {
  geometry_msgs::PoseArray array;
  array.header = header;
  const std::size_t count = std::min(max_poses, hypotheses.size());
  for (std::size_t i = 0; i < count; ++i) {
    array.poses.push_back(to_message(hypotheses[i * hypotheses.size() / count].pose));
  }
  return array;
}

GnssBias to_bias(const PoseEstimate& estimate, const std_msgs::Header& header) {
  GnssBias message;
  message.header = header;
  message.x = estimate.bias.x();
  message.y = estimate.bias.y();
  message.sigma = std::sqrt(estimate.bias_covariance.trace());
  for (Eigen::Index i = 0; i < 4; ++i) {
    message.covariance[static_cast<std::size_t>(i)] = estimate.bias_covariance(i / 2, i % 2);
  }
  message.shadow_probability = estimate.shadow_probability;
  return message;
}

LocalizationState to_state(const Localizer& localizer, const std_msgs::Header& header) {
  const PoseEstimate estimate = localizer.estimate();
  LocalizationState message;
  message.header = header;
  message.state = static_cast<std::uint8_t>(localizer.state());
  message.name = std::string(to_string(localizer.state()));
  message.reason = localizer.state_reason();
  if (!estimate.valid) return message;
  message.position_sigma = std::sqrt(estimate.position_covariance_overall.trace());
  message.yaw_sigma = std::sqrt(estimate.covariance(2, 2));
  message.dominance = estimate.dominance;
  message.shadow_probability = estimate.shadow_probability;
  message.effective_sample_size = estimate.effective_sample_size;
  return message;
}

FixReport to_report(const GnssMessage& message) {
  FixReport report;
  report.header = header_of(message);
  report.header.frame_id = shown(report.header.frame_id);
  report.kind = name_of(message);
  report.declared_sigma = declared_sigma(message);
  report.observed_sigma = report.used_sigma = kNan;
  report.satellites = static_cast<std::uint32_t>(satellites_of(message));
  return report;
}

std::string sigmas_told(const FixReport& report) {
  std::string text;
  const auto add = [&](const char* what, double sigma) {
    if (!std::isfinite(sigma)) return;
    char figure[50];
    std::snprintf(figure, sizeof(figure), "%s %.2f m", what, sigma);
    text += (text.empty() ? "" : ", ") + std::string(figure);
  };
  add("declared", report.declared_sigma);
  add("observed", report.observed_sigma);
  add("using", report.used_sigma);
  return text;
}

FixReport concluded(FixReport report, const Innovation& innovation, double now) {
  const ros::Time& stamp = report.header.stamp;
  report.accepted = innovation.accepted();
  report.reason = std::string(to_string(innovation.reason));
  report.innovation_x = innovation.innovation.x();
  report.innovation_y = innovation.innovation.y();
  report.nis = innovation.nis;
  report.predicted_sigma = mean_sigma(innovation.covariance);
  report.age = now == 0.0 || stamp.isZero() ? 0.0 : now - stamp.toSec();
  return report;
}

sensor_msgs::NavSatFix to_nav_sat_fix(const PoseEstimate& estimate, Trust trust, const LocalFrame& map,
                                      const std_msgs::Header& header) {
  const Geodetic place = map.to_geodetic(estimate.pose.position());
  const bool trusted = trust == Trust::kGood || trust == Trust::kMultipath || trust == Trust::kDeadReckoning;
  sensor_msgs::NavSatFix message;
  message.header = header;
  message.status.status =
      trusted ? sensor_msgs::NavSatStatus::STATUS_FIX : sensor_msgs::NavSatStatus::STATUS_NO_FIX;
  message.status.service = sensor_msgs::NavSatStatus::SERVICE_GPS;
  message.latitude = place.latitude_deg;
  message.longitude = place.longitude_deg;
  message.altitude = place.altitude;
  const Eigen::Matrix2d& covariance = estimate.position_covariance_overall;
  message.position_covariance = {covariance(0, 0),
                                 covariance(0, 1),
                                 0.0,  //
                                 covariance(1, 0),
                                 covariance(1, 1),
                                 0.0,  //
                                 0.0,
                                 0.0,
                                 kUnknownHeightSigma * kUnknownHeightSigma};
  message.position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_KNOWN;
  return message;
}

bool finite(const PoseEstimate& estimate) {
  return estimate.pose.finite() && estimate.covariance.allFinite() &&
         estimate.position_covariance_overall.allFinite() && estimate.bias.allFinite() &&
         estimate.bias_covariance.allFinite() && estimate.covariance.diagonal().minCoeff() >= 0.0 &&
         estimate.position_covariance_overall.trace() >= 0.0 && estimate.bias_covariance.trace() >= 0.0 &&
         std::isfinite(estimate.dominance) && std::isfinite(estimate.shadow_probability) &&
         std::isfinite(estimate.effective_sample_size);
}

}  // namespace multipath_localization
