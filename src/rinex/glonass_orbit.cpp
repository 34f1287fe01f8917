#include "rinex/glonass_orbit.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

namespace {

constexpr double kEarthRadius = 6378136.0;    // [m]
constexpr double kFlattening = 1.0826257e-3;  // J_2
constexpr double kRotationRate = kRoundedEarthRotationRate;
constexpr double kLongestStep = 60.0;  // [s]

using Vector6 = Eigen::Matrix<double, 6, 1>;  // position, velocity

/// Of Earth's gravity, flattened, in the frame that turns with it.
Vector6 derivative(const Vector6& state, const Eigen::Vector3d& sun_and_moon) {
  const Eigen::Vector3d r = state.head<3>();
  const Eigen::Vector3d v = state.tail<3>();
  const double square = r.squaredNorm();
  const double attraction = kEarthGravitation / (square * std::sqrt(square));
  const double oblateness = 1.5 * kFlattening * attraction * kEarthRadius * kEarthRadius / square;
  const double slope = 5.0 * r.z() * r.z() / square;
  const double centrifugal = kRotationRate * kRotationRate;
  Vector6 rate;
  rate.head<3>() = v;
  rate(3) = (-attraction - oblateness * (1.0 - slope) + centrifugal) * r.x() + 2.0 * kRotationRate * v.y();
  rate(4) = (-attraction - oblateness * (1.0 - slope) + centrifugal) * r.y() - 2.0 * kRotationRate * v.x();
  rate(5) = (-attraction - oblateness * (3.0 - slope)) * r.z();
  rate.tail<3>() += sun_and_moon;
  return rate;
}

Vector6 stepped(const Vector6& state, const Eigen::Vector3d& sun_and_moon, double step) {
  const Vector6 k1 = derivative(state, sun_and_moon);
  const Vector6 k2 = derivative(state + 0.5 * step * k1, sun_and_moon);
  const Vector6 k3 = derivative(state + 0.5 * step * k2, sun_and_moon);
  const Vector6 k4 = derivative(state + step * k3, sun_and_moon);
  return state + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

}  // namespace

bool possible(const GlonassOrbit& orbit) {
  const double radius = orbit.position.norm();
  return radius >= 2e7 && radius <= 3e7 && orbit.velocity.norm() < 1e4 && orbit.acceleration.norm() < 1e-3 &&
         std::abs(orbit.clock) < 0.1 && std::abs(orbit.clock_drift) < 1e-6 && orbit.channel >= -7 &&
         orbit.channel <= 13;
}

SatelliteState satellite_state(const GlonassOrbit& orbit, const GnssTime& time) {
  const double since = time - orbit.reference;
  Vector6 state;
  state << orbit.position, orbit.velocity;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(since) / kLongestStep)));
  for (int i = 0; i < steps; ++i) state = stepped(state, orbit.acceleration, since / steps);
  return {state.head<3>(), state.tail<3>(), orbit.clock + orbit.clock_drift * since, orbit.clock_drift};
}

}  // namespace multipath_localization
