#include "models/motion/joint_turn.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

constexpr double kTurn = 2.0 * kPi;
constexpr double kWithinATurn = 1.001 * kTurn;  // encoders round

}  // namespace

bool JointReading::told() const { return std::isfinite(position) || std::isfinite(velocity); }

std::optional<double> JointTurn::take(const JointReading& reading, double duration) {
  if (std::isfinite(reading.position)) {
    lowest_ = std::min(lowest_, reading.position);
    highest_ = std::max(highest_, reading.position);
  }
  const std::optional<double> turn = before_ ? turn_to(reading, duration) : std::nullopt;
  before_ = reading;
  if (turn) rate_ = *turn / duration;
  return turn;
}

std::optional<double> JointTurn::turn_to(const JointReading& reading, double duration) {
  const bool has_velocity = std::isfinite(reading.velocity);
  const double turn = reading.position - before_->position;
  if (!std::isfinite(turn)) {
    if (!has_velocity) return std::nullopt;
    return reading.velocity * duration;
  }
  begins_anew_ = highest_ - lowest_ <= kWithinATurn && (begins_anew_ || std::abs(turn) > kPi);
  if (!begins_anew_) return turn;
  const double expected = (has_velocity ? reading.velocity : rate_) * duration;
  return turn + kTurn * std::round((expected - turn) / kTurn);
}

}  // namespace multipath_localization
