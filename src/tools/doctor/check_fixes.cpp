#include <algorithm>
#include <cmath>

#include "multipath_localization/estimators/localizer.hpp"
#include "multipath_localization/evaluation/metrics.hpp"
#include "nodes/conversions.hpp"
#include "nodes/datum.hpp"
#include "tools/doctor/checks.hpp"
#include "tools/doctor/shape_fit.hpp"

namespace multipath_localization {

namespace {

constexpr double kShortestChord = 1.0;  // over which fixes are compared with odometry [m]
constexpr std::size_t kEnoughChords = 20;
constexpr double kWorstLie = 4.0;        // observed over declared sigma
constexpr double kMadToSigma = 1.4826;   // of a normal distribution
constexpr double kFarthestDatum = 50e3;  // [m]

template <class Predicate>
std::size_t count(const Observations& seen, const Predicate& predicate) {
  return static_cast<std::size_t>(std::count_if(
      seen.fixes.begin(), seen.fixes.end(), [&](const auto& arrived) { return predicate(arrived.message); }));
}

std::string of_all(std::size_t some, const Observations& seen, const char* what) {
  return text("fix: %zu of %zu %s", some, seen.fixes.size(), what);
}

double median_declared(const Observations& seen) {
  std::vector<double> declared;
  for (const auto& arrived : seen.fixes) {
    const double sigma = declared_sigma(arrived.message);
    if (std::isfinite(sigma)) declared.push_back(sigma);
  }
  return declared.empty() ? std::nan("") : quantile(declared, 0.5);
}

bool rounded(double degrees) { return std::abs(degrees * 1e4 - std::round(degrees * 1e4)) < 1e-6; }

}  // namespace

Findings check_status(const Observations& seen) {
  if (seen.fixes.empty()) return {};
  const std::size_t none = count(seen, [](const auto& fix) { return fix.status.status < 0; });
  if (none == seen.fixes.size() && seen.fix_parameters.min_fix_status > -1) {
    return {fix("fix: every one has status -1 (no fix) and is refused",
                "wait for the receiver, or where its driver never fills status in: localization.yaml, fix: "
                "{min_fix_status: -1}")};
  }
  return {pass(none == 0
                   ? "fix: all have a status of a fix"
                   : of_all(none, seen,
                            seen.fix_parameters.min_fix_status > -1 ? "have status -1 and are refused"
                                                                    : "have status -1, and count as told"))};
}

Findings check_places(const Observations& seen) {
  const std::optional<Geodetic> place = place_of_fixes(seen);
  const std::size_t zero =
      count(seen, [](const auto& fix) { return fix.latitude == 0.0 && fix.longitude == 0.0; });
  Findings all;
  if (zero > 0) {
    all.push_back(fix(of_all(zero, seen, "are at 0, 0, as a message that nobody filled in, and are refused"),
                      "in the receiver's driver: publish nothing without a fix, or status.status = -1"));
  }
  if (!place) return all;
  const LocalFrame map(*place);
  const FixParameters& node = seen.fix_parameters;
  const std::size_t far = count(seen, [&](const auto& fix) {
    return check(fix, node) == Reason::kAccepted && to_fix(fix, map, node).reason != Reason::kAccepted;
  });
  if (far == 0) return zero > 0 ? all : Findings{pass("fix: all are near one another")};
  all.push_back(fix(of_all(far, seen,
                           text("are over %.0f km from %s, where the first that agree are, and are "
                                "refused",
                                node.reach / 1000.0, to_text(*place).c_str())
                               .c_str()),
                    "one receiver on this topic only, which publishes nothing before it has a fix"));
  return all;
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
                 node.largest_sigma)
                .c_str()),
        "in the receiver's driver: position_covariance_type = COVARIANCE_TYPE_UNKNOWN, which stands for fix: "
        "{default_sigma}")};
  }
  const std::size_t unknown = count(seen, [&](const auto& fix) {
    return std::isnan(declared_sigma(fix)) && check(fix, any_status) != Reason::kInvalidPosition;
  });
  if (unknown > 0) {
    const std::string what =
        of_all(unknown, seen, text("declare no covariance; they count as %g m", node.default_sigma).c_str());
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
  if (!fit_shape(motion.fixes, motion.track).same_shape()) {
    return {untold(
        "fix: its way and that of odometry differ in shape, so they do not tell how much fixes scatter")};
  }
  if (differences.size() < kEnoughChords || std::isnan(declared)) {
    return {untold("fix: too little driving with fixes to see how much they scatter")};
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

Findings check_datum(const Observations& seen) {
  if (seen.datum.size() < 2) return {};
  const std::string what = text("datum: %.9g, %.9g", seen.datum[0], seen.datum[1]);
  const Geodetic datum{seen.datum[0], seen.datum[1], 0.0};
  const std::optional<Geodetic> place = place_of_fixes(seen);
  const std::string by_fix = seen.datum_file.empty()
                                 ? "localization.yaml: datum: " +
                                       (place ? to_text(*place) : "[LATITUDE, LONGITUDE], with 8 decimals")
                                 : "rm " + seen.datum_file + ", and start the node again";
  if (!valid(datum)) return {fix(what + " is not latitude, longitude", by_fix)};
  if (place) {
    const double away = distance(datum, *place);
    if (!(away < kFarthestDatum)) {
      const std::string why =
          seen.datum_file.empty() ? "; latitude comes first" : ", saved in " + seen.datum_file;
      return {fix(what + text(" is %.0f km from the fixes", away / 1000.0) + why, by_fix)};
    }
  }
  if (seen.datum_file.empty() && rounded(seen.datum[0]) && rounded(seen.datum[1])) {
    return {fix(what + " is rounded to four decimals, up to 8 m off", by_fix)};
  }
  return {pass(what)};
}

}  // namespace multipath_localization
