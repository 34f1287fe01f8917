#include "ros/messages/velocity_conversions.hpp"

#include <cmath>
#include <limits>

#include "multipath_localization/core/covariance.hpp"
#include "ros/messages/conversions.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kEast = 0, kEastNorth = 1, kNorthEast = 6, kNorth = 7,
                      kUp = 14;  ///< in a row-major 6x6

Eigen::Matrix2d horizontal(const geometry_msgs::TwistWithCovarianceStamped& message) {
  const auto& covariance = message.twist.covariance;
  return (Eigen::Matrix2d() << covariance[kEast], covariance[kEastNorth], covariance[kNorthEast],
          covariance[kNorth])
      .finished();
}

Eigen::Vector2d velocity_of(const geometry_msgs::TwistWithCovarianceStamped& message) {
  return {message.twist.twist.linear.x, message.twist.twist.linear.y};
}

bool declares_none(const geometry_msgs::TwistWithCovarianceStamped& message) {
  return message.twist.covariance[kEast] == 0.0 || message.twist.covariance[kNorth] == 0.0;
}

bool usable_covariance(const geometry_msgs::TwistWithCovarianceStamped& message) {
  const Eigen::Matrix2d declared = horizontal(message);
  return declared.allFinite() && (declares_none(message) || positive_semi_definite(declared));
}

}  // namespace

void VelocityParameters::fields(ParameterVisitor& field) {
  field("default_sigma", default_sigma, {1e-3, 10.0}, "m/s", "of a velocity that declares no covariance");
  field("max_speed", max_speed, {1.0, 1e3}, "m/s", "a velocity that claims more is refused");
}

Reason check(const geometry_msgs::TwistWithCovarianceStamped& message, const VelocityParameters& parameters) {
  if (message.header.stamp.isZero()) return Reason::kZeroStamp;
  if (!is_short(message.header.frame_id)) return Reason::kInvalidFrame;
  const Eigen::Vector2d velocity = velocity_of(message);
  if (!velocity.allFinite()) return Reason::kNotFinite;
  if (velocity.norm() > parameters.max_speed) return Reason::kTooFast;
  if (!usable_covariance(message)) return Reason::kInvalidCovariance;
  if (velocity.isZero(0.0) && declares_none(message)) return Reason::kRepeated;
  return Reason::kAccepted;
}

CheckedVelocity to_velocity(const geometry_msgs::TwistWithCovarianceStamped& message,
                            const VelocityParameters& parameters, const Eigen::Vector2d& antenna_in_base) {
  CheckedVelocity checked;
  checked.reason = check(message, parameters);
  if (checked.reason != Reason::kAccepted) return checked;
  GnssVelocity& velocity = checked.velocity;
  velocity.stamp = message.header.stamp.toSec();
  velocity.velocity = velocity_of(message);
  velocity.covariance = declares_none(message)
                            ? Eigen::Matrix2d(square(parameters.default_sigma) * Eigen::Matrix2d::Identity())
                            : symmetric<2>(horizontal(message));
  velocity.antenna_in_base = antenna_in_base;
  return checked;
}

double declared_sigma(const geometry_msgs::TwistWithCovarianceStamped& message) {
  if (declares_none(message)) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(0.5 * (message.twist.covariance[kEast] + message.twist.covariance[kNorth]));
}

geometry_msgs::TwistWithCovarianceStamped without_covariance(const geometry_msgs::TwistStamped& message) {
  geometry_msgs::TwistWithCovarianceStamped result;
  result.header = message.header;
  result.twist.twist = message.twist;
  return result;
}

geometry_msgs::TwistWithCovarianceStamped to_message(const GnssVelocity& velocity,
                                                     const std_msgs::Header& header) {
  geometry_msgs::TwistWithCovarianceStamped message;
  message.header = header;
  message.twist.twist.linear.x = velocity.velocity.x();
  message.twist.twist.linear.y = velocity.velocity.y();
  auto& covariance = message.twist.covariance;
  covariance[kEast] = velocity.covariance(0, 0);
  covariance[kEastNorth] = covariance[kNorthEast] = velocity.covariance(0, 1);
  covariance[kNorth] = velocity.covariance(1, 1);
  covariance[kUp] = 2.0 * velocity.covariance.trace();
  return message;
}

std::optional<geometry_msgs::TwistWithCovarianceStamped> velocity_of(
    const topic_tools::ShapeShifter& message) {
  using Declared = geometry_msgs::TwistWithCovarianceStamped;
  using Bare = geometry_msgs::TwistStamped;
  if (message.getMD5Sum() == ros::message_traits::md5sum<Declared>()) return *message.instantiate<Declared>();
  if (message.getMD5Sum() != ros::message_traits::md5sum<Bare>()) return std::nullopt;
  return without_covariance(*message.instantiate<Bare>());
}

}  // namespace multipath_localization
