#include "multipath_localization/core/measurements.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

double sinc(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

}  // namespace

double ground_speed(const OdometryIncrement& increment) {
  return std::hypot(increment.speed, increment.lateral_speed);
}

Pose2 displacement(const OdometryIncrement& increment) {
  const double turn = increment.yaw_rate * increment.duration;
  const double shortening = increment.duration * sinc(0.5 * turn);
  const Eigen::Vector2d chord =
      rotation(0.5 * turn) * (shortening * Eigen::Vector2d(increment.speed, increment.lateral_speed));
  return {chord.x(), chord.y(), wrap_angle(turn)};
}

OdometryIncrement joined(const OdometryIncrement& first, const OdometryIncrement& second) {
  const double duration = first.duration + second.duration;
  const double share = second.duration / duration;
  const auto mean = [share](double a, double b) { return a + share * (b - a); };
  return {second.stamp,
          duration,
          mean(first.speed, second.speed),
          mean(first.yaw_rate, second.yaw_rate),
          mean(first.lateral_speed, second.lateral_speed),
          first.from_range_rates && second.from_range_rates,
          first.turn_source == second.turn_source ? first.turn_source : TurnSource::kWheels};
}

namespace {

/// Of a fix or an epoch; false where it cannot.
template <class Single>
bool carry(Single& measurement, const BaseThen& base_then) {
  const std::optional<Pose2> then = base_then(measurement.stamp);
  if (then) measurement.antenna_in_base = *then * measurement.antenna_in_base;
  return then.has_value();
}

bool carry(GnssVelocity& velocity, const BaseThen& base_then) {
  return base_then(velocity.stamp).has_value();
}

bool carry(Heading& heading, const BaseThen& base_then) {
  const std::optional<Pose2> then = base_then(heading.stamp);
  if (then) heading.turn = -then->yaw;
  return then.has_value();
}

bool carry(DualAntennaFix& fixes, const BaseThen& base_then) {
  return carry(fixes.left, base_then) && carry(fixes.right, base_then);
}

}  // namespace

double stamp_of(const Measurement& measurement) {
  return std::visit([](const auto& m) { return m.stamp; }, measurement);
}

std::optional<Measurement> carried_back(Measurement measurement, const BaseThen& base_then) {
  const bool known = std::visit([&](auto& m) { return carry(m, base_then); }, measurement);
  if (!known) return std::nullopt;
  return measurement;
}

}  // namespace multipath_localization
