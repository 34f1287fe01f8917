#include <cstdio>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/estimators/localizer.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"

using namespace multipath_localization;

/// Puts the default filter on a stream of odometry and fixes: 20 s to the east at 2 m/s.
int main() {
  Localizer localizer(make_estimator(estimator_names().front(), YAML::Node(), 1), LocalizerParameters{});
  localizer.start(std::nullopt);
  const LocalFrame map({52.5, 13.4, 40.0});
  for (int i = 1; i <= 400; ++i) {
    const double t = 0.05 * i;
    localizer.add(OdometryIncrement{t, 0.05, 2.0, 0.0, 0.0});
    if (i % 4 != 0) continue;
    GnssFix fix;
    fix.stamp = t;
    fix.position = map.to_map(map.to_geodetic({2.0 * t, 0.0}));
    localizer.add(fix);
  }
  const PoseEstimate estimate = localizer.estimate();
  std::printf("x %.1f m, y %.1f m, yaw %.1f rad\n", estimate.pose.x, estimate.pose.y, estimate.pose.yaw);
  return (estimate.pose.position() - Eigen::Vector2d(40.0, 0.0)).norm() < 1.0 ? 0 : 1;
}
