#include <algorithm>
#include <cmath>

#include "evaluation/metrics.hpp"
#include "ros/map/datum.hpp"
#include "ros/messages/conversions.hpp"
#include "tools/doctor/checks.hpp"
#include "tools/doctor/counted.hpp"

namespace multipath_localization {

namespace {

constexpr double kFarthestDatum = 50e3;  // [m]
constexpr double kLeap = 30.0;           // beyond what reflections and wrong ambiguities do in one epoch [m]
constexpr double kBack = 0.3;            // of a leap, within which the next fix is back

bool rounded(double degrees) { return std::abs(degrees * 1e4 - std::round(degrees * 1e4)) < 1e-6; }

bool is_zero(const sensor_msgs::NavSatFix& fix) { return fix.latitude == 0.0 && fix.longitude == 0.0; }

/// Fixes that are refused by themselves for what `reason` says, other than for being at 0, 0.
std::size_t refused_for(Reason reason, const Observations& seen) {
  return count(seen,
               [&](const auto& fix) { return check(fix, seen.fix_parameters) == reason && !is_zero(fix); });
}

/// A refusal that needs mending where a tenth is lost by it: drivers say such things before their first fix
/// too.
void add_refused(std::size_t some, const Observations& seen, const std::string& what,
                 const std::string& remedy, Findings& all) {
  if (some == 0) return;
  const std::string said = of_all(some, seen, what + ", and are refused");
  all.push_back(is_loss(some, seen) ? fix(said, remedy) : pass(said));
}

/// How far from one fix to the next and back again the leaps are that a robot cannot have driven [m].
std::vector<double> leaps(const Motion& motion) {
  std::vector<double> all;
  const std::vector<GnssFix>& fixes = motion.fixes;
  for (std::size_t i = 1; i + 1 < fixes.size(); ++i) {
    const std::optional<double> from = motion.track.distance(fixes[i - 1].stamp);
    const std::optional<double> to = motion.track.distance(fixes[i + 1].stamp);
    const double driven = from && to ? *to - *from : 0.0;
    const double there = (fixes[i].position - fixes[i - 1].position).norm();
    const double back = (fixes[i + 1].position - fixes[i - 1].position).norm();
    if (there > kLeap + driven && back < kBack * there) all.push_back(there);
  }
  return all;
}

}  // namespace

Findings check_places(const Observations& seen) {
  Findings all;
  const std::size_t zero = count(seen, is_zero);
  if (zero > 0) {
    all.push_back(fix(of_all(zero, seen, "are at 0, 0, as a message that nobody filled in, and are refused"),
                      "in the receiver's driver: publish nothing without a fix, or status.status = -1"));
  }
  add_refused(refused_for(Reason::kNotFinite, seen), seen, "have no finite latitude and longitude",
              "in the receiver's driver: publish nothing without a fix, or status.status = -1", all);
  add_refused(refused_for(Reason::kInvalidPosition, seen), seen,
              "have a latitude or longitude out of range, or an altitude beyond 100 km",
              "in the receiver's driver: degrees, and metres above the ellipsoid, NaN where the altitude is "
              "not known",
              all);
  const std::optional<Geodetic> place = place_of_fixes(seen);
  if (!place) return all;
  const LocalFrame map(*place);
  const FixParameters& node = seen.fix_parameters;
  const std::size_t far = count(seen, [&](const auto& fix) {
    return check(fix, node) == Reason::kAccepted && to_fix(fix, map, node).reason != Reason::kAccepted;
  });
  if (far > 0) {
    all.push_back(fix(of_all(far, seen,
                             text("are over %.0f km from %s, where the first that agree are, and are refused",
                                  node.reach / 1000.0, to_text(*place).c_str())),
                      "one receiver on this topic only, which publishes nothing before it has a fix"));
  }
  if (all.empty()) all.push_back(pass("fix: all are near one another"));
  return all;
}

Findings check_leaps(const Observations& seen) {
  const std::vector<double> found = leaps(motion_of(seen));
  if (!is_loss(found.size(), seen)) return {};
  return {
      fix(of_all(found.size(), seen,
                 text("leap by %.0f m in the median, of which the next knows nothing", quantile(found, 0.5))),
          "one receiver on this topic only: rostopic info /" +
              resolved(seen.types, seen.fix_topic, "sensor_msgs/NavSatFix"))};
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
