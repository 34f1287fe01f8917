#include "multipath_localization/guidance/path_driver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/guidance/path_tracking.hpp"

namespace multipath_localization {

namespace {

/// Of the settling length over the speed [s]: four times the lag of steering and pose of slow bases, from
/// where on a lag leaves no overshoot of more than a tenth.
constexpr double kSettlingTime = 0.8;
constexpr double kSettlingRadii = 0.6;     // turning circles' radii that coming onto a line takes at least
constexpr double kShortestSettling = 0.5;  // below, it is the noise of poses that is followed [m]
constexpr double kPlannedBraking = 0.8;    // of the deceleration allowed: the rest makes up for delays
constexpr double kFacingAside = 1.2;       // of the path: more than it is ever approached at [rad]
constexpr double kFacing = 0.1;            // along the path [rad]
constexpr double kShortestMean = 0.05;     // of the curvature along the path [m]

SpeedLimits limits_of(const WaypointFollowerParameters& p) {
  const double most =
      p.limits.differential() ? p.limits.max_yaw_rate : std::numeric_limits<double>::infinity();
  const double braking = kPlannedBraking * p.limits.max_deceleration;
  return {p.cruise_speed, p.max_lateral_acceleration, braking,
          most,           p.tightest_curvature(),     p.limits.braking_delay(braking)};
}

}  // namespace

double spin_towards(double turn, const CommandLimits& limits) {
  const double braked = std::sqrt(2.0 * kPlannedBraking * limits.max_yaw_acceleration * std::abs(turn));
  return std::copysign(std::min(braked, limits.max_yaw_rate), turn);
}

PathDriver::PathDriver(const WaypointFollowerParameters& parameters, PathProgress progress,
                       const PathPlan& plan)
    : parameters_(parameters),
      progress_(std::move(progress)),
      speed_(progress_.path(), limits_of(parameters), plan.end_speed, plan.zones),
      reverse_(plan.reverse) {}

Pose2 PathDriver::leading(const Pose2& pose) const {
  return reverse_ ? Pose2{pose.x, pose.y, wrap_angle(pose.yaw + kPi)} : pose;
}

PathCommand PathDriver::command(const Pose2& pose, double most) {
  const Pose2 ahead = leading(pose);
  const double spin = spin_to_path(ahead);
  if (spin != 0.0) return {{}, spin};
  const double speed = std::min(most, speed_at(ahead));
  const double angle = std::atan(parameters_.wheelbase * curvature(ahead, speed, progress_.station()));
  if (reverse_) return {{-speed, -angle}};
  return {{speed, angle}};
}

double PathDriver::spin_to_path(const Pose2& pose) {
  if (!parameters_.limits.differential()) return 0.0;
  const double turn = angle_difference(progress_.path().at(progress_.station()).heading, pose.yaw);
  spinning_ = std::abs(turn) > (spinning_ ? kFacing : kFacingAside);
  if (!spinning_) return 0.0;
  return spin_towards(turn, parameters_.limits);
}

double PathDriver::speed_at(const Pose2& pose) const {
  // Who is aside of the goal has a way to go still.
  const double aside = std::max(0.0, progress_.deviation(pose.position()) - parameters_.switch_radius);
  return speed_.at(progress_.path(), progress_.station() - aside);
}

std::vector<Pose2> PathDriver::way_ahead(const Pose2& pose, double speed, double length) const {
  const Path& path = progress_.path();
  double station = progress_.station();
  const double most = std::min(length, path.length() - station);
  const double forward = reverse_ ? -1.0 : 1.0;
  std::vector<Pose2> way = {pose};
  for (double gone = 0.0; gone < most; gone += kWayStep) {
    const double turn = curvature(leading(way.back()), speed, station);
    way.push_back(way.back() * displacement({0.0, kWayStep, forward, turn}));
    station = path.nearest(way.back().position(), station, station + 2.0 * kWayStep);
  }
  return way;
}

double PathDriver::settling_length(double speed) const {
  const double radius = 1.0 / parameters_.tightest_curvature();
  return std::max({kSettlingTime * speed, kSettlingRadii * radius, kShortestSettling});
}

double PathDriver::curvature(const Pose2& pose, double speed, double station) const {
  const Path& path = progress_.path();
  // The mean over the way that full lock takes asks for no faster steering than there is.
  const double middle = station + speed * parameters_.steering_lag;
  const double half = 0.5 * std::max(speed * parameters_.time_to_lock(), kShortestMean);
  // A bend that has been passed, the base far outside of it, is not to be driven any more.
  const double from = std::max(middle - half, std::min(progress_.earliest(), middle));
  const double ahead = path.mean_curvature(from, middle + half);
  return tracking_curvature(pose, path.at(station), ahead, settling_length(speed),
                            parameters_.tightest_curvature());
}

}  // namespace multipath_localization
