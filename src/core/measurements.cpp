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

namespace {

void carry(GnssFix& fix, const Pose2& then) { fix.antenna_in_base = then * fix.antenna_in_base; }

void carry(DualAntennaFix& fixes, const Pose2& then) {
  carry(fixes.left, then);
  carry(fixes.right, then);
}

void carry(PseudorangeEpoch& epoch, const Pose2& then) {
  epoch.antenna_in_base = then * epoch.antenna_in_base;
}

}  // namespace

double stamp_of(const Measurement& measurement) {
  return std::visit([](const auto& m) { return m.stamp; }, measurement);
}

Measurement carried_back(Measurement measurement, const Pose2& base_then_in_base_now) {
  std::visit([&](auto& m) { carry(m, base_then_in_base_now); }, measurement);
  return measurement;
}

}  // namespace multipath_localization
