#include "ros/messages/conversions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/core/fix_check.hpp"

namespace multipath_localization {

namespace {

const Eigen::Vector3d kDefaultPoseSigmas(0.5, 0.5, kPi / 12.0);  ///< x, y, yaw as amcl starts from
constexpr std::size_t kLongestFrame = 256;
constexpr double kShortestBaseline = 0.01;
constexpr std::size_t kX = 0, kY = 7, kYaw = 35, kXY = 1, kXYaw = 5, kYYaw = 11;       ///< in a row-major 6x6
constexpr std::size_t kEast = 0, kEastNorth = 1, kNorthEast = 3, kNorth = 4, kUp = 8;  ///< in a row-major 3x3

double length_of(const geometry_msgs::Quaternion& q) { return Eigen::Vector4d(q.x, q.y, q.z, q.w).norm(); }

bool declares_none(const sensor_msgs::NavSatFix& message) {
  const auto& covariance = message.position_covariance;
  return message.position_covariance_type == sensor_msgs::NavSatFix::COVARIANCE_TYPE_UNKNOWN ||
         covariance[kEast] == 0.0 || covariance[kNorth] == 0.0;
}

Eigen::Matrix2d horizontal(const sensor_msgs::NavSatFix& message) {
  const auto& covariance = message.position_covariance;
  const bool full = message.position_covariance_type == sensor_msgs::NavSatFix::COVARIANCE_TYPE_KNOWN;
  return (Eigen::Matrix2d() << covariance[kEast], full ? covariance[kEastNorth] : 0.0,
          full ? covariance[kNorthEast] : 0.0, covariance[kNorth])
      .finished();
}

bool usable_covariance(const sensor_msgs::NavSatFix& message, double largest_sigma) {
  if (message.position_covariance_type > sensor_msgs::NavSatFix::COVARIANCE_TYPE_KNOWN) return false;
  if (message.position_covariance_type == sensor_msgs::NavSatFix::COVARIANCE_TYPE_UNKNOWN) return true;
  const Eigen::Matrix2d declared = horizontal(message);
  const bool in_range = declared.allFinite() && declared.diagonal().minCoeff() >= 0.0 &&
                        declared.cwiseAbs().maxCoeff() <= largest_sigma * largest_sigma;
  return in_range && (declares_none(message) || positive_semi_definite(declared));
}

/// As claimed; a status that NavSatStatus does not know tells nothing.
FixStatus status_of(const sensor_msgs::NavSatFix& message) {
  const int status = message.status.status;
  const bool known = status >= sensor_msgs::NavSatStatus::STATUS_NO_FIX &&
                     status <= sensor_msgs::NavSatStatus::STATUS_GBAS_FIX;
  return known ? static_cast<FixStatus>(status) : FixStatus::kSingle;
}

}  // namespace

std::string without_slash(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

bool is_short(const std::string& frame) { return frame.size() <= kLongestFrame; }

std::string shown(const std::string& frame) {
  return is_short(frame) ? frame : frame.substr(0, kLongestFrame) + "...";
}

void FixParameters::fields(ParameterVisitor& field) {
  field("default_sigma", default_sigma, {1e-3, 1e3}, "m",
        "of a fix whose covariance is zero or of unknown type");
  field("largest_sigma", largest_sigma, {1.0, 1e6}, "m", "a fix that declares more is refused");
  field("reach", reach, {100.0, 1e6}, "m", "a fix further from the datum is refused");
  field("min_fix_status", min_fix_status, {-1, 2}, "1",
        "NavSatStatus a fix needs: -1 any, 0 fix, 1 satellite, 2 ground-based augmentation");
}

Geodetic to_geodetic(const sensor_msgs::NavSatFix& message) {
  return {message.latitude, message.longitude, message.altitude};
}

double declared_sigma(const sensor_msgs::NavSatFix& message) {
  if (declares_none(message)) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(0.5 * (message.position_covariance[kEast] + message.position_covariance[kNorth]));
}

Reason check(const sensor_msgs::NavSatFix& message, const FixParameters& parameters) {
  if (message.header.stamp.isZero()) return Reason::kZeroStamp;
  if (!is_short(message.header.frame_id)) return Reason::kInvalidFrame;
  if (message.status.status < parameters.min_fix_status) return Reason::kNoFix;
  if (!std::isfinite(message.latitude) || !std::isfinite(message.longitude)) return Reason::kNotFinite;
  if (!valid(to_geodetic(message))) return Reason::kInvalidPosition;
  if (message.latitude == 0.0 && message.longitude == 0.0) return Reason::kInvalidPosition;
  if (!usable_covariance(message, parameters.largest_sigma)) return Reason::kInvalidCovariance;
  return Reason::kAccepted;
}

CheckedFix to_fix(const sensor_msgs::NavSatFix& message, const LocalFrame& map,
                  const FixParameters& parameters, const Eigen::Vector2d& antenna_in_base) {
  CheckedFix checked;
  checked.reason = check(message, parameters);
  if (checked.reason != Reason::kAccepted) return checked;
  checked.fix.stamp = message.header.stamp.toSec();
  checked.fix.position = map.to_map(to_geodetic(message));
  checked.fix.antenna_in_base = antenna_in_base;
  checked.fix.status = status_of(message);
  checked.fix.covariance =
      declares_none(message)
          ? Eigen::Matrix2d(Eigen::Matrix2d::Identity() * std::pow(parameters.default_sigma, 2))
          : symmetric<2>(horizontal(message));
  if (!(checked.fix.position.norm() <= parameters.reach)) checked.reason = Reason::kInvalidPosition;
  return checked;
}

sensor_msgs::NavSatFix to_message(const GnssFix& fix, const LocalFrame& map, const std_msgs::Header& header) {
  const Geodetic point = map.to_geodetic(fix.position);
  sensor_msgs::NavSatFix message;
  message.header = header;
  message.status.status = static_cast<std::int8_t>(fix.status);
  message.status.service = sensor_msgs::NavSatStatus::SERVICE_GPS;
  message.latitude = point.latitude_deg;
  message.longitude = point.longitude_deg;
  message.altitude = point.altitude;
  message.position_covariance[kEast] = fix.covariance(0, 0);
  message.position_covariance[kEastNorth] = message.position_covariance[kNorthEast] = fix.covariance(0, 1);
  message.position_covariance[kNorth] = fix.covariance(1, 1);
  message.position_covariance[kUp] = 2.0 * fix.covariance.trace();
  message.position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_KNOWN;
  return message;
}

CheckedDual to_dual(const FixPair& message, const LocalFrame& map, const FixParameters& parameters,
                    const Eigen::Vector2d& left_antenna_in_base,
                    const Eigen::Vector2d& right_antenna_in_base) {
  const CheckedFix left = to_fix(message.left, map, parameters, left_antenna_in_base);
  const CheckedFix right = to_fix(message.right, map, parameters, right_antenna_in_base);
  CheckedDual checked;
  checked.reason = left.reason == Reason::kAccepted ? right.reason : left.reason;
  checked.fix = {std::max(left.fix.stamp, right.fix.stamp), left.fix, right.fix};
  const double baseline = (left_antenna_in_base - right_antenna_in_base).norm();
  if (checked.reason == Reason::kAccepted && baseline < kShortestBaseline) {
    checked.reason = Reason::kInvalidFrame;
  }
  return checked;
}

std::optional<Eigen::Vector2d> to_position(const geometry_msgs::Pose& pose) {
  const geometry_msgs::Point& p = pose.position;
  for (const double coordinate : {p.x, p.y, p.z}) {
    if (!(std::abs(coordinate) <= kFurthestPose)) return {};
  }
  return Eigen::Vector2d(p.x, p.y);
}

std::optional<Pose2> to_pose2(const geometry_msgs::Pose& pose) {
  const geometry_msgs::Point& p = pose.position;
  const geometry_msgs::Quaternion& q = pose.orientation;
  if (!to_position(pose)) return {};
  if (!has_orientation(pose)) return Pose2{p.x, p.y, 0.0};
  if (!(std::abs(length_of(q) - 1.0) <= kQuaternionTolerance)) return {};
  const double sine = 2.0 * (q.w * q.z + q.x * q.y);
  return Pose2{p.x, p.y, std::atan2(sine, q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z)};
}

bool has_orientation(const geometry_msgs::Pose& pose) { return length_of(pose.orientation) != 0.0; }

geometry_msgs::Pose to_message(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation.z = std::sin(0.5 * pose.yaw);
  message.orientation.w = std::cos(0.5 * pose.yaw);
  return message;
}

geometry_msgs::Vector3 to_message(const Eigen::Vector3d& vector) {
  geometry_msgs::Vector3 message;
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
  return message;
}

Eigen::Vector3d vector_of(const geometry_msgs::Vector3& message) { return {message.x, message.y, message.z}; }

std::string defect_of(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const geometry_msgs::Pose& pose = message.pose.pose;
  const double length = length_of(pose.orientation);
  const std::string number = std::to_string(length);
  if (length == 0.0) return "its quaternion is all zero, which is no orientation";
  if (!std::isfinite(length)) return "its quaternion is not finite";
  if (std::abs(length - 1.0) > kQuaternionTolerance) return "its quaternion is " + number + " long, not 1";
  if (!to_pose2(pose)) return "its position is not finite, or further off than any map reaches";
  return to_prior(message) ? "" : "its covariance in x, y and yaw is not finite or none";
}

std::optional<PosePrior> to_prior(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const std::optional<Pose2> pose = to_pose2(message.pose.pose);
  if (!pose || !has_orientation(message.pose.pose)) return {};
  const auto& covariance = message.pose.covariance;
  PosePrior prior;
  prior.stamp = message.header.stamp.toSec();
  prior.pose = *pose;
  prior.covariance << covariance[kX], covariance[kXY], covariance[kXYaw],  //
      covariance[kXY], covariance[kY], covariance[kYYaw],                  //
      covariance[kXYaw], covariance[kYYaw], covariance[kYaw];
  if (prior.covariance.isZero(0.0)) prior.covariance.diagonal() = kDefaultPoseSigmas.cwiseAbs2();
  return usable(prior) ? std::optional<PosePrior>(prior) : std::nullopt;
}

nav_msgs::Odometry with_motion(nav_msgs::Odometry odometry, const OdometryIncrement& motion) {
  odometry.twist.twist = geometry_msgs::Twist();
  odometry.twist.twist.linear.x = motion.speed;
  odometry.twist.twist.linear.y = motion.lateral_speed;
  odometry.twist.twist.angular.z = motion.yaw_rate;
  auto& covariance = odometry.twist.covariance;
  if (!std::all_of(covariance.begin(), covariance.end(), [](double c) { return std::isfinite(c); })) {
    covariance.assign(0.0);
  }
  return odometry;
}

geometry_msgs::Transform to_transform(const Pose2& child_in_parent) {
  const geometry_msgs::Pose pose = to_message(child_in_parent);
  geometry_msgs::Transform transform;
  transform.translation.x = pose.position.x;
  transform.translation.y = pose.position.y;
  transform.rotation = pose.orientation;
  return transform;
}

}  // namespace multipath_localization
