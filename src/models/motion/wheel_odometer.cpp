#include "models/motion/wheel_odometer.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/motion/differential_drive.hpp"

namespace multipath_localization {

namespace {

constexpr double kTimeJump = 1.0;  // back by more is another time, as of a bag that is played again [s]
constexpr double kQuarterTurn = 0.5 * kPi;

bool all_told(const std::vector<JointReading>& readings) {
  return std::all_of(readings.begin(), readings.end(),
                     [](const JointReading& joint) { return joint.told(); });
}

/// Straight ahead where nothing steers.
double mean_position(const std::vector<JointReading>& joints) {
  if (joints.empty()) return 0.0;
  double sum = 0.0;
  for (const JointReading& joint : joints) sum += joint.position;
  return sum / static_cast<double>(joints.size());
}

/// What cannot be, whatever was read before.
Reason check_angle(double angle) {
  if (!std::isfinite(angle)) return Reason::kNotFinite;
  return std::abs(angle) < kQuarterTurn ? Reason::kAccepted : Reason::kTooFast;
}

/// Of all joints, of which the sides may have more and less, or one of them none.
double mean_of_sides(double left, const std::vector<JointReading>& joints_left, double right,
                     const std::vector<JointReading>& joints_right) {
  const auto on_left = static_cast<double>(joints_left.size());
  const auto on_right = static_cast<double>(joints_right.size());
  return (left * on_left + right * on_right) / (on_left + on_right);
}

WheelMotion no_motion(Reason reason) { return {reason, std::nullopt}; }

}  // namespace

WheelMotion WheelOdometer::take(double stamp, const DriveReading& reading) {
  Reason reason = std::isfinite(reading.speed) ? check_angle(reading.steering_angle) : Reason::kNotFinite;
  if (reason == Reason::kAccepted) reason = check_time(stamp);
  if (reason != Reason::kAccepted) return no_motion(reason);
  const TwistSample now = steered(stamp, reading.speed, reading.steering_angle);
  const OdometryIncrement motion = drive_ ? motion_between(*drive_, now) : motion_of(now, kFirstInterval);
  if (!possible(now.speed, now.yaw_rate)) return no_motion(Reason::kTooFast);
  const bool is_first = !drive_;
  drive_ = now;
  stamp_ = stamp;
  if (is_first) return {};
  return {Reason::kAccepted, motion};
}

WheelMotion WheelOdometer::take(double stamp, const WheelReadings& readings) {
  const double angle = mean_position(readings.steering);
  const bool told = all_told(readings.left) && all_told(readings.right);
  Reason reason = told ? check_angle(angle) : Reason::kNotFinite;
  if (reason == Reason::kAccepted) reason = check_time(stamp);
  if (reason != Reason::kAccepted) return no_motion(reason);
  const bool is_first = !stamp_;
  const double duration = stamp - stamp_.value_or(stamp);
  const double mean_angle = 0.5 * (angle + angle_.value_or(angle));
  const std::optional<double> left = turn_of(left_, readings.left, duration);
  const std::optional<double> right = turn_of(right_, readings.right, duration);
  stamp_ = stamp;
  angle_ = angle;
  if (is_first || !left || !right) return {};
  const double to_speed = geometry_.wheel_radius / duration;
  const TwistSample now =
      readings.steering.empty()
          ? differential(stamp, *left * to_speed, *right * to_speed)
          : steered(stamp, mean_of_sides(*left, readings.left, *right, readings.right) * to_speed,
                    mean_angle);
  if (!possible(now.speed, now.yaw_rate)) return no_motion(Reason::kTooFast);
  return {Reason::kAccepted, motion_of(now, duration)};
}

Reason WheelOdometer::check_time(double stamp) {
  if (stamp == 0.0) return Reason::kZeroStamp;
  if (!stamp_) return Reason::kAccepted;
  const double step = stamp - *stamp_;
  if (step > limits_.max_gap || step < -kTimeJump) {
    *this = WheelOdometer(geometry_, limits_);
    return Reason::kAccepted;
  }
  return step > 0.0 ? Reason::kAccepted : Reason::kOldStamp;
}

std::optional<double> WheelOdometer::turn_of(std::vector<JointTurn>& turns,
                                             const std::vector<JointReading>& readings, double duration) {
  if (readings.empty()) return 0.0;
  turns.resize(readings.size());
  double sum = 0.0;
  bool told = true;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::optional<double> turn = turns[i].take(readings[i], duration);
    told = told && turn;
    sum += turn.value_or(0.0);
  }
  if (!told) return std::nullopt;
  return sum / static_cast<double>(readings.size());
}

TwistSample WheelOdometer::steered(double stamp, double speed, double angle) const {
  const double turns = speed * std::tan(angle) / geometry_.wheelbase;
  return {stamp, speed, turns, -geometry_.axle * turns};
}

TwistSample WheelOdometer::differential(double stamp, double left, double right) const {
  const WheelSpeeds wheels{left, right};
  const double turns = yaw_rate(wheels, geometry_.track);
  return {stamp, speed(wheels), turns, -geometry_.axle * turns};
}

bool WheelOdometer::possible(double speed, double yaw_rate) const {
  return std::abs(speed) <= limits_.max_speed && std::abs(yaw_rate) <= limits_.max_yaw_rate;
}

}  // namespace multipath_localization
