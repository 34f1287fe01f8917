#include <algorithm>
#include <cmath>

#include "evaluation/metrics.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "ros/messages/conversions.hpp"
#include "tools/doctor/checks.hpp"
#include "tools/doctor/counted.hpp"
#include "tools/doctor/shape_fit.hpp"

namespace multipath_localization {

namespace {

constexpr double kShortestChord = 1.0;  // over which fixes are compared with odometry [m]
constexpr std::size_t kEnoughChords = 20;
constexpr double kWorstLie = 4.0;       // observed over declared sigma
constexpr double kMadToSigma = 1.4826;  // of a normal distribution

double median_declared(const Observations& seen) {
  std::vector<double> declared;
  for (const auto& arrived : seen.fixes) {
    const double sigma = declared_sigma(arrived.message);
    if (std::isfinite(sigma)) declared.push_back(sigma);
  }
  return declared.empty() ? std::nan("") : quantile(declared, 0.5);
}

}  // namespace

Findings check_status(const Observations& seen) {
  if (seen.fixes.empty()) return {};
  const int least = seen.fix_parameters.min_fix_status;
  const std::size_t below = count(seen, [&](const auto& fix) { return fix.status.status < least; });
  const std::size_t none = count(seen, [](const auto& fix) { return fix.status.status < 0; });
  if (below == seen.fixes.size() && none == below) {
    return {fix("fix: every one has status -1 (no fix) and is refused",
                "wait for the receiver, or where its driver never fills status in: localization.yaml, fix: "
                "{min_fix_status: -1}")};
  }
  const std::string refused = of_all(below, seen, text("have a status below %d and are refused", least));
  if (is_loss(below, seen)) {
    return {fix(refused, none == below
                             ? "a receiver without a fix: the antenna's cable, and its view of the sky"
                             : "localization.yaml, fix: {min_fix_status: 0}")};
  }
  if (below > 0) return {pass(refused)};
  return {pass(none == 0 ? "fix: all have a status of a fix"
                         : of_all(none, seen, "have status -1, and count as told"))};
}

Findings check_declared_covariance(const Observations& seen) {
  if (seen.fixes.empty()) return {};
  const FixParameters& node = seen.fix_parameters;
  FixParameters any_status = node;
  any_status.min_fix_status = -1;
  const std::size_t refused =
      count(seen, [&](const auto& fix) { return check(fix, any_status) == Reason::kInvalidCovariance; });
  if (refused > 0) {
    return {fix(
        of_all(
            refused, seen,
            text("declare a covariance that is negative, not finite or above %g m squared, and are refused",
                 node.largest_sigma)),
        "in the receiver's driver: position_covariance_type = COVARIANCE_TYPE_UNKNOWN, which stands for fix: "
        "{default_sigma}")};
  }
  const std::size_t unknown = count(seen, [&](const auto& fix) {
    return std::isnan(declared_sigma(fix)) && check(fix, any_status) != Reason::kInvalidPosition;
  });
  if (unknown > 0) {
    const std::string what =
        of_all(unknown, seen, text("declare no covariance; they count as %g m", node.default_sigma));
    if (node.default_sigma != FixParameters{}.default_sigma) return {pass(what + ", as told")};
    return {fix(
        what, "localization.yaml, fix: {default_sigma: S}, S what fixes scatter by while the robot stands")};
  }
  const double first = declared_sigma(seen.fixes.front().message);
  const bool constant = seen.fixes.size() > 1 &&
                        count(seen, [&](const auto& fix) { return declared_sigma(fix) != first; }) == 0;
  return {pass(text("fix: declared sigma %.3g m%s", median_declared(seen),
                    constant ? ", always the same, so it tells nothing about buildings" : " in the median"))};
}

Findings check_scatter(const Observations& seen) {
  const Motion motion = motion_of(seen);
  std::vector<double> differences;
  for (const Chord& chord : chords(motion.fixes, motion.track, kShortestChord)) {
    differences.push_back(std::abs(chord.by_fixes.norm() - chord.by_odometry.norm()));
  }
  const double declared = median_declared(seen);
  const ShapeFit way = fit_shape(motion.fixes, motion.track);
  if (!way.has_enough() || differences.size() < kEnoughChords || std::isnan(declared)) {
    return {untold("fix: too little driving with fixes to see how much they scatter")};
  }
  if (!way.fits()) {
    return {untold("fix: its way is not that of odometry, so they do not tell how much fixes scatter")};
  }
  const double observed = kMadToSigma * quantile(differences, 0.5) * std::sqrt(0.5);
  const std::string what = text("fix: scatter about odometry %.2f m over %.0f m of way, declared %.3g m",
                                observed, kShortestChord, declared);
  if (observed <= kWorstLie * declared) return {pass(what)};
  return {fix(
      what,
      text("an estimator that believes declared covariances will be too sure: localizer: {fix_covariance: "
           "{source: fixed, fixed_sigma: %.3g}}; multipath_particle_filter finds that out for itself",
           observed))};
}

Findings check_frozen(const Observations& seen) {
  if (seen.fixes.empty()) return {};
  const OdometryTrack track = motion_of(seen).track;
  double longest = 0.0;
  const sensor_msgs::NavSatFix* first = nullptr;  // of those at one place
  for (const auto& arrived : seen.fixes) {
    const sensor_msgs::NavSatFix& now = arrived.message;
    if (check(now, seen.fix_parameters) != Reason::kAccepted) continue;
    if (first == nullptr || now.latitude != first->latitude || now.longitude != first->longitude)
      first = &now;
    const std::optional<double> from = track.distance(first->header.stamp.toSec());
    const std::optional<double> to = track.distance(now.header.stamp.toSec());
    if (from && to) longest = std::max(longest, *to - *from);
  }
  const std::string what = text("fix: the same to the bit over %.1f m of way at most", longest);
  if (longest <= seen.localizer_parameters.frozen_distance) return {pass(what)};
  return {fix(
      what, "restart the receiver's driver: rosnode kill DRIVER, with respawn=\"true\" in its launch file")};
}

}  // namespace multipath_localization
