#include "simulation/ground.hpp"

#include <cmath>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

void GroundParameters::fields(ParameterVisitor& field) {
  field(
      "slope", slope, {-0.7, 0.7}, "rad",
      "to the east, upwards: leans base, mast and IMU and lengthens the way of the wheels; of antennas only "
      "that of `receiver` by zones leans");
  field("wavelength", wavelength, {0.0, 1e4}, "m",
        "of ground in waves from west to east, as steep as `slope` at most; 0: even");
}

Tilt GroundParameters::tilt(const Pose2& base_in_map) const {
  const double wave = wavelength > 0.0 ? std::cos(2.0 * kPi * base_in_map.x / wavelength) : 1.0;
  const double rise = wave * slope;
  const double c = std::cos(base_in_map.yaw);
  const Eigen::Vector3d normal(-std::sin(rise), 0.0, std::cos(rise));
  const Eigen::Vector3d forwards =
      Eigen::Vector3d(c, std::sin(base_in_map.yaw), std::tan(rise) * c).normalized();
  const Eigen::Vector3d left = normal.cross(forwards);
  return tilt_of({forwards.z(), left.z(), normal.z()});
}

}  // namespace multipath_localization
