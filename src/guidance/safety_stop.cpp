#include "multipath_localization/guidance/safety_stop.hpp"

#include <algorithm>
#include <cmath>

#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kPlannedBraking = 0.8;  // of the deceleration allowed: the rest makes up for delays
constexpr double kCrawl = 0.05;          // slower it stands [m/s]
constexpr double kFurther = 0.2;         // that an obstacle is away before a halted robot goes on [m]
constexpr double kSlack = 0.05;          // nearer to an obstacle is no emergency [m]
constexpr double kReaction = 0.5;        // of driving that is looked further ahead than braking takes [s]

}  // namespace

void SafetyParameters::fields(ParameterVisitor& field) {
  field("stop_before_obstacles", stop_before_obstacles,
        "listen to `scan`, and stop before what it sees in the way; without scans stand");
  field("obstacle_distance", obstacle_distance, {0.0, 100.0}, "m",
        "from the robot's front to an obstacle it stands before");
  field("max_scan_age", max_scan_age, {0.01, 60.0}, "s", "the robot stands when the scan is older");
  field("max_stop_input_age", max_stop_input_age, {0.0, 60.0}, "s",
        "and when `emergency_stop` has been silent for longer; 0: it may be");
  field("clear_time", clear_time, {0.0, 600.0}, "s",
        "nothing was in the way for, before the robot goes on by itself");
  field("resume_by_call", resume_by_call, "go on only when the service resume is called");
  footprint.fields(field);
}

std::string SafetyStop::fault_of_inputs(const Hazards& hazards) const {
  if (hazards.stop_asked) return "emergency stop";
  const double most = parameters_.max_stop_input_age;
  if (most > 0.0 && !(hazards.stop_input_age <= most)) return "emergency_stop is silent";
  return hazards.scan_fault;
}

std::string SafetyStop::reason_to_halt(const FollowerOutput& wanted, const Hazards& hazards) const {
  const std::string fault = fault_of_inputs(hazards);
  if (!fault.empty()) return fault;
  if (wanted.spin != 0.0) return hazards.free_to_turn ? "" : "obstacle, no room to turn";
  const double needed = parameters_.obstacle_distance + (reason_.empty() ? 0.0 : kFurther);
  if (hazards.free_way > needed && slowed(wanted, 0.0, hazards.free_way).command.speed != 0.0) return "";
  return "obstacle " + fixed_text(hazards.free_way, 1) + " m ahead";
}

FollowerOutput SafetyStop::slowed(const FollowerOutput& wanted, double speed, double free_way) const {
  if (!std::isfinite(free_way)) return wanted;
  const double room = std::max(0.0, free_way - parameters_.obstacle_distance);
  const double late = kPlannedBraking * deceleration_ * braking_delay_;
  const double most = std::sqrt(late * late + 2.0 * kPlannedBraking * deceleration_ * room) - late;
  if (std::abs(wanted.command.speed) <= most) return wanted;
  FollowerOutput slower = wanted;
  slower.command.speed = most > kCrawl ? std::copysign(most, wanted.command.speed) : 0.0;
  slower.status = "slow: obstacle " + fixed_text(free_way, 1) + " m ahead";
  slower.urgent = speed * speed > 2.0 * deceleration_ * (room + kSlack);
  return slower;
}

FollowerOutput SafetyStop::guarded(const FollowerOutput& wanted, double speed, const Hazards& hazards,
                                   double now) {
  if (wanted.command.speed == 0.0 && wanted.spin == 0.0) {
    reason_.clear();
    return wanted;
  }
  const std::string reason = reason_to_halt(wanted, hazards);
  if (!reason.empty()) {
    hazard_seen_ = now;
    reason_ = reason;
  } else if (now - hazard_seen_ >= parameters_.clear_time) {
    reason_.clear();
  }
  if (!reason_.empty()) return {{}, "stopped: " + reason_, true};
  return slowed(wanted, speed, hazards.free_way);
}

double SafetyStop::look_ahead(double speed) const {
  const double braking = speed * speed / (2.0 * kPlannedBraking * deceleration_);
  return parameters_.obstacle_distance + kFurther + braking + (kReaction + braking_delay_) * std::abs(speed);
}

}  // namespace multipath_localization
