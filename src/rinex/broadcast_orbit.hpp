#pragma once

#include <Eigen/Core>
#include <optional>

#include "rinex/gnss_time.hpp"
#include "rinex/satellite_id.hpp"

namespace multipath_localization {

constexpr double kRoundedEarthRotationRate = 7.292115e-5;  ///< as in BeiDou's and GLONASS's ICDs [rad/s]

/// A satellite at one instant.
struct SatelliteState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< ECEF of that instant [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< in that frame, as it turns [m/s]
  double clock = 0.0;        ///< satellite's - system's time, with the relativistic term [s]
  double clock_drift = 0.0;  ///< its rate [1]
};

/// Orbit and clock as GPS, Galileo, BeiDou and QZSS broadcast them; names as in IS-GPS-200, table 20-III.
struct BroadcastOrbit {
  SatelliteId satellite;
  bool healthy = true;
  GnssTime reference;          ///< t_oe
  double toe = 0.0;            ///< the same on the system's own scale [s of week]
  std::optional<double> sent;  ///< the message, so long after the reference [s]
  double root_axis = 0.0;      ///< sqrt(A) [m^0.5]
  double eccentricity = 0.0;
  double inclination = 0.0;                                          ///< i_0 [rad]
  double node = 0.0;                                                 ///< Omega_0 [rad]
  double perigee = 0.0;                                              ///< omega [rad]
  double mean_anomaly = 0.0;                                         ///< M_0 [rad]
  double mean_motion_difference = 0.0;                               ///< Delta n [rad/s]
  double node_rate = 0.0;                                            ///< [rad/s]
  double inclination_rate = 0.0;                                     ///< [rad/s]
  Eigen::Vector2d latitude_correction = Eigen::Vector2d::Zero();     ///< C_us, C_uc [rad]
  Eigen::Vector2d radius_correction = Eigen::Vector2d::Zero();       ///< C_rs, C_rc [m]
  Eigen::Vector2d inclination_correction = Eigen::Vector2d::Zero();  ///< C_is, C_ic [rad]

  GnssTime clock_reference;                                    ///< t_oc
  Eigen::Vector3d clock_polynomial = Eigen::Vector3d::Zero();  ///< [s, 1, 1/s]
  double group_delay = 0.0;  ///< T_GD, BGD: L1, E1 and B1I leave this much later than `clock` says [s]
};

/// Whether a satellite may broadcast that: eccentricity up to 0.5, clock within 0.1 s, 1e-6, 1e-12 1/s, its
/// reference within a day of the orbit's. Times worked out with what is not may be anything.
bool possible(const BroadcastOrbit& orbit);

/// Satellites of BeiDou that stand over the equator: their orbit is broadcast in another frame.
bool geostationary(const SatelliteId& satellite);

/// IS-GPS-200, 20.3.3.3.3.1 and table 20-IV, of QZSS and Galileo likewise; BeiDou's ICD, 5.2.4.12, of the
/// geostationary ones too. Metres off within the window of the ephemeris, and nonsense far outside of it.
SatelliteState satellite_state(const BroadcastOrbit& orbit, const GnssTime& time);

}  // namespace multipath_localization
