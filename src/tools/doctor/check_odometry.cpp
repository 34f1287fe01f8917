#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "ros/map/datum.hpp"
#include "tools/doctor/checks.hpp"
#include "tools/doctor/misreading.hpp"
#include "tools/doctor/shape_fit.hpp"

namespace multipath_localization {

namespace {

constexpr double kScaleTolerance = 0.1;
constexpr std::size_t kEnoughCurves = 4;
constexpr char kTurnYawRate[] = "in the base driver: turn the sign of twist.angular.z";
constexpr double kFullCircle = 0.8 * 2.0 * kPi;  // that was meant for one [rad]

/// Whether odometry has turned about as far to the left and to the right as on a figure of eight.
bool is_figure_of_eight(const Motion& motion) {
  double left = 0.0, right = 0.0;
  for (const OdometryIncrement& u : motion.increments) {
    (u.yaw_rate > 0.0 ? left : right) += std::abs(u.yaw_rate) * u.duration;
  }
  return left > kFullCircle && right > kFullCircle;
}

std::string scale_remedy(const ShapeFit& fit) {
  return text("in the base driver: metres per tick (wheel radius, gear, ticks a turn) times %.3f", fit.scale);
}

std::string mirrored_remedy(const Observations& seen) {
  const auto opposite = [&](Voice voice) {
    const Motion motion = motion_of(seen, voice);
    const ShapeFit fit = fit_shape(motion.fixes, motion.track);
    return fit.opposite >= 2 * fit.alike && fit.opposite > 0;
  };
  if (!opposite(Voice::kPoses)) return kTurnYawRate;
  return "in the base driver: yaw counter-clockwise, x forwards, y to the left (REP-103): yaw = -yaw, "
         "angular.z = -angular.z, y = -y";
}

/// The other cause of a mirrored way where all of odometry is: a driver that tells south or west without
/// sign.
std::string unless_signs_are_lost(const Observations& seen, const std::string& remedy) {
  const std::optional<Geodetic> place = place_of_fixes(seen);
  const bool signs = !place || (place->latitude_deg < 0.0 && place->longitude_deg < 0.0);
  if (signs || remedy == kTurnYawRate) return remedy;
  return remedy + "; or, if the robot was not at " + to_text(*place) +
         ", in the receiver's driver: south and west are negative";
}

}  // namespace

Findings check_coordinates(const Observations& seen) {
  const std::optional<Misreading> found = misreading(seen);
  if (!found) return {};
  const Motion motion = motion_of(seen);
  const ShapeFit as_told = fit_shape(motion.fixes, motion.track);
  std::string otherwise;
  if (as_told.same_shape()) otherwise = scale_remedy(as_told);
  if (as_told.mirrored_shape()) otherwise = mirrored_remedy(seen);
  const std::string told = to_text(found->place), read = to_text(found->other_place);
  return {fix("fix: latitude and longitude go the way of odometry if read " + found->as +
                  ", which puts the robot at " + read + ", not at " + told,
              "in the receiver's driver: " + found->remedy +
                  (otherwise.empty() ? "" : "; if it was at " + told + " after all, " + otherwise))};
}

Findings check_turns(const Observations& seen) {
  const Motion motion = motion_of(seen);
  const ShapeFit fit = fit_shape(motion.fixes, motion.track);
  if (fit.pieces < kEnoughCurves) {
    return {untold("odom: too little driving with fixes to tell left from right")};
  }
  const std::size_t curves = fit.alike + fit.opposite;
  if (curves < kEnoughCurves) {
    return {
        untold(is_figure_of_eight(motion)
                   ? "odom: the way of the fixes is not that of odometry, either way round: they do not tell "
                     "left from right"
                   : "odom: too few curves to tell left from right; drive a figure of eight")};
  }
  const std::string what =
      text("odom: %zu of %zu curves go the same way round as the fixes", fit.alike, curves);
  if (fit.alike >= 2 * fit.opposite) return {pass(what)};
  if (fit.opposite >= 2 * fit.alike)
    return {fix(what + ": mirrored, or NED", unless_signs_are_lost(seen, mirrored_remedy(seen)))};
  return {untold(what + ": they do not tell left from right")};
}

Findings check_scale(const Observations& seen) {
  const Motion motion = motion_of(seen);
  const ShapeFit fit = fit_shape(motion.fixes, motion.track);
  if (fit.pieces < kEnoughCurves) return {untold("odom: too little driving with fixes to tell its scale")};
  if (!fit.tells_scale()) {
    return {
        untold(text("odom: its way and that of the fixes differ in shape, by %.0f %% in the median: no scale "
                    "can be told",
                    100.0 * fit.error))};
  }
  const std::string what =
      text("odom: fixes go %.3f times as far, over %zu pieces of way", fit.scale, fit.pieces);
  if (std::abs(fit.scale - 1.0) <= kScaleTolerance) return {pass(what)};
  return {fix(what, scale_remedy(fit))};
}

Findings check_way(const Observations& seen) {
  Findings found = check_coordinates(seen);
  if (!found.empty()) return found;
  for (const auto check : {check_turns, check_scale}) {
    const Findings more = check(seen);
    found.insert(found.end(), more.begin(), more.end());
  }
  return found;
}

}  // namespace multipath_localization
