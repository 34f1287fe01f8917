#include "rinex/broadcast_orbit.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

namespace {

constexpr double kGeostationaryTilt = 5.0 * kPi / 180.0;

using Eigen::AngleAxisd;
using Eigen::Vector3d;

double gravitation(Constellation constellation) {
  const bool as_gps = constellation == Constellation::kGps || constellation == Constellation::kQzss;
  return as_gps ? 3.986005e14 : kEarthGravitation;
}

double rotation_rate(Constellation constellation) {
  return constellation == Constellation::kBeidou ? kRoundedEarthRotationRate : kEarthRotationRate;
}

double eccentric_anomaly(double mean_anomaly, double eccentricity) {
  constexpr int kIterations = 20;
  double E = mean_anomaly;
  for (int i = 0; i < kIterations; ++i) {
    const double step = (E - eccentricity * std::sin(E) - mean_anomaly) / (1.0 - eccentricity * std::cos(E));
    E -= step;
    if (std::abs(step) < 1e-14) break;
  }
  return E;
}

/// A quantity and its rate.
struct Moving {
  double value;
  double rate;
};

/// `base` with a correction that goes round twice a turn, of the argument of latitude `phi`.
Moving corrected(const Moving& base, const Eigen::Vector2d& sine_cosine, const Moving& phi) {
  const Eigen::Vector2d turning(std::sin(2.0 * phi.value), std::cos(2.0 * phi.value));
  const Eigen::Vector2d rate(turning.y(), -turning.x());
  return {base.value + sine_cosine.dot(turning), base.rate + 2.0 * phi.rate * sine_cosine.dot(rate)};
}

/// Where the satellite is in its ellipse.
struct Anomaly {
  double sine;
  double cosine;
  double rate;
};

Anomaly anomaly_at(const BroadcastOrbit& orbit, double time) {
  const double axis = orbit.root_axis * orbit.root_axis;
  const double n =
      std::sqrt(gravitation(orbit.satellite.constellation) / axis) / axis + orbit.mean_motion_difference;
  const double E = eccentric_anomaly(orbit.mean_anomaly + n * time, orbit.eccentricity);
  return {std::sin(E), std::cos(E), n / (1.0 - orbit.eccentricity * std::cos(E))};
}

/// Turns the plane of the orbit, x to the ascending node, about the Earth's axis and its line of nodes.
void place(const BroadcastOrbit& orbit, const Anomaly& E, double time, SatelliteState& state) {
  const double e = orbit.eccentricity;
  const double axis = orbit.root_axis * orbit.root_axis;
  const double root = std::sqrt(1.0 - e * e);
  const double nearness = 1.0 - e * E.cosine;
  const Moving phi = {std::atan2(root * E.sine, E.cosine - e) + orbit.perigee, root * E.rate / nearness};
  const Moving u = corrected(phi, orbit.latitude_correction, phi);
  const Moving r = corrected({axis * nearness, axis * e * E.sine * E.rate}, orbit.radius_correction, phi);
  const Moving i = corrected({orbit.inclination + orbit.inclination_rate * time, orbit.inclination_rate},
                             orbit.inclination_correction, phi);

  const bool fixed = geostationary(orbit.satellite);
  const double earth_rate = rotation_rate(orbit.satellite.constellation);
  const double node_rate = orbit.node_rate - (fixed ? 0.0 : earth_rate);
  const double node = orbit.node + node_rate * time - earth_rate * orbit.toe;
  const AngleAxisd by_node(node, Vector3d::UnitZ());
  const Eigen::Matrix3d turn = (by_node * AngleAxisd(i.value, Vector3d::UnitX())).toRotationMatrix();
  const Vector3d along(std::cos(u.value), std::sin(u.value), 0.0);
  const Vector3d across(-along.y(), along.x(), 0.0);
  const Vector3d spin = node_rate * Vector3d::UnitZ() + i.rate * (by_node * Vector3d::UnitX());
  state.position = turn * (r.value * along);
  state.velocity = turn * (r.rate * along + r.value * u.rate * across) + spin.cross(state.position);
  if (!fixed) return;
  const AngleAxisd by_earth(-earth_rate * time, Vector3d::UnitZ());
  const Eigen::Matrix3d upright =
      (by_earth * AngleAxisd(kGeostationaryTilt, Vector3d::UnitX())).toRotationMatrix();
  state.position = upright * state.position;
  state.velocity = upright * state.velocity - earth_rate * Vector3d::UnitZ().cross(state.position);
}

bool within(double value, double low, double high) { return value >= low && value <= high; }

bool possible_clock(const BroadcastOrbit& orbit) {
  const Vector3d& a = orbit.clock_polynomial;
  return std::abs(a(0)) < 0.1 && std::abs(a(1)) < 1e-6 && std::abs(a(2)) < 1e-12 &&
         std::abs(orbit.group_delay) < 1e-3 &&
         std::abs(orbit.reference - orbit.clock_reference) <= kSecondsOfDay;
}

}  // namespace

bool possible(const BroadcastOrbit& orbit) {
  return within(orbit.eccentricity, 0.0, 0.5) && within(orbit.root_axis, 4000.0, 8000.0) &&
         within(orbit.toe, 0.0, kSecondsOfWeek) && std::abs(orbit.mean_motion_difference) < 1e-3 &&
         possible_clock(orbit);
}

bool geostationary(const SatelliteId& satellite) {
  return satellite.constellation == Constellation::kBeidou &&
         (satellite.number <= 5 || satellite.number >= 59);
}

SatelliteState satellite_state(const BroadcastOrbit& orbit, const GnssTime& time) {
  const double since_toe = time - orbit.reference;
  const Anomaly E = anomaly_at(orbit, since_toe);
  SatelliteState state;
  place(orbit, E, since_toe, state);

  const double since_toc = time - orbit.clock_reference;
  const Vector3d& a = orbit.clock_polynomial;
  const double relativity = -2.0 * std::sqrt(gravitation(orbit.satellite.constellation)) *
                            orbit.eccentricity * orbit.root_axis / (kSpeedOfLight * kSpeedOfLight);
  state.clock = a(0) + a(1) * since_toc + a(2) * since_toc * since_toc + relativity * E.sine;
  state.clock_drift = a(1) + 2.0 * a(2) * since_toc + relativity * E.cosine * E.rate;
  return state;
}

}  // namespace multipath_localization
