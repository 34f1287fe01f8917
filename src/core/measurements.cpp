#include "multipath_localization/core/measurements.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

double sinc(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

}  // namespace

Pose2 displacement(const OdometryIncrement& increment) {
  const double turn = increment.yaw_rate * increment.duration;
  const double chord = increment.speed * increment.duration * sinc(0.5 * turn);
  return {chord * std::cos(0.5 * turn), chord * std::sin(0.5 * turn), wrap_angle(turn)};
}

OdometryIncrement joined(const OdometryIncrement& first, const OdometryIncrement& second) {
  const double duration = first.duration + second.duration;
  const double share = second.duration / duration;
  return {second.stamp, duration, first.speed + share * (second.speed - first.speed),
          first.yaw_rate + share * (second.yaw_rate - first.yaw_rate)};
}

namespace {

/// Of a fix or an epoch; false where it cannot.
template <class Single>
bool carry(Single& measurement, const BaseThen& base_then) {
  const std::optional<Pose2> then = base_then(measurement.stamp);
  if (then) measurement.antenna_in_base = *then * measurement.antenna_in_base;
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
