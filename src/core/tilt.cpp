#include "multipath_localization/core/tilt.hpp"

#include <cmath>

namespace multipath_localization {

Eigen::Matrix3d rotation(const Tilt& tilt) {
  return (Eigen::AngleAxisd(tilt.pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(tilt.roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Vector3d up_in_base(const Tilt& tilt) { return rotation(tilt).row(2).transpose(); }

Tilt tilt_of(const Eigen::Vector3d& up) {
  return {std::atan2(up.y(), up.z()), std::atan2(-up.x(), std::hypot(up.y(), up.z()))};
}

Eigen::Vector2d levelled(const Tilt& tilt, const Eigen::Vector3d& in_base) {
  return (rotation(tilt) * in_base).head<2>();
}

OdometryIncrement over_map(const Tilt& tilt, OdometryIncrement along_ground) {
  const Eigen::Vector2d velocity =
      levelled(tilt, Eigen::Vector3d(along_ground.speed, along_ground.lateral_speed, 0.0));
  along_ground.speed = velocity.x();
  along_ground.lateral_speed = velocity.y();
  along_ground.yaw_rate *= std::cos(tilt.roll) / std::cos(tilt.pitch);
  return along_ground;
}

YawRate over_map(const Tilt& tilt, YawRate about_vertical) {
  const double c = std::cos(tilt.pitch);
  about_vertical.rate /= c * c;
  return about_vertical;
}

OdometryIncrement along_ground(const Tilt& tilt, OdometryIncrement level) {
  const Eigen::Matrix2d to_level = rotation(tilt).topLeftCorner<2, 2>();
  const Eigen::Vector2d velocity = to_level.inverse() * Eigen::Vector2d(level.speed, level.lateral_speed);
  level.speed = velocity.x();
  level.lateral_speed = velocity.y();
  level.yaw_rate *= std::cos(tilt.pitch) / std::cos(tilt.roll);
  return level;
}

}  // namespace multipath_localization
