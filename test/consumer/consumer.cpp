#include <cstdio>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/localization/localizer.hpp"

using namespace multipath_localization;

/// Puts the default filter on a stream of odometry and fixes: 20 s to the east at 2 m/s. Its lines stand in
/// doc/guides/library.md.
int main() {
  constexpr double duration = 0.05, speed = 2.0, yaw_rate = 0.0, lateral_speed = 0.0;
  const LocalFrame map({52.5, 13.4, 40.0});
  const Eigen::Matrix2d covariance = 0.09 * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();

  Localizer localizer(make_estimator("multipath_particle_filter", YAML::Node(), 1), LocalizerParameters{});
  localizer.start(std::nullopt);
  for (int i = 1; i <= 400; ++i) {
    const double stamp = duration * i;
    localizer.add(OdometryIncrement{stamp, duration, speed, yaw_rate, lateral_speed});
    if (i % 4 != 0) continue;
    const Geodetic place = map.to_geodetic({speed * stamp, 0.0});
    localizer.add(GnssFix{stamp, map.to_map(place), covariance, antenna_in_base});
  }
  const PoseEstimate estimate = localizer.estimate();
  const Trust state = localizer.state();
  std::printf("%s: x %.1f m, y %.1f m, yaw %.1f rad\n", to_string(state).data(), estimate.pose.x,
              estimate.pose.y, estimate.pose.yaw);
  return state == Trust::kGood && (estimate.pose.position() - Eigen::Vector2d(40.0, 0.0)).norm() < 1.0 ? 0
                                                                                                       : 1;
}
