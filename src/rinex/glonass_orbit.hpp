#pragma once

#include <Eigen/Core>

#include "rinex/broadcast_orbit.hpp"

namespace multipath_localization {

/// Orbit and clock as GLONASS broadcasts them: where the satellite is at one instant and what pulls at it.
/// ECEF PZ-90, which is taken for WGS-84: they are centimetres apart.
struct GlonassOrbit {
  SatelliteId satellite;
  bool healthy = true;
  GnssTime reference;                                      ///< t_b
  std::optional<double> sent;                              ///< the message, so long after t_b [s]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< [m/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< of Sun and Moon alone [m/s^2]
  double clock = 0.0;                                      ///< -tau_n [s]
  double clock_drift = 0.0;                                ///< gamma_n [1]
  int channel = 0;                                         ///< k: L1 is at 1602 MHz + k 562.5 kHz
};

/// Whether a satellite may broadcast that: 20 000 to 30 000 km from the Earth's centre, clock within 0.1 s
/// and 1e-6, channel -7 to 13.
bool possible(const GlonassOrbit& orbit);

/// By the equations of motion in GLONASS's ICD 5.1, appendix A.3.1.2, integrated by Runge-Kutta of the fourth
/// order in steps of at most a minute. For use within half an hour of the reference.
SatelliteState satellite_state(const GlonassOrbit& orbit, const GnssTime& time);

}  // namespace multipath_localization
