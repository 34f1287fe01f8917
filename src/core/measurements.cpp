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

double stamp_of(const Measurement& measurement) {
  return std::visit([](const auto& m) { return m.stamp; }, measurement);
}

}  // namespace multipath_localization
