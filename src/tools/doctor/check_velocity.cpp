#include <cmath>

#include "evaluation/metrics.hpp"
#include "multipath_localization/core/angle.hpp"
#include "ros/messages/velocity_conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {

namespace {

constexpr double kChord = 5.0;           // of the fixes, over which their course is known [m]
constexpr double kLongestChord = 15.0;   // in which it may be driven, so that it is straight [s]
constexpr std::size_t kEnough = 5;       // chords that tell
constexpr double kAlike = 0.35;          // courses differ by less: 20 degrees [rad]
constexpr double kScaleTolerance = 0.2;  // of the speed

/// The way that the velocities make of a piece of time [m]; nothing where they leave gaps.
std::optional<Eigen::Vector2d> way_between(const std::vector<GnssVelocity>& velocities, double start,
                                           double end) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  std::size_t count = 0;
  for (const GnssVelocity& velocity : velocities) {
    if (velocity.stamp < start || velocity.stamp > end) continue;
    sum += velocity.velocity;
    ++count;
  }
  if (static_cast<double>(count) < 0.5 * (end - start)) return std::nullopt;
  return Eigen::Vector2d(sum / static_cast<double>(count) * (end - start));
}

std::vector<GnssVelocity> usable(const Observations& seen) {
  std::vector<GnssVelocity> all;
  for (const auto& arrived : seen.velocities) {
    const CheckedVelocity checked = to_velocity(arrived.message, {});
    if (checked.reason == Reason::kAccepted) all.push_back(checked.velocity);
  }
  return all;
}

}  // namespace

Findings check_velocity(const Observations& seen) {
  if (seen.velocities.empty()) return {};
  const std::vector<GnssVelocity> velocities = usable(seen);
  const std::string name = "velocity: ";
  if (2 * velocities.size() < seen.velocities.size()) {
    return {fix(name + std::to_string(seen.velocities.size() - velocities.size()) + " of " +
                    std::to_string(seen.velocities.size()) + " messages cannot be used",
                "in the receiver's driver: stamp, east and north in m/s, and a covariance")};
  }
  const Motion motion = motion_of(seen);
  std::vector<double> turns, mirrored, ratios;
  for (const Chord& chord : chords(motion.fixes, motion.track, kChord)) {
    const auto way = way_between(velocities, chord.start, chord.end);
    if (!way || chord.end - chord.start > kLongestChord) continue;
    const double course = std::atan2(chord.by_fixes.y(), chord.by_fixes.x());
    turns.push_back(std::abs(angle_difference(std::atan2(way->y(), way->x()), course)));
    mirrored.push_back(std::abs(angle_difference(std::atan2(way->x(), way->y()), course)));
    ratios.push_back(way->norm() / chord.by_fixes.norm());
  }
  if (turns.size() < kEnough)
    return {untold(name + "too little driving with fixes to tell whether it is right")};
  const double turn = quantile(turns, 0.5), swapped = quantile(mirrored, 0.5), ratio = quantile(ratios, 0.5);
  const std::string what =
      name + text("%.0f degrees off the course of the fixes, %.2f times as fast", turn * 180.0 / kPi, ratio);
  if (swapped < kAlike && turn > kAlike)
    return {fix(what, "in the receiver's driver: linear.x is east, linear.y is north: they are swapped")};
  if (turn > kAlike)
    return {
        fix(what, "in the receiver's driver: the velocity is to be over ground, x east and y north (ENU)")};
  if (std::abs(ratio - 1.0) > kScaleTolerance)
    return {fix(what, "in the receiver's driver: metres per second, not knots or km/h")};
  return {pass(what)};
}

}  // namespace multipath_localization
