#include "ros/messages/earth_frame.hpp"

#include <Eigen/Geometry>

namespace multipath_localization {

namespace {

constexpr double kSameAxes = 1e-3;  ///< [rad]

Eigen::Quaterniond turn_of(const LocalFrame& map) {
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) axes.col(i) = map.vector_to_ecef(Eigen::Vector3d::Unit(i));
  return Eigen::Quaterniond(axes);
}

}  // namespace

geometry_msgs::Transform map_in_earth(const LocalFrame& map) {
  const Eigen::Quaterniond turn = turn_of(map);
  geometry_msgs::Transform transform;
  transform.translation.x = map.origin().x();
  transform.translation.y = map.origin().y();
  transform.translation.z = map.origin().z();
  transform.rotation.x = turn.x();
  transform.rotation.y = turn.y();
  transform.rotation.z = turn.z();
  transform.rotation.w = turn.w();
  return transform;
}

std::optional<Geodetic> datum_of(const Eigen::Isometry3d& map_in_earth) {
  const Geodetic datum = to_geodetic(Eigen::Vector3d(map_in_earth.translation()));
  if (!valid(datum)) return std::nullopt;
  const Eigen::Quaterniond turn(map_in_earth.linear());
  return turn.angularDistance(turn_of(LocalFrame(datum))) < kSameAxes ? std::optional(datum) : std::nullopt;
}

}  // namespace multipath_localization
