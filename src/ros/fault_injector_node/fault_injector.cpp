#include "ros/fault_injector_node/fault_injector.hpp"

#include <algorithm>
#include <cmath>

#include "ros/messages/conversions.hpp"
#include "ros/messages/heading_conversions.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

constexpr double kTimeJump = 1.0;  ///< [s]

bool same(const OdometryIncrement& a, const OdometryIncrement& b) {
  return a.speed == b.speed && a.yaw_rate == b.yaw_rate && a.lateral_speed == b.lateral_speed;
}

}  // namespace

void FaultInjectorParameters::fields(ParameterVisitor& field) {
  field("seed", seed, {0, 2147483647}, "1", "of all random numbers: same seed, same faults");
  datum.fields(field);
  faults.fields(field);
}

std::vector<sensor_msgs::NavSatFix> FaultInjector::take(const sensor_msgs::NavSatFix& fix) {
  if (check(fix, FixParameters{}) != Reason::kAccepted) return {fix};
  const double stamp = fix.header.stamp.toSec();
  see(stamp, stamp < last_fix_ - kTimeJump);
  last_fix_ = stamp;
  if (!map_) map_.emplace(parameters_.datum.place(fix.altitude).value_or(to_geodetic(fix)));
  const CheckedFix checked = to_fix(fix, *map_, FixParameters{});
  if (checked.reason != Reason::kAccepted) return {fix};
  if (fix_faults_->take(checked.fix, now_)) taken_fixes_[taken_] = fix;
  ++taken_;
  return release();
}

std::optional<nav_msgs::Odometry> FaultInjector::take(const nav_msgs::Odometry& odometry,
                                                      std::vector<sensor_msgs::NavSatFix>& fixes) {
  const CheckedOdometry checked = reader_.read(odometry);
  if (checked.reason != Reason::kAccepted) return odometry;
  see(checked.increment.stamp, checked.restarted);
  fixes = release();
  nav_msgs::Odometry spoilt = message_of(odometry, checked);
  if (odometry_faults_->next_is_lost(checked.increment.stamp)) return std::nullopt;
  return spoilt;
}

std::vector<sensor_msgs::Imu> FaultInjector::take(const sensor_msgs::Imu& imu) {
  if (imu.header.stamp.isZero()) return {imu};
  const double stamp = imu.header.stamp.toSec();
  see(stamp, false);
  const geometry_msgs::Vector3& rate = imu.angular_velocity;
  if (const auto spoilt = gyro_faults_->spoil(stamp, {rate.x, rate.y, rate.z})) {
    sensor_msgs::Imu message = imu;
    message.angular_velocity = to_message(spoilt->value);
    imus_.send(message, stamp + spoilt->delay);
  }
  return imus_.take(now_);
}

std::vector<geometry_msgs::TwistWithCovarianceStamped> FaultInjector::take(
    const geometry_msgs::TwistWithCovarianceStamped& velocity) {
  if (velocity.header.stamp.isZero()) return {velocity};
  const double stamp = velocity.header.stamp.toSec();
  see(stamp, false);
  const geometry_msgs::Vector3& told = velocity.twist.twist.linear;
  if (const auto spoilt = velocity_faults_->spoil(stamp, {told.x, told.y, told.z})) {
    geometry_msgs::TwistWithCovarianceStamped message = velocity;
    message.twist.twist.linear = to_message(spoilt->value);
    velocities_.send(message, stamp + spoilt->delay);
  }
  return velocities_.take(now_);
}

std::vector<sensor_msgs::Imu> FaultInjector::take_heading(const sensor_msgs::Imu& heading) {
  const CheckedHeading checked = to_heading(heading, {}, Eigen::Quaterniond::Identity());
  if (checked.reason != Reason::kAccepted) return {heading};
  const double stamp = checked.heading.stamp;
  see(stamp, false);
  if (const auto spoilt = heading_faults_->spoil(stamp, {0.0, 0.0, checked.heading.yaw})) {
    sensor_msgs::Imu message = heading;
    message.orientation = to_message(Pose2{0.0, 0.0, spoilt->value.z()}).orientation;
    headings_.send(message, stamp + spoilt->delay);
  }
  return headings_.take(now_);
}

std::string FaultInjector::active() const {
  std::string text;
  if (!fix_faults_) return "none";
  for (const auto& faults :
       {fix_faults_->active(now_), odometry_faults_->active(now_), gyro_faults_->active(now_),
        velocity_faults_->active(now_), heading_faults_->active(now_)}) {
    for (const std::string& fault : faults) text += (text.empty() ? "" : "\n") + fault;
  }
  return text.empty() ? "none" : text;
}

void FaultInjector::see(double stamp, bool restarted) {
  if (!fix_faults_ || restarted) begin(stamp);
  now_ = std::max(now_, stamp);
}

void FaultInjector::begin(double stamp) {
  const auto seed = static_cast<std::uint64_t>(parameters_.seed);
  fix_faults_.emplace(parameters_.faults.fix, seed, stamp);
  odometry_faults_.emplace(parameters_.faults.odometry, seed, stamp);
  gyro_faults_.emplace(parameters_.faults.gyro, "gyro", seed, kGyroFaultStream, stamp);
  velocity_faults_.emplace(parameters_.faults.velocity, "velocity", seed, kVelocityFaultStream, stamp);
  heading_faults_.emplace(parameters_.faults.heading, "heading", seed, kHeadingFaultStream, stamp);
  imus_ = {};
  headings_ = {};
  velocities_ = {};
  now_ = last_fix_ = stamp;
  taken_ = 0;
  taken_fixes_.clear();
  spoilt_in_odom_.reset();
  if (!parameters_.datum.given()) map_.reset();
}

std::vector<sensor_msgs::NavSatFix> FaultInjector::release() {
  std::vector<sensor_msgs::NavSatFix> out;
  std::size_t needed = taken_;
  for (const SpoiltFix& spoilt : fix_faults_->release(now_)) {
    out.push_back(message_of(spoilt));
    needed = std::min(needed, spoilt.shown);
  }
  if (!out.empty()) taken_fixes_.erase(taken_fixes_.begin(), taken_fixes_.lower_bound(needed));
  return out;
}

sensor_msgs::NavSatFix FaultInjector::message_of(const SpoiltFix& spoilt) const {
  const sensor_msgs::NavSatFix& shown = taken_fixes_.at(spoilt.shown);
  const GnssFix clean = to_fix(shown, *map_, FixParameters{}).fix;
  sensor_msgs::NavSatFix message = shown;
  message.header = taken_fixes_.at(spoilt.source).header;
  message.status = taken_fixes_.at(spoilt.source).status;
  if (const std::optional<int> status = fix_faults_->status(spoilt.fix.stamp)) {
    message.status.status = static_cast<std::int8_t>(*status);
  }
  if (spoilt.fix.position != clean.position) {
    const Geodetic place = map_->to_geodetic(spoilt.fix.position);
    message.latitude = place.latitude_deg;
    message.longitude = place.longitude_deg;
  }
  const double factor = spoilt.fix.covariance(0, 0) / clean.covariance(0, 0);
  for (double& entry : message.position_covariance) entry *= factor;
  return message;
}

nav_msgs::Odometry FaultInjector::message_of(const nav_msgs::Odometry& odometry,
                                             const CheckedOdometry& checked) {
  const OdometryIncrement motion = odometry_faults_->distorted(checked.increment);
  const bool changed = !same(motion, checked.increment);
  if (changed && !spoilt_in_odom_) spoilt_in_odom_ = last_in_odom_;
  if (spoilt_in_odom_) {
    const Pose2 moved = inverse(last_in_odom_) * checked.base_in_odom;
    spoilt_in_odom_ = *spoilt_in_odom_ * (changed ? displacement(motion) : moved);
  }
  last_in_odom_ = checked.base_in_odom;
  nav_msgs::Odometry message = changed ? with_motion(odometry, motion) : odometry;
  if (spoilt_in_odom_) {
    const double height = odometry.pose.pose.position.z;
    message.pose.pose = to_message(*spoilt_in_odom_);
    message.pose.pose.position.z = height;
  }
  return message;
}

}  // namespace multipath_localization
