#include "tools/tuning/open_sky.hpp"

#include <algorithm>

#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/localization/localizer.hpp"

namespace multipath_localization {

namespace {

constexpr double kShadow = 0.3;                // a probability that spoils fixes nearby
constexpr double kBefore = 1.0, kAfter = 3.0;  // [s]

/// When the default filter thinks of a shadow, by time.
std::vector<double> suspicions(const Drive& drive) {
  Localizer localizer(make_estimator(estimator_names().front(), {}, 1), {});
  localizer.start(std::nullopt);
  std::vector<double> stamps;
  std::size_t next = 0;
  auto restart = drive.restarts.begin();
  for (const OdometryIncrement& increment : drive.odometry) {
    if (restart != drive.restarts.end() && *restart <= increment.stamp) {
      localizer.start(std::nullopt);
      ++restart;
    }
    localizer.add(increment);
    for (; next < drive.measurements.size() && drive.measurements[next].arrival <= increment.stamp; ++next) {
      localizer.add(drive.measurements[next].measurement);
    }
    if (localizer.estimate().shadow_probability > kShadow) stamps.push_back(increment.stamp);
  }
  return stamps;
}

}  // namespace

std::vector<GnssFix> fixes_under_open_sky(const Drive& drive) {
  const std::vector<double> suspect = suspicions(drive);
  std::vector<GnssFix> fixes = drive.fixes();
  fixes.erase(std::remove_if(fixes.begin(), fixes.end(),
                             [&](const GnssFix& fix) {
                               const auto next =
                                   std::lower_bound(suspect.begin(), suspect.end(), fix.stamp - kBefore);
                               return next != suspect.end() && *next <= fix.stamp + kAfter;
                             }),
              fixes.end());
  std::sort(fixes.begin(), fixes.end(), [](const GnssFix& a, const GnssFix& b) { return a.stamp < b.stamp; });
  return fixes;
}

}  // namespace multipath_localization
